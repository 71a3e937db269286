#include "support/edited_log.h"

#include <vector>

#include "sim/base/bytes.h"
#include "sim/base/crc32.h"
#include "sim/mcap/mcap_reader.h"

namespace dockyard {
namespace {

struct Kept {
  McapMessage message;
  std::string data;
};

void PutCrc(std::string& bytes, std::size_t at, std::uint32_t crc) {
  std::string value;
  PutU32(value, crc);
  bytes.replace(at, value.size(), value);
}

/// Of a chunk that is not compressed; `at` is where its content stands.
void MendChunk(std::string& log, std::size_t at, std::size_t length) {
  constexpr std::size_t kCrc = 24, kRecords = kCrc + 4 + 4 + 8;  // behind an empty compression
  if (length < kRecords || log.substr(at + kCrc + 4, 4) != std::string(4, '\0')) return;
  PutCrc(log, at + kCrc, Crc32(std::string_view(log).substr(at + kRecords, length - kRecords)));
}

/// Of the summary, whose footer ends the file.
void MendSummary(std::string& log, std::size_t begin) {
  const std::size_t behind = 4 + kMcapMagic.size();
  if (log.size() < begin + behind) return;
  const std::size_t at = log.size() - behind;
  PutCrc(log, at, Crc32(std::string_view(log).substr(begin, at - begin)));
}

}  // namespace

std::string WithCheckValues(std::string log) {
  std::size_t at = kMcapMagic.size();
  while (at + kMcapRecordHead <= log.size()) {
    ByteReader head(std::string_view(log).substr(at));
    const std::uint8_t op = head.U8();
    const std::uint64_t length = head.U64();
    const std::size_t content = at + kMcapRecordHead;
    if (length > log.size() - content) break;
    if (op == static_cast<std::uint8_t>(McapOp::kChunk)) MendChunk(log, content, length);
    if (op == static_cast<std::uint8_t>(McapOp::kAttachment) && length >= 4) {
      const std::size_t crc = content + length - 4;
      PutCrc(log, crc, Crc32(std::string_view(log).substr(content, length - 4)));
    }
    if (op == static_cast<std::uint8_t>(McapOp::kDataEnd) && length == 4) {
      PutCrc(log, content, Crc32(std::string_view(log).substr(0, at)));
      MendSummary(log, content + length);
      break;
    }
    at = content + length;
  }
  return log;
}

void EditLog(const std::filesystem::path& file,
             const std::function<void(McapAttachment&)>& attachment, bool compress) {
  McapReader reader(file);
  std::vector<Kept> kept;
  while (const auto read = reader.Next()) kept.push_back({*read, std::string(read->data)});
  McapWriter writer(file, {.profile = reader.profile(), .library = "test", .compress = compress});
  for (McapAttachment each : reader.attachments()) {
    attachment(each);
    writer.Attach(each);
  }
  for (const auto& [id, schema] : reader.schemas()) {
    writer.AddSchema(schema.name, schema.encoding, schema.data);
  }
  for (const auto& [id, channel] : reader.channels()) {
    writer.AddChannel(channel.schema_id, channel.topic, channel.message_encoding, channel.metadata);
  }
  for (Kept& each : kept) {
    each.message.data = each.data;
    writer.Write(each.message);
  }
  writer.Finish();
}

}  // namespace dockyard
