#include "sim/mcap/chunk.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

#include "controller/base/check.h"
#include "sim/base/bytes.h"
#include "sim/base/crc32.h"
#include "sim/mcap/mcap_records.h"

namespace dockyard {
namespace {

constexpr int kLevel = 3;  // Zstandard's own choice between size and speed
constexpr const char* kZstd = "zstd";
constexpr const char* kLz4 = "lz4";  // frames, not bare blocks

std::string Compressed(std::string_view bytes) {
  std::string out(::ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ::ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  DOCKYARD_CHECK(!::ZSTD_isError(size));
  out.resize(size);
  return out;
}

[[noreturn]] void RefuseSize() { throw DataError("a chunk has another size than it says"); }
[[noreturn]] void RefuseBytes() { throw DataError("a chunk cannot be decompressed"); }

/// Takes output as it comes: a chunk that lies about its size takes no more memory than it fills.
/// @param step  (space at the end of the output, its size in and out) -> whether input is used up
template <class Step>
std::string Grown(std::uint64_t size, Step step) {
  constexpr std::uint64_t kPiece = 1u << 20;
  std::string out;
  for (bool done = false; !done;) {
    const std::size_t at = out.size();
    // One byte more than there should be shows a chunk that is longer.
    std::size_t room = static_cast<std::size_t>(std::min(kPiece, size + 1 - at));
    out.resize(at + room);
    done = step(out.data() + at, room);
    out.resize(at + room);
    if (out.size() > size) RefuseSize();
  }
  if (out.size() != size) RefuseSize();
  return out;
}

std::string FromZstd(std::string_view bytes, std::uint64_t size) {
  const auto stated = ::ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (stated == ZSTD_CONTENTSIZE_ERROR) RefuseBytes();
  // Writers that compress as they go do not know it.
  if (stated != ZSTD_CONTENTSIZE_UNKNOWN && stated != size) RefuseSize();
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(::ZSTD_createDStream(),
                                                                             &::ZSTD_freeDStream);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  return Grown(size, [&](char* space, std::size_t& room) {
    ZSTD_outBuffer out{space, room, 0};
    const std::size_t left = ::ZSTD_decompressStream(stream.get(), &out, &in);
    const bool stuck = out.pos < out.size && in.pos == in.size && left != 0;
    if (::ZSTD_isError(left) || stuck) RefuseBytes();
    room = out.pos;
    return left == 0 && in.pos == in.size;
  });
}

std::string FromLz4(std::string_view bytes, std::uint64_t size) {
  LZ4F_dctx* made = nullptr;
  if (::LZ4F_isError(::LZ4F_createDecompressionContext(&made, LZ4F_VERSION))) RefuseBytes();
  const std::unique_ptr<LZ4F_dctx, std::size_t (*)(LZ4F_dctx*)> context(
      made, &::LZ4F_freeDecompressionContext);
  return Grown(size, [&](char* space, std::size_t& room) {
    std::size_t used = bytes.size(), made_bytes = room;
    const std::size_t left =
        ::LZ4F_decompress(context.get(), space, &made_bytes, bytes.data(), &used, nullptr);
    const bool stuck = used == 0 && made_bytes == 0 && left != 0;
    if (::LZ4F_isError(left) || stuck) RefuseBytes();
    bytes.remove_prefix(used);
    room = made_bytes;
    return left == 0 && bytes.empty();
  });
}

std::string Decompressed(std::string_view bytes, const McapChunkIndex& index) {
  if (index.compression.empty()) return std::string(bytes);
  if (index.compression == kZstd) return FromZstd(bytes, index.size);
  if (index.compression == kLz4) return FromLz4(bytes, index.size);
  throw DataError("a chunk is compressed by '" + index.compression + "', expected zstd or lz4");
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

std::string RecordsOfChunk(std::string_view content, McapChunkIndex& index, bool& guarded) {
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
  std::string records = Decompressed(bytes, index);
  guarded = check != kNoCheckValue;
  if (records.size() != index.size || (guarded && Crc32(records) != check)) {
    throw DataError("a chunk does not have its check value");
  }
  return records;
}

}  // namespace dockyard
