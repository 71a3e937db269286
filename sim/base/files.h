// Files that are whole or not there: a run's files survive a crash.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace dockyard {

/// A file or folder that cannot be made, written or read. The message is a sentence.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "cannot <doing> <path>: <reason from errno>"
IoError IoErrorFromErrno(const std::string& doing, const std::filesystem::path& path);

/// A file descriptor of the system that closes itself.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int value) : value_(value) {}  // below 0: none
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : value_(other.Release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }

  explicit operator bool() const { return value_ >= 0; }
  int value() const { return value_; }
  /// The caller closes it.
  int Release() { return std::exchange(value_, -1); }

 private:
  int value_ = -1;
};

/// Makes the folder and its parents. Throws IoError.
void MakeFolder(const std::filesystem::path& path);

/// Writes a temporary file beside it, flushes it to the disk, renames it: the path holds the old
/// bytes or the new ones, never a part. Throws IoError.
void WriteWhole(const std::filesystem::path& path, std::string_view bytes);

/// The bytes, or none if there is no such file. Throws IoError.
std::optional<std::string> ReadWhole(const std::filesystem::path& path);

/// Throws IoError, also for no file.
std::uint64_t SizeOf(const Descriptor& file, const std::filesystem::path& path);

/// From the file's place on to its end; the path is for messages. Throw IoError.
void ReadBlocks(const Descriptor& file, const std::filesystem::path& path,
                const std::function<void(std::string_view block)>& take);
std::string ReadAll(const Descriptor& file, const std::filesystem::path& path);

/// Appends lines to a file. A line that another process sees is whole: it is written by one call.
class LineAppender {
 public:
  explicit LineAppender(const std::filesystem::path& path);
  /// @param file  opened to append; the path is for messages
  LineAppender(Descriptor file, const std::filesystem::path& path);

  /// Hands one line, its newline left out, to the system: a killed program does not lose it. Throws
  /// IoError.
  void Append(std::string_view line);
  /// The lines so far are on the disk when it returns: a power cut does not lose them. Throws
  /// IoError.
  void Flush();

 private:
  std::filesystem::path path_;
  Descriptor file_;
};

/// As WriteWhole, for a file that is made piece by piece. Without Finish the path keeps its old
/// bytes.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path& path);
  /// The file of the path's last name in that folder.
  WholeFile(Descriptor folder, const std::filesystem::path& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Throws IoError.
  void Add(std::string_view bytes);
  /// Where the bytes are until Finish, for another writer.
  std::filesystem::path temporary() const { return path_.parent_path() / temporary_; }
  /// @param to_the_disk  before the file has its name, so that a power cut leaves old or new bytes
  void Finish(bool to_the_disk = true);

 private:
  std::filesystem::path path_;
  std::string temporary_;  // its name
  Descriptor folder_, file_;
  std::string waiting_;  // bytes that one call writes together
};

}  // namespace dockyard
