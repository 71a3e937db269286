// A chunk: records that are compressed together, with their check value.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dockyard {

/// Time and place of each message in a chunk's records, by channel.
using McapMessageIndex =
    std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>>;

/// What the summary says of a chunk.
struct McapChunkIndex {
  std::uint64_t begin_ns = 0, end_ns = 0;                  // of its messages
  std::uint64_t offset = 0, length = 0;                    // of its record in the file
  std::map<std::uint16_t, std::uint64_t> message_indexes;  // offsets in the file, by channel
  std::uint64_t message_index_length = 0;                  // of all of them
  std::string compression;
  std::uint64_t compressed_size = 0, size = 0;  // of the records
};

/// The content of a chunk's record, by Zstandard or as it is. Fills the index but for the places.
std::string MakeChunk(std::string_view records, bool compress, McapChunkIndex& index);

/// The records behind a chunk that say where its messages are; fills the index's places of them.
/// @param begin  where they stand in the file
std::string MessageIndexRecords(const McapMessageIndex& messages, std::uint64_t begin,
                                McapChunkIndex& index);

/// The records of a chunk, checked. Throws DataError: damaged, another compression than Zstandard,
/// LZ4 or none, more than kMostChunkBytes.
/// @param guarded  whether the chunk has a check value
std::string RecordsOfChunk(std::string_view content, McapChunkIndex& index, bool& guarded);

/// A second of the largest images of two cameras has 240 MB.
inline constexpr std::uint64_t kMostChunkBytes = std::uint64_t{512} << 20;

}  // namespace dockyard
