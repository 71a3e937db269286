#include "sim/base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>

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

// Some file systems have no fsync for their files; that is no reason to lose the run.
void FlushToDisk(int descriptor, const std::filesystem::path& path) {
  if (::fdatasync(descriptor) != 0 && errno != EINVAL && errno != EROFS) {
    throw IoErrorFromErrno("flush", path);
  }
}

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags)
      : value_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int value() const { return value_; }

 private:
  int value_;
};

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

std::optional<std::string> ReadWhole(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (file.value() < 0 && errno == ENOENT) return std::nullopt;
  if (file.value() < 0) throw IoErrorFromErrno("read", path);
  std::string bytes;
  char block[65536];
  for (;;) {
    const ssize_t count = ::read(file.value(), block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw IoErrorFromErrno("read", path);
    if (count == 0) return bytes;
    bytes.append(block, static_cast<std::size_t>(count));
  }
}

LineAppender::LineAppender(const std::filesystem::path& path)
    : path_(path),
      descriptor_(::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) throw IoErrorFromErrno("write", path_);
}

LineAppender::~LineAppender() { ::close(descriptor_); }

void LineAppender::Append(std::string_view line) {
  WriteAll(descriptor_, std::string(line) + "\n", path_);
}

void LineAppender::Flush() { FlushToDisk(descriptor_, path_); }

WholeFile::WholeFile(const std::filesystem::path& path) : path_(path), temporary_(path) {
  // A name of its own: two programs may write the same file at once.
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  temporary_ += "." + std::to_string(::getpid()) + "-" + std::to_string(now) + ".tmp";
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw IoErrorFromErrno("write", path_);
}

WholeFile::~WholeFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

void WholeFile::Add(std::string_view bytes) {
  constexpr std::size_t kBlock = 1u << 16;
  waiting_ += bytes;
  if (waiting_.size() < kBlock) return;
  WriteAll(descriptor_, waiting_, path_);
  waiting_.clear();
}

void WholeFile::Finish() {
  WriteAll(descriptor_, waiting_, path_);
  FlushToDisk(descriptor_, path_);
  ::close(descriptor_);
  descriptor_ = -1;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) throw IoErrorFromErrno("write", path_);
  const std::filesystem::path parent = path_.has_parent_path() ? path_.parent_path() : ".";
  const Descriptor folder(parent, O_RDONLY | O_DIRECTORY);
  if (folder.value() >= 0) FlushToDisk(folder.value(), parent);
}

}  // namespace dockyard
