#include "models/read/as_built.h"

#include <algorithm>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/yaml_path.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

using Kind = YamlNode::Kind;

const Range kAny = Between(-1e12, 1e12);

bool IsDeviation(const YamlNode& node) {
  return node.kind == Kind::kMapping && !node.keys.empty() &&
         std::all_of(node.keys.begin(), node.keys.end(), [](const YamlNode::Key& key) {
           return key.name == "times" || key.name == "plus";
         });
}

void Deviate(YamlNode& number, const YamlNode& deviation, const std::string& path) {
  const YamlReader in(deviation, path, {"times", "plus"});
  double told = 0.0;
  if (number.kind != Kind::kScalar || !ParseNumber(number.scalar, told)) {
    throw ConfigError(deviation.place.Text() + ": " + path +
                      ": expected a value: only a number can be built by times and plus, this is " +
                      number.Found());
  }
  const double built = told * in.NumberOr("times", 1.0, kAny) + in.NumberOr("plus", 0.0, kAny);
  number.scalar = NumberText(built);
  number.place = deviation.items[0].place;
}

}  // namespace

void PutBuilt(YamlNode& tree, const YamlNode& built, const std::string& path) {
  if (built.kind != Kind::kMapping) {
    tree = built;  // its reader refuses it
    return;
  }
  for (std::size_t i = 0; i < built.keys.size(); ++i) {
    const YamlNode::Key& key = built.keys[i];
    const YamlNode& value = built.items[i];
    const std::string inner = path.empty() ? key.name : path + "." + key.name;
    const auto at =
        std::find_if(tree.keys.begin(), tree.keys.end(),
                     [&](const YamlNode::Key& known) { return known.name == key.name; });
    if (at == tree.keys.end()) {
      if (IsDeviation(value)) {
        throw ConfigError(key.place.Text() + ": " + inner +
                          ": expected a value: the model has no such number to be built by times "
                          "and plus");
      }
      tree.keys.push_back(key);
      tree.items.push_back(value);
      continue;
    }
    YamlNode& told = tree.items[static_cast<std::size_t>(at - tree.keys.begin())];
    at->place = key.place;
    if (value.kind == Kind::kMapping && told.kind == Kind::kMapping) {
      PutBuilt(told, value, inner);
    } else if (value.kind == Kind::kMapping && !value.keys.empty()) {
      Deviate(told, value, inner);
    } else {
      told = value;
    }
  }
}

void PutIfLeftOut(YamlNode& tree, const std::string& path, double value) {
  const std::size_t dot = path.find('.');
  const std::string first = path.substr(0, dot);
  const bool last = dot == std::string::npos;
  YamlNode* inner = FindPath(tree, first);
  if (inner == nullptr) {
    YamlNode added;
    added.kind = last ? Kind::kScalar : Kind::kMapping;
    added.place = tree.place;
    if (last) added.scalar = NumberText(value);
    tree.keys.push_back({first, tree.place});
    tree.items.push_back(std::move(added));
    inner = &tree.items.back();
  }
  if (!last && inner->kind == Kind::kMapping) PutIfLeftOut(*inner, path.substr(dot + 1), value);
}

}  // namespace dockyard
