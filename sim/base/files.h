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

/// Appends lines to a file. A line that another process sees is whole: it is written by one call.
class LineAppender {
 public:
  explicit LineAppender(const std::filesystem::path& path);
  ~LineAppender();
  LineAppender(const LineAppender&) = delete;
  LineAppender& operator=(const LineAppender&) = delete;

  /// Hands one line, its newline left out, to the system: a killed program does not lose it. Throws
  /// IoError.
  void Append(std::string_view line);
  /// The lines so far are on the disk when it returns: a power cut does not lose them. Throws
  /// IoError.
  void Flush();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// As WriteWhole, for a file that is made piece by piece. Without Finish the path keeps its old
/// bytes.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Throws IoError.
  void Add(std::string_view bytes);
  void Finish();

 private:
  std::filesystem::path path_, temporary_;
  int descriptor_ = -1;
  std::string waiting_;  // bytes that one call writes together
};

}  // namespace dockyard
