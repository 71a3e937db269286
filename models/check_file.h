// What kind of input file is this, and is it good? For `dockyard check`.
#pragma once

#include <string>

namespace dockyard {

struct FileCheck {
  std::string kind;     // rover | station | soil | camera | rig | scenario | campaign | urdf | mesh
  std::string summary;  // one line: what it holds
};

/// Reads the file and everything that it names. The kind comes from the extension, for YAML from
/// the keys. Throws ConfigError with the first fault, also when it is of no kind that is known.
FileCheck CheckFile(const std::string& file);

}  // namespace dockyard
