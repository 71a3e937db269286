// A folder that somebody else may have filled: nothing in it leads out of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/files.h"

namespace dockyard {

/// A folder holds what it may not: a link, a pipe, a device, or a file that is too large. The
/// message says what was found and what to do.
class UnsafeContent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Its user named the folder, which may be a link itself. Below it every step is opened from the
/// one before it and no link is followed; files are regular ones. A place in it is a relative path
/// without "..". All functions throw UnsafeContent, and IoError.
class Folder {
 public:
  Folder(std::filesystem::path path) : root_(std::move(path)) {}  // a path is a folder
  Folder(const char* path) : root_(path) {}
  Folder(const std::string& path) : root_(path) {}
  /// A folder in it, which need not be there.
  Folder In(const std::filesystem::path& place) const;
  /// For messages.
  std::filesystem::path path() const { return root_ / inside_; }

  enum class Content { kNothing, kFile, kFolder };
  Content At(const std::filesystem::path& place) const;
  bool HasFile(const std::filesystem::path& place) const { return At(place) == Content::kFile; }
  bool HasFolder(const std::filesystem::path& place) const { return At(place) == Content::kFolder; }
  /// Names in a folder, sorted; empty: it is not there.
  std::vector<std::string> Names(const std::filesystem::path& place = {}) const;

  /// A regular file to read. None: nothing is there.
  std::optional<Descriptor> Open(const std::filesystem::path& place,
                                 std::uint64_t most_bytes) const;
  /// All of it.
  std::optional<std::string> Read(const std::filesystem::path& place,
                                  std::uint64_t most_bytes) const;
  /// The path of a file or of a folder with all in it, each file of at most that many bytes, for a
  /// reader that takes a path. Nothing there: the path too.
  std::filesystem::path Checked(const std::filesystem::path& place, std::uint64_t most_bytes) const;

  /// Makes the folder and those above it.
  void Make(const std::filesystem::path& place) const;
  /// As WriteWhole; the folder must be there.
  void Write(const std::filesystem::path& place, std::string_view bytes) const;
  /// A regular file to write, which is made where it is not there.
  /// @param flags  of open(2), with those for safety added
  Descriptor OpenToWrite(const std::filesystem::path& place, int flags) const;
  /// What is there, a folder with all in it. A link goes, but not its target. Nothing there:
  /// nothing.
  void Remove(const std::filesystem::path& place) const;
  void Rename(const std::filesystem::path& from, const std::filesystem::path& to) const;
  /// Copies a file, or a folder with all in it, to the same place in `into`; files that are there
  /// stay.
  void CopyInto(const Folder& into, const std::filesystem::path& place,
                std::uint64_t most_bytes) const;

 private:
  Descriptor OpenFolder(const std::filesystem::path& place, bool make) const;

  std::filesystem::path root_, inside_;
};

}  // namespace dockyard
