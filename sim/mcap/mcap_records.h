// The records of an MCAP file (format version 0, mcap.dev/spec). All numbers are little-endian; a
// text stands behind its length, a list or map behind its length in bytes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace dockyard {

/// First and last bytes of a file.
inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

/// What a record holds: its first byte. A record is this byte, a length of 8 bytes, the content.
enum class McapOp : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};
/// Kinds from here on are other programs' own.
inline constexpr std::uint8_t kFirstPrivateOp = 0x80;
/// Instead of a check value: "not available", which many writers leave.
inline constexpr std::uint32_t kNoCheckValue = 0;
inline constexpr std::size_t kMcapRecordHead = 1 + sizeof(std::uint64_t);

using McapTexts = std::map<std::string, std::string>;

struct McapSchema {
  std::uint16_t id = 0;  // from 1
  std::string name, encoding, data;

  bool operator==(const McapSchema&) const = default;
};

struct McapChannel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;
  std::string topic, message_encoding;
  McapTexts metadata;

  bool operator==(const McapChannel&) const = default;
};

/// Times are nanoseconds; a run's log has simulated time since power-on.
struct McapMessage {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0, publish_time_ns = 0;
  std::string_view data;
};

struct McapAttachment {
  std::uint64_t log_time_ns = 0, create_time_ns = 0;
  std::string name, media_type, data;
  bool guarded = true;  // has a check value; ours have

  bool operator==(const McapAttachment&) const = default;
};

struct McapMetadata {
  std::string name;
  McapTexts texts;

  bool operator==(const McapMetadata&) const = default;
};

/// Behind its length of 4 bytes.
void PutText(std::string& out, std::string_view text);
void PutTexts(std::string& out, const McapTexts& texts);
/// The bytes of one whole record.
std::string McapRecord(McapOp op, std::string_view content);
std::string McapContent(const McapSchema& schema);
std::string McapContent(const McapChannel& channel);
std::string McapContent(const McapMessage& message);
/// With its own check value.
std::string McapContent(const McapAttachment& attachment);
std::string McapContent(const McapMetadata& metadata);

/// Back from the content; throw DataError, also for bytes left over. The message's data point into
/// the content.
McapSchema SchemaFrom(std::string_view content);
McapChannel ChannelFrom(std::string_view content);
McapMessage MessageFrom(std::string_view content);
McapAttachment AttachmentFrom(std::string_view content);
McapMetadata MetadataFrom(std::string_view content);

}  // namespace dockyard
