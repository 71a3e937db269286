// Reading input files of unknown content: size caps, plain text only, paths that stay in a folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace dockyard {

inline constexpr std::size_t kMaxTextBytes = 4u << 20;

/// The bytes of a regular file. Throws ConfigError when it is missing, unreadable or too large.
std::string ReadBytes(const std::filesystem::path& file, std::size_t max_bytes);

/// The text of a file: UTF-8 without control characters other than tab and line ends. Throws
/// ConfigError with the place of the first byte that is no text.
std::string ReadText(const std::filesystem::path& file, std::size_t max_bytes = kMaxTextBytes);
/// The same check on text that is there already.
void CheckIsText(std::string_view text, const std::string& file);

/// A path written in a file, relative to that file's folder; absolute paths stay as they are.
std::filesystem::path ResolveBeside(const std::string& written_in, const std::string& path);

/// The same, but the result must lie in that folder, symbolic links followed. Throws ConfigError,
/// its message opening with `place`.
std::filesystem::path ResolveInside(const std::string& written_in, const std::string& path,
                                    const std::string& place);

}  // namespace dockyard
