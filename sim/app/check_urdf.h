// The check of URDF files: those that are given, and those that models and scenarios name.
#pragma once

#include <map>
#include <set>
#include <string>

#include "models/read/urdf.h"
#include "sim/run/system.h"

namespace dockyard {

/// A check of a URDF file also expands macros.
UrdfOptions UrdfCheckOptions(const PackageFolders& packages);

/// Throws ConfigError.
FileCheck CheckUrdf(const std::string& file, const PackageFolders& packages);

/// The URDF files that models name, each once.
class NamedUrdfs {
 public:
  /// A model's YAML file.
  void AddModel(const std::string& yaml);
  /// The models of a scenario, with its `changes` and `as_built`.
  void AddScenario(const Scenario& scenario, const System& system);

  const std::set<std::string>& files() const { return files_; }

 private:
  const std::string& UrdfOf(const std::string& yaml);

  std::map<std::string, std::string> by_model_;  // empty: it names none
  std::set<std::string> files_;
};

/// The check of a file whose URDF files load, with what a check of each of them warns of and has
/// left out. Throws ConfigError.
FileCheck WithUrdfs(const NamedUrdfs& urdfs, FileCheck check);

}  // namespace dockyard
