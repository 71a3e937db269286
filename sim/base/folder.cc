#include "sim/base/folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "controller/base/check.h"
#include "sim/base/count_text.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

const char* KindName(mode_t mode) {
  if (S_ISLNK(mode)) return "a link";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISREG(mode)) return "a file";
  return S_ISDIR(mode) ? "a folder" : "a device";
}

[[noreturn]] void Refuse(const fs::path& path, const char* expected, mode_t found) {
  throw UnsafeContent(path.string() + ": expected " + expected + ", found " + KindName(found) +
                      "; remove it");
}

/// What is there, a link not followed; none: nothing.
std::optional<struct stat> StatusOf(int folder, const std::string& name, const fs::path& path) {
  struct stat status {};
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) return status;
  if (errno == ENOENT) return std::nullopt;
  throw IoErrorFromErrno("read", path);
}

void RequireSize(const struct stat& status, std::uint64_t most_bytes, const fs::path& path) {
  if (static_cast<std::uint64_t>(status.st_size) <= most_bytes) return;
  throw UnsafeContent(path.string() + ": expected a file of at most " +
                      CountText(most_bytes >> 20, "MiB", "MiB") + ", found " +
                      CountText(static_cast<std::uint64_t>(status.st_size) >> 20, "MiB", "MiB") +
                      "; remove it");
}

/// Opened so that a pipe in its place does not wait for a writer.
Descriptor OpenRegular(int folder, const std::string& name, int flags, const fs::path& path) {
  const auto before = StatusOf(folder, name, path);
  if (before && !S_ISREG(before->st_mode)) Refuse(path, "a file", before->st_mode);
  Descriptor file(
      ::openat(folder, name.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0644));
  struct stat status {};
  if (file && ::fstat(file.value(), &status) == 0 && !S_ISREG(status.st_mode)) {
    Refuse(path, "a file", status.st_mode);
  }
  return file;
}

// By its descriptor, so that the folder is the one that was opened.
std::vector<std::string> NamesIn(const Descriptor& folder, const fs::path& path) {
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry("/proc/self/fd/" + std::to_string(folder.value()), error), end;
  for (; !error && entry != end; entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  if (error) throw IoError("cannot read folder " + path.string() + ": " + error.message());
  std::sort(names.begin(), names.end());
  return names;
}

Descriptor OpenStep(int folder, const std::string& name) {
  return Descriptor(
      ::openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

void RemoveIn(int folder, const std::string& name, const fs::path& path) {
  const auto status = StatusOf(folder, name, path);
  if (!status) return;
  const bool is_folder = S_ISDIR(status->st_mode);
  if (is_folder) {
    const Descriptor inner = OpenStep(folder, name);
    if (!inner) throw IoErrorFromErrno("empty folder", path);
    for (const std::string& each : NamesIn(inner, path)) {
      RemoveIn(inner.value(), each, path / each);
    }
  }
  if (::unlinkat(folder, name.c_str(), is_folder ? AT_REMOVEDIR : 0) == 0 || errno == ENOENT)
    return;
  throw IoErrorFromErrno("remove", path);
}

}  // namespace

Folder Folder::In(const fs::path& place) const {
  Folder folder = *this;
  folder.inside_ /= place;
  return folder;
}

// An empty result: one of the folders is not there.
Descriptor Folder::OpenFolder(const fs::path& place, bool make) const {
  Descriptor at(::open(root_.empty() ? "." : root_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!at && errno == ENOENT && !make) return at;
  if (!at) throw IoErrorFromErrno("read folder", root_);
  fs::path so_far = root_;
  for (const fs::path& step : inside_ / place) {
    if (step.empty() || step == ".") continue;
    DOCKYARD_CHECK(step != ".." && step.is_relative());
    const std::string name = step.string();
    so_far /= step;
    if (make && ::mkdirat(at.value(), name.c_str(), 0755) != 0 && errno != EEXIST) {
      throw IoErrorFromErrno("make folder", so_far);
    }
    const auto status = StatusOf(at.value(), name, so_far);
    if (!status) return Descriptor();
    if (!S_ISDIR(status->st_mode)) Refuse(so_far, "a folder", status->st_mode);
    at = OpenStep(at.value(), name);
    if (!at) throw IoErrorFromErrno("read folder", so_far);
  }
  return at;
}

Folder::Content Folder::At(const fs::path& place) const {
  const Descriptor folder = OpenFolder(place.parent_path(), false);
  if (!folder) return Content::kNothing;
  const fs::path shown = path() / place;
  const auto status = StatusOf(folder.value(), place.filename().string(), shown);
  if (!status) return Content::kNothing;
  if (S_ISDIR(status->st_mode)) return Content::kFolder;
  if (!S_ISREG(status->st_mode)) Refuse(shown, "a file or a folder", status->st_mode);
  return Content::kFile;
}

std::vector<std::string> Folder::Names(const fs::path& place) const {
  const Descriptor folder = OpenFolder(place, false);
  if (!folder) return {};
  return NamesIn(folder, path() / place);
}

std::optional<Descriptor> Folder::Open(const fs::path& place, std::uint64_t most_bytes) const {
  const Descriptor folder = OpenFolder(place.parent_path(), false);
  if (!folder) return std::nullopt;
  const fs::path shown = path() / place;
  Descriptor file = OpenRegular(folder.value(), place.filename().string(), O_RDONLY, shown);
  if (!file && errno == ENOENT) return std::nullopt;
  struct stat status {};
  if (!file || ::fstat(file.value(), &status) != 0) throw IoErrorFromErrno("read", shown);
  RequireSize(status, most_bytes, shown);
  return file;
}

std::optional<std::string> Folder::Read(const fs::path& place, std::uint64_t most_bytes) const {
  const auto file = Open(place, most_bytes);
  if (!file) return std::nullopt;
  return ReadAll(*file, path() / place);
}

fs::path Folder::Checked(const fs::path& place, std::uint64_t most_bytes) const {
  if (At(place) != Content::kFolder) {
    Open(place, most_bytes);
    return path() / place;
  }
  for (const std::string& name : Names(place)) Checked(place / name, most_bytes);
  return path() / place;
}

void Folder::Make(const fs::path& place) const { OpenFolder(place, true); }

void Folder::Write(const fs::path& place, std::string_view bytes) const {
  WholeFile file(OpenFolder(place.parent_path(), false), path() / place);
  file.Add(bytes);
  file.Finish();
}

Descriptor Folder::OpenToWrite(const fs::path& place, int flags) const {
  const Descriptor folder = OpenFolder(place.parent_path(), false);
  const fs::path shown = path() / place;
  if (!folder) throw IoErrorFromErrno("write", shown);
  Descriptor file = OpenRegular(folder.value(), place.filename().string(), flags | O_CREAT, shown);
  if (!file) throw IoErrorFromErrno("write", shown);
  return file;
}

void Folder::Remove(const fs::path& place) const {
  const Descriptor folder = OpenFolder(place.parent_path(), false);
  if (folder) RemoveIn(folder.value(), place.filename().string(), path() / place);
}

void Folder::Rename(const fs::path& from, const fs::path& to) const {
  const Descriptor from_folder = OpenFolder(from.parent_path(), false),
                   to_folder = OpenFolder(to.parent_path(), false);
  if (::renameat(from_folder.value(), from.filename().c_str(), to_folder.value(),
                 to.filename().c_str()) != 0) {
    throw IoErrorFromErrno("make folder", path() / to);
  }
}

void Folder::CopyInto(const Folder& into, const fs::path& place, std::uint64_t most_bytes) const {
  if (At(place) == Content::kFolder) {
    into.Make(place);
    for (const std::string& name : Names(place)) CopyInto(into, place / name, most_bytes);
    return;
  }
  const auto from = Open(place, most_bytes);
  if (!from || into.At(place) != Content::kNothing) return;
  WholeFile to(into.OpenFolder(place.parent_path(), true), into.path() / place);
  ReadBlocks(*from, path() / place, [&](std::string_view block) { to.Add(block); });
  to.Finish(/*to_the_disk=*/false);
}

}  // namespace dockyard
