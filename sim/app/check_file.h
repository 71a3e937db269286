// Recognises the kind of an input file and checks the file, for `dockyard check`.
#pragma once

#include <string>
#include <vector>

#include "models/read/urdf.h"
#include "sim/run/system.h"

namespace dockyard {

struct CheckOptions {
  PackageFolders packages = {};  // for the meshes of a URDF file
};

/// Reads the file and every file that it names. The kind comes from the extension, for YAML from
/// the keys; the systems recognise files of their own. A URDF file with macros is expanded by the
/// program xacro. Throws ConfigError with the first fault, also for a file of unknown kind.
FileCheck CheckFile(const std::string& file, const std::vector<System>& systems,
                    const CheckOptions& options = {});

/// All faults of the file, each as CheckFile reports it: every one of a URDF file, of any other
/// kind the first, or all of the URDF file in which that lies; and the elements left out.
UrdfFindings FindFaults(const std::string& file, const std::vector<System>& systems,
                        const CheckOptions& options);

}  // namespace dockyard
