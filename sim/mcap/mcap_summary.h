// The end of an MCAP file: what is in it and where, gathered while its records go by.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/mcap/chunk.h"
#include "sim/mcap/mcap_records.h"

namespace dockyard {

class McapSummary {
 public:
  void Add(const McapSchema& schema) { schemas_.push_back(schema); }
  void Add(const McapChannel& channel) { channels_.push_back(channel); }
  void Add(const McapMessage& message);
  void Add(const McapChunkIndex& chunk) { chunks_.push_back(chunk); }
  /// @param offset, length  of the record in the file
  void Add(const McapAttachment& attachment, std::uint64_t offset, std::uint64_t length);
  void Add(const McapMetadata& metadata, std::uint64_t offset, std::uint64_t length);

  /// All that stands behind the data: summary, its offsets, footer, magic.
  /// @param begin  where it stands in the file
  std::string Bytes(std::uint64_t begin) const;

 private:
  struct Index {
    std::uint64_t offset = 0, length = 0;
    std::string content;  // behind offset and length
  };
  std::string Statistics() const;

  std::vector<McapSchema> schemas_;
  std::vector<McapChannel> channels_;
  std::vector<McapChunkIndex> chunks_;
  std::vector<Index> attachments_, metadata_;
  std::map<std::uint16_t, std::uint64_t> message_counts_;  // by channel
  std::uint64_t messages_ = 0, begin_ns_ = 0, end_ns_ = 0;
};

}  // namespace dockyard
