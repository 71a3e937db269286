// Files that are whole or not there: a run's files survive a crash.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace dockyard {

/// A file or folder that cannot be made, written or read. The message is a sentence.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "cannot <doing> <path>: <reason from errno>"
IoError IoErrorFromErrno(const std::string& doing, const std::filesystem::path& path);

/// Makes the folder and its parents. Throws IoError.
void MakeFolder(const std::filesystem::path& path);

/// Writes a temporary file beside it, flushes it to the disk, renames it: the path holds the old
/// bytes or the new ones, never a part. Throws IoError.
void WriteWhole(const std::filesystem::path& path, std::string_view bytes);

/// The bytes, or none if there is no such file. Throws IoError.
std::optional<std::string> ReadWhole(const std::filesystem::path& path);

/// Appends lines; each is on the disk when Append returns.
class LineAppender {
 public:
  explicit LineAppender(const std::filesystem::path& path);
  ~LineAppender();
  LineAppender(const LineAppender&) = delete;
  LineAppender& operator=(const LineAppender&) = delete;

  /// One line, newline included by the callee. Throws IoError.
  void Append(std::string_view line);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace dockyard
