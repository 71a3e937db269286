#include "sim/mcap/mcap_summary.h"

#include <algorithm>

#include "sim/base/bytes.h"
#include "sim/base/crc32.h"

namespace dockyard {
namespace {

/// A map from channels to numbers, behind its length in bytes.
void PutByChannel(std::string& out, const std::map<std::uint16_t, std::uint64_t>& map) {
  std::string bytes;
  for (const auto& [channel, value] : map) {
    PutU16(bytes, channel);
    PutU64(bytes, value);
  }
  PutText(out, bytes);
}

std::string Content(const McapChunkIndex& chunk) {
  std::string out;
  PutU64(out, chunk.begin_ns);
  PutU64(out, chunk.end_ns);
  PutU64(out, chunk.offset);
  PutU64(out, chunk.length);
  PutByChannel(out, chunk.message_indexes);
  PutU64(out, chunk.message_index_length);
  PutText(out, chunk.compression);
  PutU64(out, chunk.compressed_size);
  PutU64(out, chunk.size);
  return out;
}

}  // namespace

void McapSummary::Add(const McapMessage& message) {
  const std::uint64_t time = message.log_time_ns;
  begin_ns_ = messages_ == 0 ? time : std::min(begin_ns_, time);
  end_ns_ = std::max(end_ns_, time);
  ++messages_;
  ++message_counts_[message.channel_id];
}

void McapSummary::Add(const McapAttachment& attachment, std::uint64_t offset,
                      std::uint64_t length) {
  std::string content;
  PutU64(content, attachment.log_time_ns);
  PutU64(content, attachment.create_time_ns);
  PutU64(content, attachment.data.size());
  PutText(content, attachment.name);
  PutText(content, attachment.media_type);
  attachments_.push_back({offset, length, content});
}

void McapSummary::Add(const McapMetadata& metadata, std::uint64_t offset, std::uint64_t length) {
  std::string content;
  PutText(content, metadata.name);
  metadata_.push_back({offset, length, content});
}

std::string McapSummary::Statistics() const {
  std::string out;
  PutU64(out, messages_);
  PutU16(out, static_cast<std::uint16_t>(schemas_.size()));
  PutU32(out, static_cast<std::uint32_t>(channels_.size()));
  PutU32(out, static_cast<std::uint32_t>(attachments_.size()));
  PutU32(out, static_cast<std::uint32_t>(metadata_.size()));
  PutU32(out, static_cast<std::uint32_t>(chunks_.size()));
  PutU64(out, begin_ns_);
  PutU64(out, end_ns_);
  PutByChannel(out, message_counts_);
  return out;
}

std::string McapSummary::Bytes(std::uint64_t begin) const {
  std::string summary, offsets;
  const auto add_group = [&](McapOp op, const std::string& records) {
    if (records.empty()) return;
    std::string offset;
    PutU8(offset, static_cast<std::uint8_t>(op));
    PutU64(offset, begin + summary.size());
    PutU64(offset, records.size());
    offsets += McapRecord(McapOp::kSummaryOffset, offset);
    summary += records;
  };
  const auto records = [](McapOp op, const auto& items, const auto& content) {
    std::string bytes;
    for (const auto& item : items) bytes += McapRecord(op, content(item));
    return bytes;
  };
  const auto itself = [](const auto& item) { return McapContent(item); };
  const auto placed = [](const Index& index) {
    std::string out;
    PutU64(out, index.offset);
    PutU64(out, index.length);
    return out + index.content;
  };
  add_group(McapOp::kSchema, records(McapOp::kSchema, schemas_, itself));
  add_group(McapOp::kChannel, records(McapOp::kChannel, channels_, itself));
  add_group(McapOp::kStatistics, McapRecord(McapOp::kStatistics, Statistics()));
  add_group(McapOp::kChunkIndex,
            records(McapOp::kChunkIndex, chunks_,
                    [](const McapChunkIndex& chunk) { return Content(chunk); }));
  add_group(McapOp::kAttachmentIndex, records(McapOp::kAttachmentIndex, attachments_, placed));
  add_group(McapOp::kMetadataIndex, records(McapOp::kMetadataIndex, metadata_, placed));

  std::string footer;
  PutU64(footer, begin);
  PutU64(footer, begin + summary.size());
  constexpr std::size_t kCheck = sizeof(std::uint32_t);
  // The check value covers the footer's record up to itself.
  const std::string framed = McapRecord(McapOp::kFooter, footer + std::string(kCheck, '\0'));
  std::string end = summary + offsets + framed.substr(0, framed.size() - kCheck);
  PutU32(end, Crc32(end));
  return end.append(kMcapMagic);
}

}  // namespace dockyard
