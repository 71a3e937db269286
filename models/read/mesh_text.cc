#include "models/read/mesh_text.h"

#include <algorithm>

#include "models/read/config_error.h"
#include "models/read/xml_scan.h"

namespace dockyard {

void RefuseMeshText(const std::string& file, std::string_view text, std::size_t begin,
                    std::size_t end, const std::string& expected) {
  const std::string found(text.substr(begin, std::min<std::size_t>(end - begin, 40)));
  throw ConfigError(file + ":" + LineAndColumn(text, begin) + ": not a usable mesh: expected " +
                    expected + ", found '" + found + "'");
}

}  // namespace dockyard
