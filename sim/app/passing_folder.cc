#include "sim/app/passing_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "sim/base/files.h"

namespace dockyard {

PassingFolder::PassingFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "dockyard_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw IoErrorFromErrno("make folder", name);
  path_ = name;
}

PassingFolder::~PassingFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace dockyard
