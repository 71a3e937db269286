// The addresses of meshes in a URDF file: paths relative to it, and package:// as ROS writes it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace dockyard {

/// Folders of ROS packages by name, given by the user.
using PackageFolders = std::map<std::string, std::string>;

/// Finds the files that one URDF file names. A file from elsewhere shall name no others of this
/// computer, so all lie in the robot's folder: the ROS package of the URDF file (a package.xml lies
/// in its folder or above); without one the folder above where its own is named urdf, xacro or
/// robots, as packages lay robots out; else its own. Files of a package:// lie in that package.
/// Symbolic links are followed for that.
class MeshAddresses {
 public:
  MeshAddresses(std::string urdf_file, PackageFolders packages);

  /// Throws ConfigError that begins with `place`: an address of another kind, a package that is not
  /// found (with the folders that were searched), a path that leads out, a file that is not there.
  std::filesystem::path Resolve(const std::string& address, const std::string& place);

 private:
  /// The folder of a package: as given by the user, else one whose package.xml has that name. It is
  /// searched for above the URDF file, then in its own package and next to that, two folders deep.
  std::filesystem::path FolderOf(const std::string& package, const std::string& place);
  void FindRoot();

  std::string urdf_file_;
  std::filesystem::path root_;                // the robot's folder
  std::vector<std::filesystem::path> above_;  // packages that the file lies in, the nearest first
  PackageFolders packages_;
};

/// The name in a package.xml of that folder, of a Gazebo model the folder's own name; empty for any
/// other folder.
std::string PackageNameOf(const std::filesystem::path& folder);

/// The package.xml, or the model.config, of the nearest package that holds the folder; empty: none
/// does.
std::filesystem::path PackageFileAbove(const std::filesystem::path& folder);

}  // namespace dockyard
