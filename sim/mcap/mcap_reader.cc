#include "sim/mcap/mcap_reader.h"

#include <utility>

#include "sim/base/bytes.h"
#include "sim/base/crc32.h"

namespace dockyard {
namespace {

constexpr std::size_t kCheck = sizeof(std::uint32_t);

McapOp OpOf(std::uint8_t byte) {
  const bool is_private = byte >= kFirstPrivateOp;
  if (!is_private && (byte < static_cast<std::uint8_t>(McapOp::kHeader) ||
                      byte > static_cast<std::uint8_t>(McapOp::kDataEnd))) {
    throw DataError("a record is of unknown kind " + std::to_string(byte));
  }
  return static_cast<McapOp>(byte);
}

bool IsPrivate(McapOp op) { return static_cast<std::uint8_t>(op) >= kFirstPrivateOp; }

}  // namespace

Descriptor OpenLog(const Folder& folder, const std::filesystem::path& name) {
  auto file = folder.Open(name, kMostLogBytes);
  if (file) return std::move(*file);
  throw IoError("cannot read " + (folder.path() / name).string() + ": No such file or directory");
}

McapReader::McapReader(const std::filesystem::path& file)
    : McapReader(OpenLog(file.has_parent_path() ? file.parent_path() : ".", file.filename()),
                 file) {}

McapReader::McapReader(Descriptor file, const std::filesystem::path& path)
    : path_(path), size_(SizeOf(file, path)), file_(::fdopen(file.value(), "rb"), std::fclose) {
  if (!file_) throw IoErrorFromErrno("read", path_);
  file.Release();
  std::string magic(kMcapMagic.size(), '\0');
  if (!Fill(magic) || magic != kMcapMagic) {
    throw DataError("it is no MCAP file");
  }
  at_ = magic.size();
  crc_ = Crc32(magic);
  McapOp op;
  if (!ReadRecord(op) || op != McapOp::kHeader) throw DataError("its header is missing");
  ByteReader in(content_);
  profile_ = std::string(in.Take(in.U32()));
  in.Take(in.U32());  // the library that wrote it
  whole_ = at_;
}

bool McapReader::Fill(std::string& bytes) {
  return std::fread(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
}

bool McapReader::ReadRecord(McapOp& op) {
  std::string head(kMcapRecordHead, '\0');
  if (size_ - at_ < head.size()) return false;
  if (!Fill(head)) return false;
  ByteReader in(head);
  op = OpOf(in.U8());
  const std::uint64_t length = in.U64();
  if (length > size_ - at_ - head.size()) return false;
  content_.resize(length);
  if (!Fill(content_)) return false;
  at_ += head.size() + length;
  // What ends the data holds their check value, so it is not part of them.
  if (op != McapOp::kDataEnd) crc_ = Crc32(content_, Crc32(head, crc_));
  return true;
}

std::optional<McapMessage> McapReader::Next() {
  while (!ended_) {
    while (next_ < records_.size()) {
      ByteReader in(std::string_view(records_).substr(next_));
      const McapOp op = OpOf(in.U8());
      const std::string_view content = in.Take(in.U64());
      const std::size_t at = next_;
      next_ += kMcapRecordHead + content.size();
      TakeInner(op, content, at);
      if (found_) return std::exchange(found_, std::nullopt);
    }
    McapOp op;
    if (!ReadRecord(op)) {
      RequireCutShort();
      ended_ = true;
      break;
    }
    TakeRecord(op);
    if (!ended_) whole_ = at_;
    if (found_) return std::exchange(found_, std::nullopt);
  }
  return std::nullopt;
}

/// A file that has its last bytes was not cut short: then a length in it is damaged.
void McapReader::RequireCutShort() {
  std::string last(kMcapMagic.size(), '\0');
  std::fseek(file_.get(), -static_cast<long>(last.size()), SEEK_END);
  if (Fill(last) && last == kMcapMagic) {
    throw DataError("the length of a record is damaged");
  }
}

void McapReader::TakeRecord(McapOp op) {
  if (op == McapOp::kMessageIndex) {
    if (!chunk_) throw DataError("an index of messages belongs to no chunk");
    return;
  }
  CloseChunk();
  if (op == McapOp::kChunk) return TakeChunk();
  if (op == McapOp::kAttachment) {
    attachments_.push_back(AttachmentFrom(content_));
    parts_guarded_ = parts_guarded_ && attachments_.back().guarded;
    const std::uint64_t length = kMcapRecordHead + content_.size();
    summary_.Add(attachments_.back(), at_ - length, length);
  } else if (op == McapOp::kMetadata) {
    metadata_.push_back(MetadataFrom(content_));
    const std::uint64_t length = kMcapRecordHead + content_.size();
    summary_.Add(metadata_.back(), at_ - length, length);
  } else if (op == McapOp::kDataEnd) {
    TakeEnd();
  } else if (!IsPrivate(op)) {
    parts_guarded_ = false;  // it is in no chunk
    TakeInner(op, content_, 0);
  }
}

void McapReader::TakeChunk() {
  chunk_.emplace();
  bool guarded = false;
  records_ = RecordsOfChunk(content_, *chunk_, guarded);
  parts_guarded_ = parts_guarded_ && guarded;
  chunk_->length = kMcapRecordHead + content_.size();
  chunk_->offset = at_ - chunk_->length;
  next_ = 0;
}

void McapReader::TakeInner(McapOp op, std::string_view content, std::uint64_t at) {
  if (op == McapOp::kSchema) {
    const McapSchema schema = SchemaFrom(content);
    if (schemas_.emplace(schema.id, schema).second) summary_.Add(schema);
  } else if (op == McapOp::kChannel) {
    const McapChannel channel = ChannelFrom(content);
    if (channels_.emplace(channel.id, channel).second) summary_.Add(channel);
  } else if (op == McapOp::kMessage) {
    found_ = MessageFrom(content);
    if (!channels_.contains(found_->channel_id)) {
      throw DataError("a message is of unknown channel " + std::to_string(found_->channel_id));
    }
    if (chunk_) chunk_messages_[found_->channel_id].push_back({found_->log_time_ns, at});
    summary_.Add(*found_);
  } else if (!IsPrivate(op)) {
    throw DataError("a record of kind " + std::to_string(static_cast<int>(op)) +
                    " stands where none may");
  }
}

/// The data section ends: all that follows is checked as a whole.
void McapReader::TakeEnd() {
  ended_ = true;
  ByteReader data_end(content_);
  const std::uint32_t check = data_end.U32();
  data_guarded_ = check != kNoCheckValue;
  if ((data_guarded_ && check != crc_) || !data_end.AtEnd()) {
    throw DataError("its data do not have their check value");
  }
  std::string rest(size_ - at_, '\0');
  if (!Fill(rest)) return;
  constexpr std::size_t kFooter = kMcapRecordHead + 2 * sizeof(std::uint64_t) + kCheck;
  const bool cut_short = rest.size() < kFooter + kMcapMagic.size() || !rest.ends_with(kMcapMagic);
  if (cut_short) return;
  const std::size_t checked = rest.size() - kMcapMagic.size() - kCheck;
  ByteReader in(std::string_view(rest).substr(checked));
  const std::uint32_t of_summary = in.U32();
  if (of_summary != kNoCheckValue &&
      of_summary != Crc32(std::string_view(rest).substr(0, checked))) {
    throw DataError("its summary does not have its check value");
  }
  complete_ = true;
}

void McapReader::CloseChunk() {
  if (!chunk_) return;
  // The places of its indexes follow from its own, whatever they said.
  MessageIndexRecords(chunk_messages_, chunk_->offset + chunk_->length, *chunk_);
  summary_.Add(*chunk_);
  chunk_.reset();
  chunk_messages_.clear();
}

McapReader::Rest McapReader::WhatIsWhole() const {
  Rest rest{whole_, "", summary_};
  if (!chunk_) return rest;
  McapChunkIndex chunk = *chunk_;
  rest.keep = chunk.offset + chunk.length;  // its indexes may be cut: they are made again
  rest.add = MessageIndexRecords(chunk_messages_, rest.keep, chunk);
  rest.summary.Add(chunk);
  return rest;
}

}  // namespace dockyard
