#include "models/read/yaml_path.h"

#include <utility>

namespace dockyard {

const YamlNode* FindPath(const YamlNode& tree, std::string_view path) {
  const std::size_t dot = path.find('.');
  const YamlNode* found = tree.Find(path.substr(0, dot));
  const bool last = found == nullptr || dot == std::string_view::npos;
  return last ? found : FindPath(*found, path.substr(dot + 1));
}

YamlNode* FindPath(YamlNode& tree, std::string_view path) {
  return const_cast<YamlNode*>(FindPath(std::as_const(tree), path));
}

}  // namespace dockyard
