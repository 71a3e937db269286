#include "sim/base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
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
void Flush(int descriptor, const std::filesystem::path& path) {
  if (::fsync(descriptor) != 0 && errno != EINVAL && errno != EROFS) {
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
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  {
    const Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC);
    if (file.value() < 0) throw IoErrorFromErrno("write", path);
    WriteAll(file.value(), bytes, path);
    Flush(file.value(), path);
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0) throw IoErrorFromErrno("write", path);
  const std::filesystem::path parent = path.has_parent_path() ? path.parent_path() : ".";
  const Descriptor folder(parent, O_RDONLY | O_DIRECTORY);
  if (folder.value() >= 0) Flush(folder.value(), parent);
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
  Flush(descriptor_, path_);
}

}  // namespace dockyard
