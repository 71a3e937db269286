#include "sim/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace dockyard {
namespace {

void WriteAll(int descriptor, std::string_view bytes, const std::filesystem::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw IoErrorFromErrno("write", path);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

// Some file systems have no fsync for their files, nor has a folder that may not be listed; that is
// no reason to lose the run.
void FlushToDisk(int descriptor, const std::filesystem::path& path) {
  if (::fdatasync(descriptor) != 0 && errno != EINVAL && errno != EROFS && errno != EBADF) {
    throw IoErrorFromErrno("flush", path);
  }
}

/// A folder, its files to be written.
Descriptor FolderOf(const std::filesystem::path& path) {
  const std::filesystem::path parent = path.has_parent_path() ? path.parent_path() : ".";
  Descriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // A folder may be written that may not be listed.
  if (!folder && errno == EACCES) {
    folder = Descriptor(::open(parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  }
  return folder;
}

}  // namespace

IoError IoErrorFromErrno(const std::string& doing, const std::filesystem::path& path) {
  const int code = errno;
  return IoError("cannot " + doing + " " + path.string() + ": " + std::strerror(code));
}

void MakeFolder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw IoError("cannot make folder " + path.string() + ": " + error.message());
  if (!std::filesystem::is_directory(path, error)) {
    throw IoError("cannot make folder " + path.string() + ": a file of that name is there");
  }
}

void WriteWhole(const std::filesystem::path& path, std::string_view bytes) {
  WholeFile file(path);
  file.Add(bytes);
  file.Finish();
}

Descriptor::~Descriptor() {
  if (value_ >= 0) ::close(value_);
}

std::optional<std::string> ReadWhole(const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file && errno == ENOENT) return std::nullopt;
  if (!file) throw IoErrorFromErrno("read", path);
  return ReadAll(file, path);
}

std::uint64_t SizeOf(const Descriptor& file, const std::filesystem::path& path) {
  struct stat status {};
  if (::fstat(file.value(), &status) != 0) throw IoErrorFromErrno("read", path);
  return static_cast<std::uint64_t>(status.st_size);
}

void ReadBlocks(const Descriptor& file, const std::filesystem::path& path,
                const std::function<void(std::string_view block)>& take) {
  char block[65536];
  for (;;) {
    const ssize_t count = ::read(file.value(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw IoErrorFromErrno("read", path);
    if (count == 0) return;
    take({block, static_cast<std::size_t>(count)});
  }
}

std::string ReadAll(const Descriptor& file, const std::filesystem::path& path) {
  std::string bytes;
  ReadBlocks(file, path, [&](std::string_view block) { bytes += block; });
  return bytes;
}

LineAppender::LineAppender(const std::filesystem::path& path)
    : LineAppender(
          Descriptor(::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644)), path) {
}

LineAppender::LineAppender(Descriptor file, const std::filesystem::path& path)
    : path_(path), file_(std::move(file)) {
  if (!file_) throw IoErrorFromErrno("write", path_);
}

void LineAppender::Append(std::string_view line) {
  WriteAll(file_.value(), std::string(line) + "\n", path_);
}

void LineAppender::Flush() { FlushToDisk(file_.value(), path_); }

WholeFile::WholeFile(const std::filesystem::path& path) : WholeFile(FolderOf(path), path) {}

WholeFile::WholeFile(Descriptor folder, const std::filesystem::path& path)
    : path_(path), folder_(std::move(folder)) {
  if (!folder_) throw IoErrorFromErrno("write", path_);
  // A name of its own: two programs may write the same file at once.
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  temporary_ = path.filename().string() + "." + std::to_string(::getpid()) + "-" +
               std::to_string(now) + ".tmp";
  file_ = Descriptor(
      ::openat(folder_.value(), temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (!file_) throw IoErrorFromErrno("write", path_);
}

WholeFile::~WholeFile() {
  if (file_) ::unlinkat(folder_.value(), temporary_.c_str(), 0);
}

void WholeFile::Add(std::string_view bytes) {
  constexpr std::size_t kBlock = 1u << 16;
  waiting_ += bytes;
  if (waiting_.size() < kBlock) return;
  WriteAll(file_.value(), waiting_, path_);
  waiting_.clear();
}

void WholeFile::Finish(bool to_the_disk) {
  WriteAll(file_.value(), waiting_, path_);
  if (to_the_disk) FlushToDisk(file_.value(), path_);
  file_ = Descriptor();
  if (::renameat(folder_.value(), temporary_.c_str(), folder_.value(), path_.filename().c_str()) !=
      0) {
    throw IoErrorFromErrno("write", path_);
  }
  if (to_the_disk) FlushToDisk(folder_.value(), path_.parent_path());
}

}  // namespace dockyard
