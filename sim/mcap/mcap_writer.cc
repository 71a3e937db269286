#include "sim/mcap/mcap_writer.h"

#include "controller/base/check.h"
#include "sim/base/bytes.h"
#include "sim/base/crc32.h"
#include "sim/base/files.h"

namespace dockyard {

McapWriter::McapWriter(const std::filesystem::path& file, const McapOptions& options)
    : path_(file), options_(options) {
  // What is there is removed: through a link or a pipe the log would end elsewhere.
  std::error_code ignored;
  if (!std::filesystem::is_directory(file, ignored)) std::filesystem::remove(file, ignored);
  file_.reset(std::fopen(file.c_str(), "wbxe"));
  if (!file_) throw IoErrorFromErrno("write", path_);
  Put(kMcapMagic);
  std::string header;
  PutText(header, options.profile);
  PutText(header, options.library);
  PutRecord(McapOp::kHeader, header);
}

McapWriter::~McapWriter() {
  if (!file_) return;
  try {
    Flush();
  } catch (const IoError&) {  // whoever writes has been told before
  }
}

void McapWriter::Put(std::string_view bytes) {
  DOCKYARD_CHECK(file_ != nullptr);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) {
    throw IoErrorFromErrno("write", path_);
  }
  data_crc_ = Crc32(bytes, data_crc_);
  size_ += bytes.size();
}

std::uint64_t McapWriter::PutRecord(McapOp op, std::string_view content) {
  const std::uint64_t at = size_;
  Put(McapRecord(op, content));
  return at;
}

std::uint16_t McapWriter::AddSchema(const std::string& name, const std::string& encoding,
                                    const std::string& data) {
  const McapSchema schema{++schemas_, name, encoding, data};
  records_ += McapRecord(McapOp::kSchema, McapContent(schema));
  summary_.Add(schema);
  return schema.id;
}

std::uint16_t McapWriter::AddChannel(std::uint16_t schema_id, const std::string& topic,
                                     const std::string& message_encoding,
                                     const McapTexts& metadata) {
  const McapChannel channel{++channels_, schema_id, topic, message_encoding, metadata};
  records_ += McapRecord(McapOp::kChannel, McapContent(channel));
  summary_.Add(channel);
  return channel.id;
}

void McapWriter::Write(const McapMessage& message) {
  DOCKYARD_CHECK(message.channel_id >= 1 && message.channel_id <= channels_);
  const std::uint64_t time = message.log_time_ns;
  const bool long_enough = !index_.empty() && time >= begin_ns_ + options_.chunk_ns;
  if (long_enough || records_.size() >= options_.chunk_bytes) Flush();
  if (index_.empty()) begin_ns_ = time;
  end_ns_ = time;
  index_[message.channel_id].push_back({time, records_.size()});
  records_ += McapRecord(McapOp::kMessage, McapContent(message));
  summary_.Add(message);
}

void McapWriter::Attach(const McapAttachment& attachment) {
  EndChunk();
  const std::uint64_t at = PutRecord(McapOp::kAttachment, McapContent(attachment));
  summary_.Add(attachment, at, size_ - at);
}

void McapWriter::Add(const McapMetadata& metadata) {
  EndChunk();
  const std::uint64_t at = PutRecord(McapOp::kMetadata, McapContent(metadata));
  summary_.Add(metadata, at, size_ - at);
}

void McapWriter::EndChunk() {
  if (records_.empty()) return;
  McapChunkIndex chunk;
  if (!index_.empty()) {
    chunk.begin_ns = begin_ns_;
    chunk.end_ns = end_ns_;
  }
  const std::string content = MakeChunk(records_, options_.compress, chunk);
  chunk.offset = PutRecord(McapOp::kChunk, content);
  chunk.length = size_ - chunk.offset;
  Put(MessageIndexRecords(index_, size_, chunk));
  summary_.Add(chunk);
  records_.clear();
  index_.clear();
}

void McapWriter::Flush() {
  EndChunk();
  if (std::fflush(file_.get()) != 0) throw IoErrorFromErrno("write", path_);
}

void McapWriter::Finish() {
  EndChunk();
  std::string data_end;
  PutU32(data_end, data_crc_);
  PutRecord(McapOp::kDataEnd, data_end);
  Put(summary_.Bytes(size_));
  if (std::fclose(file_.release()) != 0) throw IoErrorFromErrno("write", path_);
}

}  // namespace dockyard
