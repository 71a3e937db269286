#include "sim/scenario/short_forms.h"

#include <algorithm>
#include <string>
#include <utility>

#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

/// Takes a key out of a mapping; kNull: there is none.
YamlNode Take(YamlNode& mapping, const std::string& name) {
  for (std::size_t i = 0; i < mapping.keys.size(); ++i) {
    if (mapping.keys[i].name != name) continue;
    YamlNode value = std::move(mapping.items[i]);
    mapping.keys.erase(mapping.keys.begin() + static_cast<std::ptrdiff_t>(i));
    mapping.items.erase(mapping.items.begin() + static_cast<std::ptrdiff_t>(i));
    return value;
  }
  return {};
}

/// {urdf: U, file: F} and no other keys.
bool NamesModelFiles(const YamlNode& node) {
  return node.kind == YamlNode::Kind::kMapping && node.Find("file") != nullptr &&
         std::all_of(node.keys.begin(), node.keys.end(), [](const YamlNode::Key& key) {
           return key.name == "file" || key.name == "urdf";
         });
}

/// Splits such a mapping under the dotted key `path` of the root. model: under `changes`.
void SplitModelFiles(YamlNode& root, const std::string& path, const std::string& model) {
  YamlNode* files = FindPath(root, path);
  if (files == nullptr || !NamesModelFiles(*files)) return;
  const YamlNode urdf = Take(*files, "urdf");
  YamlNode file = Take(*files, "file");
  *files = std::move(file);
  if (urdf.kind != YamlNode::Kind::kNull)
    PutPath(root, "changes." + model + ".urdf", urdf.place, urdf);
}

void MoveUnder(YamlNode& root, const std::string& system, const std::string& name) {
  for (std::size_t i = 0; i < root.keys.size(); ++i) {
    if (root.keys[i].name != name) continue;
    const YamlPlace place = root.keys[i].place;
    const YamlNode value = Take(root, name);
    PutPath(root, system + "." + name, place, value);
    return;
  }
}

}  // namespace

YamlNode WithoutShortForms(YamlNode root, const std::vector<KnownSystem>& systems) {
  const YamlNode* name = root.kind == YamlNode::Kind::kMapping ? root.Find("system") : nullptr;
  if (name == nullptr) return root;
  const auto system = std::find_if(systems.begin(), systems.end(), [&](const KnownSystem& each) {
    return each.name == name->scalar;
  });
  if (system == systems.end()) return root;
  for (const std::string& key : system->root_keys) MoveUnder(root, system->name, key);
  for (const ModelRoot& model : system->model_roots) {
    SplitModelFiles(root, model.file_key, model.name);
  }
  return root;
}

}  // namespace dockyard
