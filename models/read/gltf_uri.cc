#include "models/read/gltf_uri.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace dockyard {
namespace {

/// `count` hexadecimal digits at the front, taken off.
std::optional<std::uint32_t> TakeHex(std::string_view& text, std::size_t count) {
  std::uint32_t value = 0;
  if (text.size() < count) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + count, value, 16);
  if (error != std::errc() || end != text.data() + count) return std::nullopt;
  text.remove_prefix(count);
  return value;
}

void AppendUtf8(std::uint32_t point, std::string& text) {
  const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (point < 0x80) {
    put(point);
  } else if (point < 0x800) {
    put(0xC0 | (point >> 6));
    put(0x80 | (point & 0x3F));
  } else if (point < 0x10000) {
    put(0xE0 | (point >> 12));
    put(0x80 | ((point >> 6) & 0x3F));
    put(0x80 | (point & 0x3F));
  } else {
    put(0xF0 | (point >> 18));
    put(0x80 | ((point >> 12) & 0x3F));
    put(0x80 | ((point >> 6) & 0x3F));
    put(0x80 | (point & 0x3F));
  }
}

/// The character after "\u": four digits, or twice four for one beyond the first 65 536.
bool TakeUnicode(std::string_view& rest, std::string& text) {
  const auto first = TakeHex(rest, 4);
  if (!first || (*first >= 0xDC00 && *first <= 0xDFFF)) return false;
  std::uint32_t point = *first;
  if (point >= 0xD800 && point <= 0xDBFF) {
    if (rest.substr(0, 2) != "\\u") return false;
    rest.remove_prefix(2);
    const auto second = TakeHex(rest, 4);
    if (!second || *second < 0xDC00 || *second > 0xDFFF) return false;
    point = 0x10000 + ((point - 0xD800) << 10) + (*second - 0xDC00);
  }
  AppendUtf8(point, text);
  return true;
}

/// The text with what `take` puts for each part behind the mark; none where it takes nothing.
template <class Take>
std::optional<std::string> Decoded(std::string_view rest, char mark, const Take& take) {
  std::string text;
  while (!rest.empty()) {
    const char c = rest.front();
    rest.remove_prefix(1);
    if (c != mark) {
      text += c;
    } else if (!take(rest, text)) {
      return std::nullopt;
    }
  }
  return text;
}

bool TakeJsonEscape(std::string_view& rest, std::string& text) {
  if (rest.empty()) return false;
  const char kind = rest.front();
  rest.remove_prefix(1);
  if (kind == 'u') return TakeUnicode(rest, text);
  if (kind != '/' && kind != '\\' && kind != '"') return false;  // a line break: in no name
  text += kind;
  return true;
}

bool EndsInBin(std::string_view name) {
  constexpr std::string_view kEnding = ".bin";
  if (name.size() <= kEnding.size()) return false;
  return std::equal(kEnding.begin(), kEnding.end(), name.end() - kEnding.size(),
                    [](char a, char b) {
                      return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
                    });
}

}  // namespace

std::optional<std::string> PercentDecoded(std::string_view text) {
  return Decoded(text, '%', [](std::string_view& rest, std::string& decoded) {
    const auto byte = TakeHex(rest, 2);
    if (byte) decoded += static_cast<char>(*byte);
    return byte.has_value();
  });
}

std::optional<std::string> BufferNameOf(std::string_view json) {
  const auto uri = Decoded(json, '\\', TakeJsonEscape);
  if (!uri) return std::nullopt;
  auto name = PercentDecoded(*uri);
  if (!name) return std::nullopt;
  if (name->rfind("./", 0) == 0) name->erase(0, 2);
  const bool plain = std::none_of(name->begin(), name->end(), [](char c) {
    return c == '/' || c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  });
  return plain && EndsInBin(*name) ? name : std::nullopt;
}

}  // namespace dockyard
