#include "sim/mcap/chunk.h"

#include <zstd.h>

#include "controller/base/check.h"
#include "sim/base/bytes.h"
#include "sim/base/crc32.h"
#include "sim/mcap/mcap_records.h"

namespace dockyard {
namespace {

constexpr int kLevel = 3;  // Zstandard's own choice between size and speed
constexpr const char* kZstd = "zstd";

std::string Compressed(std::string_view bytes) {
  std::string out(::ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ::ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  DOCKYARD_CHECK(!::ZSTD_isError(size));
  out.resize(size);
  return out;
}

std::string Decompressed(std::string_view bytes, std::uint64_t size) {
  // The frame says its size too: a small one must not make us take much memory.
  if (::ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != size) {
    throw DataError("a chunk has another size than it says");
  }
  std::string out(size, '\0');
  const std::size_t got = ::ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  if (::ZSTD_isError(got) || got != size) throw DataError("a chunk cannot be decompressed");
  return out;
}

}  // namespace

std::string MakeChunk(std::string_view records, bool compress, McapChunkIndex& index) {
  const std::string packed = compress ? Compressed(records) : std::string();
  const std::string_view bytes = compress ? std::string_view(packed) : records;
  index.compression = compress ? kZstd : "";
  index.size = records.size();
  index.compressed_size = bytes.size();
  std::string out;
  PutU64(out, index.begin_ns);
  PutU64(out, index.end_ns);
  PutU64(out, records.size());
  PutU32(out, Crc32(records));
  PutText(out, index.compression);
  PutU64(out, bytes.size());
  out.append(bytes);
  return out;
}

std::string MessageIndexRecords(const McapMessageIndex& messages, std::uint64_t begin,
                                McapChunkIndex& index) {
  std::string records;
  for (const auto& [channel, places] : messages) {
    std::string entries, content;
    for (const auto& [time, place] : places) {
      PutU64(entries, time);
      PutU64(entries, place);
    }
    PutU16(content, channel);
    PutText(content, entries);
    index.message_indexes[channel] = begin + records.size();
    records += McapRecord(McapOp::kMessageIndex, content);
  }
  index.message_index_length = records.size();
  return records;
}

std::string RecordsOfChunk(std::string_view content, McapChunkIndex& index) {
  ByteReader in(content);
  index.begin_ns = in.U64();
  index.end_ns = in.U64();
  index.size = in.U64();
  const std::uint32_t check = in.U32();
  index.compression = std::string(in.Take(in.U32()));
  index.compressed_size = in.U64();
  const std::string_view bytes = in.Take(index.compressed_size);
  if (!in.AtEnd()) throw DataError("a chunk is longer than its content");
  if (index.size > kMostChunkBytes) throw DataError("a chunk is impossibly large");
  if (!index.compression.empty() && index.compression != kZstd) {
    throw DataError("a chunk is compressed by '" + index.compression + "', expected zstd");
  }
  std::string records =
      index.compression.empty() ? std::string(bytes) : Decompressed(bytes, index.size);
  if (records.size() != index.size || Crc32(records) != check) {
    throw DataError("a chunk does not have its check value");
  }
  return records;
}

}  // namespace dockyard
