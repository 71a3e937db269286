#include "sim/page/payload.h"

#include <zlib.h>

#include <bit>
#include <cmath>
#include <limits>

#include "controller/base/check.h"
#include "sim/base/bytes.h"
#include "sim/page/page_template.h"

namespace dockyard {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are stored as they are");

constexpr std::string_view kMagic = "DOCKREP1";
constexpr std::string_view kMark = "@PAYLOAD@";
constexpr std::int32_t kMissing = std::numeric_limits<std::int32_t>::min();

std::int32_t Whole(double value, double quantum) {
  const double whole = std::round(value / quantum);
  return std::abs(whole) < 2147483648.0 ? static_cast<std::int32_t>(whole) : kMissing;
}

/// Differences in zigzag order: 0, -1, 1, -2, ...
std::vector<std::uint32_t> Codes(const std::vector<double>& values, double quantum) {
  std::vector<std::uint32_t> codes;
  codes.reserve(values.size());
  std::uint32_t last = 0;
  for (const double value : values) {
    const auto now = static_cast<std::uint32_t>(Whole(value, quantum));
    const std::uint32_t step = now - last;
    last = now;
    codes.push_back((step << 1) ^ (step >> 31 ? 0xffffffffu : 0u));
  }
  return codes;
}

std::string Gzip(const std::string& bytes) {
  z_stream stream{};
  constexpr int kGzip = 15 + 16, kMemory = 8;
  DOCKYARD_CHECK(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory,
                              Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  // zlib counts in 32 bits: piece by piece.
  constexpr std::size_t kPiece = std::size_t{1} << 30;
  std::size_t taken = 0;
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  std::size_t room = out.size();
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0 && taken < bytes.size()) {
      const std::size_t piece = std::min(kPiece, bytes.size() - taken);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
      stream.avail_in = static_cast<uInt>(piece);
      taken += piece;
    }
    const auto space = static_cast<uInt>(std::min(kPiece, room));
    stream.avail_out = space;
    state = deflate(&stream, taken == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    room -= space - stream.avail_out;
    DOCKYARD_CHECK(state == Z_OK || state == Z_STREAM_END || state == Z_BUF_ERROR);
  }
  out.resize(out.size() - room);
  deflateEnd(&stream);
  return out;
}

}  // namespace

Json Payload::Add(std::string_view bytes) {
  const Json place{{"offset", blobs_.size()}, {"length", bytes.size()}};
  blobs_.append(bytes);
  blobs_.append((4 - blobs_.size() % 4) % 4, '\0');
  return place;
}

Json Payload::AddChannel(const std::vector<double>& values, double quantum) {
  const std::vector<std::uint32_t> codes = Codes(values, quantum);
  std::uint32_t all = 0;
  for (const std::uint32_t code : codes) all |= code;
  const int planes = all >> 24 ? 4 : all >> 16 ? 3 : all >> 8 ? 2 : 1;
  std::string bytes;
  if (!codes.empty()) bytes += static_cast<char>(planes);
  for (int plane = 0; plane < planes; ++plane) {
    for (const std::uint32_t code : codes) bytes += static_cast<char>(code >> (8 * plane));
  }
  Json channel = Add(bytes);
  channel["quantum"] = quantum;
  return channel;
}

std::string Payload::Text(const Json& header) const {
  // A name of a file may hold bytes that are no UTF-8.
  const std::string text = header.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string bytes(kMagic);
  PutU32(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  bytes += blobs_;
  return Base64(Gzip(bytes));
}

std::string PageWith(const std::string& payload_text) {
  std::string page(kPageTemplate);
  const std::size_t mark = page.find(kMark);
  DOCKYARD_CHECK(mark != std::string::npos);
  return page.replace(mark, kMark.size(), payload_text);
}

std::string Base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      three = three << 8 | (i < count ? static_cast<std::uint8_t>(bytes[at + i]) : 0u);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= count ? kDigits[three >> (18 - 6 * i) & 63] : '=';
    }
  }
  return text;
}

}  // namespace dockyard
