// A folder below the system's temporary one, for files that nobody keeps.
#pragma once

#include <filesystem>

namespace dockyard {

class PassingFolder {
 public:
  /// Throws IoError.
  PassingFolder();
  ~PassingFolder();
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace dockyard
