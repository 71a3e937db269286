#include "models/read/mesh_address.h"

#include <tinyxml.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/gltf_uri.h"
#include "models/read/near_names.h"
#include "models/read/text_file.h"
#include "models/read/xml_scan.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFoldersSearched = 4000;

[[noreturn]] void RefuseAddress(const std::string& place, const std::string& what) {
  throw ConfigError(place + ": " + what);
}

fs::path Canonical(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path.empty() ? fs::path(".") : path, error);
  return error ? path : real;
}

bool LiesIn(const fs::path& file, const fs::path& folder) {
  const fs::path inside = Canonical(file).lexically_relative(Canonical(folder));
  return !inside.empty() && *inside.begin() != "..";
}

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The folders in a folder, sorted, hidden ones and symbolic links left out.
std::vector<fs::path> FoldersIn(const fs::path& folder) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (folders.size() >= kMaxFoldersSearched) break;
    const bool hidden = at->path().filename().string().rfind('.', 0) == 0;
    std::error_code unknown;
    if (!hidden && at->symlink_status(unknown).type() == fs::file_type::directory) {
      folders.push_back(at->path());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// The first folder of that package below `top`, two deep, the nearer first.
std::optional<fs::path> FindBelow(const fs::path& top, const std::string& package) {
  std::vector<fs::path> level{top};
  std::size_t searched = 0;
  for (int depth = 0; depth < 2; ++depth) {
    std::vector<fs::path> next;
    for (const fs::path& folder : level) {
      for (fs::path& inner : FoldersIn(folder)) {
        if (++searched > kMaxFoldersSearched) return std::nullopt;
        if (PackageNameOf(inner) == package) return inner;
        next.push_back(std::move(inner));
      }
    }
    level = std::move(next);
  }
  return std::nullopt;
}

/// The file as the address says it, or with its %20 read as a space.
fs::path Written(const fs::path& folder, const std::string& path) {
  const fs::path file = folder / path;
  const auto decoded = PercentDecoded(path);
  return !IsFile(file) && decoded && IsFile(folder / *decoded) ? folder / *decoded : file;
}

/// @param advice  the end of the message about a path that leads out of the folder
fs::path FileIn(const fs::path& folder, const fs::path& file, const std::string& address,
                const std::string& place, const std::string& advice = {}) {
  if (!LiesIn(file, folder)) {
    RefuseAddress(place, "expected a path inside '" + folder.string() + "', found '" + address +
                             "' (it leads out of it)" + advice);
  }
  const fs::path plain = file.lexically_normal();
  if (IsFile(file)) return plain;
  RefuseAddress(place,
                "expected a file, found none at '" + plain.string() + "'" + DidYouMeanFile(plain));
}

/// Whether ROS packages keep their URDF files in a folder of that name, with meshes next to it.
bool IsUrdfFolder(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name == "urdf" || name == "xacro" || name == "robots";
}

/// The rest of the address behind the scheme, none for another one.
std::optional<std::string> Behind(std::string_view scheme, const std::string& address) {
  if (address.rfind(scheme, 0) != 0) return std::nullopt;
  return address.substr(scheme.size());
}

}  // namespace

std::string PackageNameOf(const fs::path& folder) {
  const fs::path file = folder / "package.xml";
  try {
    if (!IsFile(file)) return IsFile(folder / "model.config") ? folder.filename().string() : "";
    const std::string text = ReadText(file);
    if (ScanXml(text)) return "";
    TiXmlDocument document;
    document.Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
    const TiXmlElement* package = document.FirstChildElement("package");
    const TiXmlElement* name = package == nullptr ? nullptr : package->FirstChildElement("name");
    const std::string found = name != nullptr && name->GetText() != nullptr ? name->GetText() : "";
    const std::size_t begin = found.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return "";
    return found.substr(begin, found.find_last_not_of(" \t\r\n") - begin + 1);
  } catch (const ConfigError&) {
    return "";  // no package that anybody could name
  }
}

fs::path PackageFileAbove(const fs::path& folder) {
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path()) {
    if (PackageNameOf(at).empty()) continue;
    return at / (IsFile(at / "package.xml") ? "package.xml" : "model.config");
  }
  return {};
}

MeshAddresses::MeshAddresses(std::string urdf_file, PackageFolders packages)
    : urdf_file_(std::move(urdf_file)), packages_(std::move(packages)) {
  FindRoot();
}

void MeshAddresses::FindRoot() {
  root_ = Canonical(fs::path(urdf_file_).parent_path());
  for (fs::path folder = root_; folder != folder.root_path(); folder = folder.parent_path()) {
    if (folder.empty()) break;
    if (!PackageNameOf(folder).empty()) above_.push_back(folder);
  }
  if (!above_.empty()) {
    root_ = above_.front();
  } else if (IsUrdfFolder(root_) && root_.parent_path().has_relative_path()) {
    root_ = root_.parent_path();
  }
}

fs::path MeshAddresses::FolderOf(const std::string& package, const std::string& place) {
  const auto given = packages_.find(package);
  if (given != packages_.end()) return given->second;
  std::string searched;
  const auto keep = [&](const fs::path& folder) {
    packages_[package] = folder.string();
    return folder;
  };
  for (const fs::path& folder : above_) {
    if (PackageNameOf(folder) == package) return keep(folder);
  }
  std::vector<fs::path> tops = above_;
  for (const fs::path& folder : above_) {
    const bool fresh = std::find(tops.begin(), tops.end(), folder.parent_path()) == tops.end();
    if (fresh && folder.has_relative_path()) tops.push_back(folder.parent_path());
  }
  for (const fs::path& top : tops) {
    if (const auto found = FindBelow(top, package)) return keep(*found);
    searched += ", '" + top.string() + "'";
  }
  RefuseAddress(
      place,
      "expected the ROS package '" + package + "', found no package.xml of that name in '" +
          Canonical(fs::path(urdf_file_).parent_path()).string() + "', the folders above it" +
          (searched.empty() ? std::string() : " and two folders deep in" + searched.substr(1)) +
          "; name its folder (check takes --package " + package +
          "=DIR), or write the mesh's path relative to the file");
}

fs::path MeshAddresses::Resolve(const std::string& address, const std::string& place) {
  const auto refuse = [&](const std::string& why) {
    RefuseAddress(
        place, "expected a path inside the model's folder, found '" + address + "' (" + why + ")");
  };
  if (address.empty()) refuse("it is empty");
  for (const char* scheme : {"package://", "model://"}) {
    const auto rest = Behind(scheme, address);
    if (!rest) continue;
    const std::size_t slash = rest->find('/');
    if (slash == std::string::npos || slash == 0 || slash + 1 >= rest->size()) {
      refuse(std::string("expected ") + scheme + "NAME/PATH");
    }
    const fs::path folder = FolderOf(rest->substr(0, slash), place);
    const fs::path inside = fs::path(rest->substr(slash + 1)).relative_path();
    return FileIn(folder, Written(folder, inside.string()), address, place);
  }
  const std::string path = Behind("file://", address).value_or(address);
  if (path.find("://") != std::string::npos) {
    refuse("of addresses only package://, model:// and file:// are followed");
  }
  if (fs::path(path).is_absolute()) {
    const fs::path file = Written("/", fs::path(path).relative_path().string());
    std::vector<fs::path> folders{root_};
    for (const auto& [name, folder] : packages_) folders.push_back(folder);
    for (const fs::path& folder : folders) {
      if (LiesIn(file, folder)) return FileIn(folder, file, address, place);
    }
    refuse(
        "it is absolute and leads elsewhere; copy the mesh next to the file and write a relative "
        "path, or write package://NAME/PATH and check it with --package NAME=DIR");
  }
  if (path != address) refuse("expected file:/// and an absolute path");
  const fs::path own = fs::path(urdf_file_).parent_path();
  const std::string advice = root_ != Canonical(own)
                                 ? ""
                                 : "; a file in a ROS package, or in a folder named urdf, xacro or "
                                   "robots, may name meshes next to its folder";
  return FileIn(root_, Written(own, address), address, place, advice);
}

}  // namespace dockyard
