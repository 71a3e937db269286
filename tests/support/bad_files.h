// Files made bad on purpose, in a folder of their own.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "models/read/config_error.h"
#include "support/source_tree.h"

namespace dockyard {

/// A folder that is gone with its owner.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes a file and gives its path.
  std::string Write(const std::string& name, const std::string& bytes) const;
  /// Copies models/<model> of the source tree into it.
  void CopyModel(const std::string& model) const;

 private:
  std::filesystem::path path_;
};

std::string Slurp(const std::filesystem::path& file);
/// The text with the first occurrence of `from`, which must be there, replaced.
std::string Replaced(std::string text, const std::string& from, const std::string& to);

/// A binary glTF file of this JSON and these bytes of geometry.
std::string Glb(const std::string& json, const std::string& binary);
/// The JSON of a triangle with its corners in a buffer of 36 bytes, at `uri` or in the GLB's own.
std::string TriangleGltf(const std::string& uri = "");
/// Its corners: (0, 0, 0), (1, 0, 0), (0, 1, 0).
std::string TriangleBytes();
/// A Collada document of one triangle: (0, 0, 0), (1, 0, 0), (0, 0, 2).
std::string TriangleCollada();

/// The message of the ConfigError that the call throws, with the folder's path cut out; a note that
/// none was thrown otherwise.
std::string MessageOf(const std::function<void()>& call, const ScratchFolder& folder);

}  // namespace dockyard
