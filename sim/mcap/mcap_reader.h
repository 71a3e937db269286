// Reads an MCAP file from its begin, message by message, and checks all of the check values that it
// has. A file without its end, as after a kill -9, gives the messages that are whole. Files of
// other writers are read, too: with chunks of any size or none, compressed or not, with or without
// indexes, summary and check values.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/folder.h"
#include "sim/mcap/chunk.h"
#include "sim/mcap/mcap_records.h"
#include "sim/mcap/mcap_summary.h"

namespace dockyard {

/// Of a file of this kind; assumed, 1 to 1000 GiB: a docking with all images takes under 0.1 GiB.
inline constexpr std::uint64_t kMostLogBytes = std::uint64_t{64} << 30;

/// Throws IoError, and UnsafeContent for what is no file there.
Descriptor OpenLog(const Folder& folder, const std::filesystem::path& name);

/// Throws IoError, and DataError for a damaged file and one that is none. Every byte of a file of
/// McapWriter counts: one that is changed is found, at the latest when Next comes to the end.
class McapReader {
 public:
  explicit McapReader(const std::filesystem::path& file);
  /// The path is for messages.
  McapReader(Descriptor file, const std::filesystem::path& path);

  /// None at the end. The data are good until the next call.
  std::optional<McapMessage> Next();
  /// After the last message: whether the file's end is there, or it was cut short.
  bool complete() const { return complete_; }
  /// After the last message: whether a check value covers every message and attachment.
  /// Without one a changed byte goes undetected.
  bool guarded() const { return data_guarded_ || parts_guarded_; }

  const std::string& profile() const { return profile_; }
  /// The channel of a message. Those seen so far are known.
  const McapChannel& channel(std::uint16_t id) const { return channels_.at(id); }
  const std::map<std::uint16_t, McapSchema>& schemas() const { return schemas_; }
  const std::map<std::uint16_t, McapChannel>& channels() const { return channels_; }
  const std::vector<McapAttachment>& attachments() const { return attachments_; }
  const std::vector<McapMetadata>& metadata() const { return metadata_; }

  /// What a repair needs of a file that was cut short: bytes to keep, those to put behind them, and
  /// the summary of both.
  struct Rest {
    std::uint64_t keep = 0;
    std::string add;
    McapSummary summary;
  };
  Rest WhatIsWhole() const;

 private:
  /// False at the end of the file, be it in the middle of a record.
  bool ReadRecord(McapOp& op);
  void TakeRecord(McapOp op);
  void TakeChunk();
  void TakeInner(McapOp op, std::string_view content, std::uint64_t at);
  void TakeEnd();
  void CloseChunk();
  void RequireCutShort();
  /// False where fewer bytes are left.
  bool Fill(std::string& bytes);

  std::filesystem::path path_;
  std::uint64_t size_ = 0, at_ = 0;  // bytes of the file, and of what was read
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint32_t crc_ = 0;             // of what was read
  std::string content_;               // of the record
  std::string records_;               // of the chunk
  std::size_t next_ = 0;              // the next of them
  std::optional<McapMessage> found_;  // by the record just taken
  bool complete_ = false, ended_ = false;
  bool data_guarded_ = false, parts_guarded_ = true;  // as a whole; each chunk and attachment
  std::string profile_;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::vector<McapAttachment> attachments_;
  std::vector<McapMetadata> metadata_;

  McapSummary summary_;                  // but for the last chunk
  std::uint64_t whole_ = 0;              // end of the last record
  std::optional<McapChunkIndex> chunk_;  // the last one, until another record than its indexes
  McapMessageIndex chunk_messages_;
};

}  // namespace dockyard
