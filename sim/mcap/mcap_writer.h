// Writes an MCAP file while a run goes on. What stands before the last flush survives a kill -9: it
// is read back by McapReader and closed by RepairMcap.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "sim/mcap/chunk.h"
#include "sim/mcap/mcap_records.h"
#include "sim/mcap/mcap_summary.h"

namespace dockyard {

struct McapOptions {
  std::string profile, library;
  bool compress = true;
  // A chunk is shorter than that, and a kill costs no more.
  std::uint64_t chunk_ns = 1'000'000'000;
  // And at this size, which bounds the memory of writer and readers.
  std::size_t chunk_bytes = std::size_t{16} << 20;
};

/// All functions throw IoError, as when the disk is full.
class McapWriter {
 public:
  McapWriter(const std::filesystem::path& file, const McapOptions& options);
  /// A file without Finish reads as cut short, behind its last message if the disk allows.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Ids count from 1. A schema and a channel are written before the first message after them.
  std::uint16_t AddSchema(const std::string& name, const std::string& encoding,
                          const std::string& data);
  std::uint16_t AddChannel(std::uint16_t schema_id, const std::string& topic,
                           const std::string& message_encoding, const McapTexts& metadata = {});
  /// Times must not fall.
  void Write(const McapMessage& message);
  void Attach(const McapAttachment& attachment);
  void Add(const McapMetadata& metadata);
  /// Ends the chunk and hands all to the system.
  void Flush();
  /// Writes the summary and closes.
  void Finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void Put(std::string_view bytes);
  /// The whole record; returns where it stands.
  std::uint64_t PutRecord(McapOp op, std::string_view content);
  void EndChunk();

  std::filesystem::path path_;
  McapOptions options_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t size_ = 0;      // bytes written
  std::uint32_t data_crc_ = 0;  // of them
  std::uint16_t schemas_ = 0, channels_ = 0;
  std::string records_;     // of the chunk under way
  McapMessageIndex index_;  // of its messages
  std::uint64_t begin_ns_ = 0, end_ns_ = 0;
  McapSummary summary_;
};

}  // namespace dockyard
