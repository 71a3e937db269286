#include "support/foreign_log.h"

#include <lz4frame.h>
#include <zstd.h>

#include <stdexcept>
#include <string>

#include "sim/base/bytes.h"
#include "sim/base/crc32.h"
#include "sim/base/files.h"
#include "sim/mcap/mcap_reader.h"

namespace dockyard {
namespace {

std::string Lz4(const std::string& bytes) {
  std::string out(::LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size =
      ::LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr);
  if (::LZ4F_isError(size)) throw std::runtime_error("no LZ4");
  out.resize(size);
  return out;
}

std::string Zstd(const std::string& bytes, bool with_size) {
  ZSTD_CCtx* context = ::ZSTD_createCCtx();
  ::ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, with_size ? 1 : 0);
  std::string out(::ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ::ZSTD_compress2(context, out.data(), out.size(), bytes.data(), bytes.size());
  ::ZSTD_freeCCtx(context);
  if (::ZSTD_isError(size)) throw std::runtime_error("no Zstandard");
  out.resize(size);
  return out;
}

class ForeignWriter {
 public:
  explicit ForeignWriter(const ForeignWriting& how) : how_(how), bytes_(kMcapMagic) {}

  void Header(const std::string& profile) {
    std::string header;
    PutText(header, profile);
    PutText(header, "another writer");
    bytes_ += McapRecord(McapOp::kHeader, header);
  }
  void Put(McapOp op, const std::string& content) {
    if (how_.chunk_bytes == 0) {
      bytes_ += McapRecord(op, content);
    } else {
      records_ += McapRecord(op, content);
      if (how_.private_records) records_ += McapRecord(static_cast<McapOp>(0x91), "in a chunk");
    }
    if (records_.size() >= how_.chunk_bytes) EndChunk();
  }
  void Message(const McapMessage& message) {
    if (how_.chunk_bytes > 0) {
      index_[message.channel_id].push_back({message.log_time_ns, records_.size()});
    }
    Put(McapOp::kMessage, McapContent(message));
  }
  void EndChunk() {
    if (records_.empty()) return;
    static const char* const names[] = {"", "zstd", "zstd", "lz4"};
    std::string packed = records_;
    if (how_.compression == ForeignCompression::kLz4) packed = Lz4(records_);
    if (how_.compression == ForeignCompression::kZstd) packed = Zstd(records_, true);
    if (how_.compression == ForeignCompression::kZstdWithoutSize) packed = Zstd(records_, false);
    std::string content;
    PutU64(content, 0);  // times of its messages: not read
    PutU64(content, 0);
    PutU64(content, records_.size());
    PutU32(content, how_.check_values ? Crc32(records_) : 0);
    PutText(content, names[static_cast<std::size_t>(how_.compression)]);
    PutU64(content, packed.size());
    bytes_ += McapRecord(McapOp::kChunk, content + packed);
    McapChunkIndex chunk;
    if (how_.message_indexes) bytes_ += MessageIndexRecords(index_, bytes_.size(), chunk);
    if (how_.private_records) bytes_ += McapRecord(static_cast<McapOp>(0xF0), "between chunks");
    records_.clear();
    index_.clear();
  }
  void Attach(const McapAttachment& attachment) {
    std::string content = McapContent(attachment);
    if (!how_.check_values) content.replace(content.size() - 4, 4, std::string(4, '\0'));
    bytes_ += McapRecord(McapOp::kAttachment, content);
  }
  std::string Finish(const McapReader& reader) {
    EndChunk();
    std::string data_end;
    PutU32(data_end, how_.check_values ? Crc32(bytes_) : 0);
    bytes_ += McapRecord(McapOp::kDataEnd, data_end);
    McapSummary summary;
    if (how_.summary) {
      for (const auto& [id, schema] : reader.schemas()) summary.Add(schema);
      for (const auto& [id, channel] : reader.channels()) summary.Add(channel);
    }
    std::string end = summary.Bytes(bytes_.size());
    if (!how_.summary) {
      end = McapRecord(McapOp::kFooter, std::string(20, '\0'));
      end += kMcapMagic;
    }
    if (!how_.check_values) {
      end.replace(end.size() - kMcapMagic.size() - 4, 4, std::string(4, '\0'));
    } else if (!how_.summary) {
      std::string crc;
      PutU32(crc, Crc32(end.substr(0, end.size() - kMcapMagic.size() - 4)));
      end.replace(end.size() - kMcapMagic.size() - 4, 4, crc);
    }
    return bytes_ + end;
  }

 private:
  const ForeignWriting& how_;
  std::string bytes_, records_;
  McapMessageIndex index_;
};

}  // namespace

void RewriteForeign(const std::filesystem::path& from, const std::filesystem::path& to,
                    const ForeignWriting& writing) {
  McapReader whole(from);
  while (whole.Next()) {
  }
  ForeignWriter writer(writing);
  writer.Header(whole.profile());
  const auto attach = [&] {
    for (const McapAttachment& each : whole.attachments()) writer.Attach(each);
  };
  if (!writing.attachments_last) attach();
  for (const auto& [id, schema] : whole.schemas()) writer.Put(McapOp::kSchema, McapContent(schema));
  for (const auto& [id, channel] : whole.channels()) {
    writer.Put(McapOp::kChannel, McapContent(channel));
  }
  McapReader again(from);
  while (const auto message = again.Next()) writer.Message(*message);
  writer.EndChunk();
  if (writing.attachments_last) attach();
  WriteWhole(to, writer.Finish(whole));
}

}  // namespace dockyard
