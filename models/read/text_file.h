// Reading input files of unknown content: size caps, plain text only.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dockyard {

inline constexpr std::size_t kMaxTextBytes = 4u << 20;

/// The bytes of a regular file. Throws ConfigError when it is missing, unreadable or too large.
std::string ReadBytes(const std::filesystem::path& file, std::size_t max_bytes);

/// The text of a file: UTF-8 without control characters other than tab and line ends. A byte order
/// mark at its begin is left out. Throws ConfigError with the place of the first byte that is no
/// text.
std::string ReadText(const std::filesystem::path& file, std::size_t max_bytes = kMaxTextBytes);
/// The same check on text that is there already.
void CheckIsText(std::string_view text, const std::string& file);
/// Throws ConfigError for UTF-16 and UTF-32, as Excel's "Unicode Text" and PowerShell's > write.
/// CheckIsText begins with it.
void RefuseWideText(std::string_view text, const std::string& file);
/// The text behind its byte order mark (EF BB BF), if it has one.
std::string_view WithoutByteOrderMark(std::string_view text);

/// Whether the character moves a terminal or ends a line somewhere: C0, DEL, C1 with NEL, the
/// separators of lines and paragraphs, and the byte order mark.
bool IsControl(char32_t c);
/// The first such character; a byte that is no UTF-8 counts as one. Tabs and line ends count.
std::optional<char32_t> FirstControl(std::string_view text);
/// "U+001B"
std::string CharacterName(char32_t c);
/// The text for a terminal: control characters but tab and newline as "\x1b" or "\u0085", bytes
/// that are no UTF-8 as "\xff". Twice is as once.
std::string WithControlsShown(std::string_view text);

/// A path written in a file, relative to that file's folder; absolute paths stay as they are.
std::filesystem::path ResolveBeside(const std::string& written_in, const std::string& path);

}  // namespace dockyard
