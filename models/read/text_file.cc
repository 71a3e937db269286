#include "models/read/text_file.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "models/read/config_error.h"
#include "models/read/near_names.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// Length of the UTF-8 sequence that starts at text[i], 0 if it is not one (RFC 3629, section 4).
int SequenceLength(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u;
  };
  const auto tail = [&](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(i), second = byte(i + 1);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return tail(i + 1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && second < 0xA0;
    const bool surrogate = lead == 0xED && second > 0x9F;
    return tail(i + 1) && tail(i + 2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && second < 0x90, beyond = lead == 0xF4 && second > 0x8F;
    return tail(i + 1) && tail(i + 2) && tail(i + 3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

/// The character of a sequence of that length.
char32_t CharacterAt(std::string_view text, std::size_t i, int length) {
  constexpr unsigned kLeadBits[] = {0x7F, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t c = static_cast<unsigned char>(text[i]) & kLeadBits[length];
  for (std::size_t k = 1; k < static_cast<std::size_t>(length); ++k) {
    c = (c << 6) | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
  }
  return c;
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The encoding of text in units of two or four bytes; empty for others. Without a mark it shows
/// by the zeros: every second byte of the first four.
std::string_view WideEncoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
  if (text.size() < 4) return {};
  const auto zero = [&](std::size_t k) { return text[k] == '\0'; };
  const bool low = !zero(0) && zero(1) && !zero(2) && zero(3);
  const bool high = zero(0) && !zero(1) && zero(2) && !zero(3);
  return low || high ? "UTF-16" : "";
}

}  // namespace

std::string ReadBytes(const fs::path& file, std::size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status))
    throw ConfigError(file.string() + ": no such file" + DidYouMeanFile(file));
  if (!fs::is_regular_file(status)) throw ConfigError(file.string() + ": not a regular file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw ConfigError(file.string() + ": cannot be opened for reading");
  std::string bytes;
  char buffer[65536];
  while (in.read(buffer, sizeof buffer) || in.gcount() > 0) {
    bytes.append(buffer, static_cast<std::size_t>(in.gcount()));
    if (bytes.size() > max_bytes) {
      throw ConfigError(file.string() + ": larger than " + std::to_string(max_bytes >> 20) +
                        " MiB, which is more than this kind of file may have");
    }
  }
  if (in.bad()) throw ConfigError(file.string() + ": cannot be read to its end");
  return bytes;
}

void RefuseWideText(std::string_view text, const std::string& file) {
  const std::string encoding(WideEncoding(text));
  if (encoding.empty()) return;
  throw ConfigError(file + ":1:1: expected text in UTF-8, found " + encoding +
                    "; save it as UTF-8 (in Excel 'CSV UTF-8', in an editor the encoding 'UTF-8'), "
                    "or convert it by iconv -f " +
                    encoding + " -t UTF-8");
}

std::string_view WithoutByteOrderMark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

bool IsControl(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029 || c == 0xFEFF;
}

std::optional<char32_t> FirstControl(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const int length = SequenceLength(text, i);
    if (length == 0) return static_cast<unsigned char>(text[i]);
    const char32_t c = CharacterAt(text, i, length);
    if (IsControl(c)) return c;
    i += static_cast<std::size_t>(length);
  }
  return std::nullopt;
}

std::string CharacterName(char32_t c) {
  char name[16];
  std::snprintf(name, sizeof name, "U+%04X", static_cast<unsigned>(c));
  return name;
}

std::string WithControlsShown(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const int length = SequenceLength(text, i);
    const auto bytes = static_cast<std::size_t>(std::max(length, 1));
    const char32_t c =
        length == 0 ? static_cast<unsigned char>(text[i]) : CharacterAt(text, i, length);
    if (length > 0 && (c == '\t' || c == '\n' || !IsControl(c))) {
      shown += text.substr(i, bytes);
    } else {
      char escape[16];
      const bool is_byte = length == 0 || c < 0x80;
      std::snprintf(escape, sizeof escape, is_byte ? "\\x%02x" : "\\u%04x",
                    static_cast<unsigned>(c));
      shown += escape;
    }
    i += bytes;
  }
  return shown;
}

void CheckIsText(std::string_view text, const std::string& file) {
  RefuseWideText(text, file);
  int line = 1, column = 1;
  for (std::size_t i = 0; i < text.size();) {
    const int length = SequenceLength(text, i);
    const unsigned char c = static_cast<unsigned char>(text[i]);
    const bool control = (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F;
    if (length == 0 || control) {
      throw ConfigError(file + ":" + std::to_string(line) + ":" + std::to_string(column) +
                        ": expected text in UTF-8, found byte " + std::to_string(c));
    }
    if (c == '\n') {
      ++line;
      column = 1;
    } else {
      ++column;
    }
    i += static_cast<std::size_t>(length);
  }
}

std::string ReadText(const fs::path& file, std::size_t max_bytes) {
  const std::string bytes = ReadBytes(file, max_bytes);
  const std::string_view text = WithoutByteOrderMark(bytes);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw ConfigError(file.string() + ":1:1: the file is empty");
  }
  CheckIsText(text, file.string());
  return std::string(text);
}

fs::path ResolveBeside(const std::string& written_in, const std::string& path) {
  return (fs::path(written_in).parent_path() / path).lexically_normal();
}

}  // namespace dockyard
