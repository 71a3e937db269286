#include "sim/mcap/mcap_records.h"

#include "sim/base/bytes.h"
#include "sim/base/crc32.h"

namespace dockyard {
namespace {

std::string TakeText(ByteReader& in) { return std::string(in.Take(in.U32())); }

McapTexts TakeTexts(ByteReader& in) {
  ByteReader texts(in.Take(in.U32()));
  McapTexts map;
  while (!texts.AtEnd()) {
    std::string key = TakeText(texts);
    map[std::move(key)] = TakeText(texts);
  }
  return map;
}

void RequireEnd(const ByteReader& in) {
  if (!in.AtEnd()) throw DataError("a record is longer than its content");
}

}  // namespace

void PutText(std::string& out, std::string_view text) {
  PutU32(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

void PutTexts(std::string& out, const McapTexts& texts) {
  std::string bytes;
  for (const auto& [key, value] : texts) {
    PutText(bytes, key);
    PutText(bytes, value);
  }
  PutText(out, bytes);
}

std::string McapRecord(McapOp op, std::string_view content) {
  std::string record;
  record.reserve(kMcapRecordHead + content.size());
  PutU8(record, static_cast<std::uint8_t>(op));
  PutU64(record, content.size());
  record.append(content);
  return record;
}

std::string McapContent(const McapSchema& schema) {
  std::string out;
  PutU16(out, schema.id);
  for (const std::string* text : {&schema.name, &schema.encoding, &schema.data}) {
    PutText(out, *text);
  }
  return out;
}

std::string McapContent(const McapChannel& channel) {
  std::string out;
  PutU16(out, channel.id);
  PutU16(out, channel.schema_id);
  PutText(out, channel.topic);
  PutText(out, channel.message_encoding);
  PutTexts(out, channel.metadata);
  return out;
}

std::string McapContent(const McapMessage& message) {
  std::string out;
  out.reserve(22 + message.data.size());
  PutU16(out, message.channel_id);
  PutU32(out, message.sequence);
  PutU64(out, message.log_time_ns);
  PutU64(out, message.publish_time_ns);
  out.append(message.data);
  return out;
}

std::string McapContent(const McapAttachment& attachment) {
  std::string out;
  PutU64(out, attachment.log_time_ns);
  PutU64(out, attachment.create_time_ns);
  PutText(out, attachment.name);
  PutText(out, attachment.media_type);
  PutU64(out, attachment.data.size());
  out.append(attachment.data);
  PutU32(out, Crc32(out));
  return out;
}

std::string McapContent(const McapMetadata& metadata) {
  std::string out;
  PutText(out, metadata.name);
  PutTexts(out, metadata.texts);
  return out;
}

McapSchema SchemaFrom(std::string_view content) {
  ByteReader in(content);
  McapSchema schema;
  schema.id = in.U16();
  for (std::string* text : {&schema.name, &schema.encoding, &schema.data}) *text = TakeText(in);
  RequireEnd(in);
  return schema;
}

McapChannel ChannelFrom(std::string_view content) {
  ByteReader in(content);
  McapChannel channel;
  channel.id = in.U16();
  channel.schema_id = in.U16();
  channel.topic = TakeText(in);
  channel.message_encoding = TakeText(in);
  channel.metadata = TakeTexts(in);
  RequireEnd(in);
  return channel;
}

McapMessage MessageFrom(std::string_view content) {
  ByteReader in(content);
  McapMessage message;
  message.channel_id = in.U16();
  message.sequence = in.U32();
  message.log_time_ns = in.U64();
  message.publish_time_ns = in.U64();
  message.data = in.Take(in.left());
  return message;
}

McapAttachment AttachmentFrom(std::string_view content) {
  ByteReader in(content);
  McapAttachment attachment;
  attachment.log_time_ns = in.U64();
  attachment.create_time_ns = in.U64();
  attachment.name = TakeText(in);
  attachment.media_type = TakeText(in);
  attachment.data = std::string(in.Take(in.U64()));
  const std::uint32_t check = in.U32();
  RequireEnd(in);
  attachment.guarded = check != kNoCheckValue;
  if (attachment.guarded && check != Crc32(content.substr(0, content.size() - sizeof check))) {
    throw DataError("the attachment " + attachment.name + " does not have its check value");
  }
  return attachment;
}

McapMetadata MetadataFrom(std::string_view content) {
  ByteReader in(content);
  McapMetadata metadata;
  metadata.name = TakeText(in);
  metadata.texts = TakeTexts(in);
  RequireEnd(in);
  return metadata;
}

}  // namespace dockyard
