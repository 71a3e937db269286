#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "models/read/collada_parts.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr long kMaxNodes = 10000;  // instances followed
constexpr int kMaxDepth = 64;

class SceneCheck {
 public:
  explicit SceneCheck(std::string file) : file_(std::move(file)) {}

  void Run(const TiXmlElement& collada) {
    for (const char* library : {"library_nodes", "library_visual_scenes"}) {
      for (const TiXmlElement* e = collada.FirstChildElement(library); e;
           e = e->NextSiblingElement(library)) {
        for (const TiXmlElement* top = e->FirstChildElement(); top;
             top = top->NextSiblingElement()) {
          TakeNode(*top);
        }
      }
    }
    for (const TiXmlElement* node : nodes_) {
      if (ExtentOf(*node, 0).nodes > kMaxNodes) {
        RefuseElement(file_, *node, "more than 10000 nodes once instances are followed");
      }
    }
  }

 private:
  /// A node, or a scene, which can be instanced like one.
  void TakeNode(const TiXmlElement& node) {
    if (nodes_.size() >= static_cast<std::size_t>(kMaxNodes)) {
      RefuseElement(file_, node, "more than 10000 nodes");
    }
    nodes_.push_back(&node);
    for (const char* attribute : {"id", "sid", "name"}) {
      if (const char* name = node.Attribute(attribute)) named_[name].insert(&node);
    }
    for (const TiXmlElement* e = node.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string name = e->Value();
      if (name == "node") TakeNode(*e);
      if (name == "instance_controller") RefuseElement(file_, *e, "skinned meshes are not read");
      CheckTransform(*e, name);
    }
  }

  void CheckTransform(const TiXmlElement& element, const std::string& name) const {
    static const std::map<std::string, int> counts{{"lookat", 9}, {"matrix", 16},   {"rotate", 4},
                                                   {"scale", 3},  {"translate", 3}, {"skew", 7}};
    const auto count = counts.find(name);
    if (count == counts.end()) return;
    std::string_view text = TextOf(file_, element);
    int found = 0;
    double value = 0.0;
    for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text)) {
      found += ParseNumber(word, value) ? 1 : 100;
    }
    if (found != count->second) {
      RefuseElement(file_, element, "expected " + std::to_string(count->second) + " numbers");
    }
  }

  /// Nodes below and with this one, instances followed, at most one more than allowed; and levels.
  struct Extent {
    long nodes = 1;
    int levels = 1;
  };
  Extent ExtentOf(const TiXmlElement& node, int depth) {
    const auto known = extents_.find(&node);
    if (known != extents_.end()) return known->second;
    Extent extent;
    const auto add = [&](const TiXmlElement& child) {
      const Extent below = depth < kMaxDepth ? ExtentOf(child, depth + 1) : Extent{1, kMaxDepth};
      extent.nodes = std::min(extent.nodes + below.nodes, kMaxNodes + 1);
      extent.levels = std::max(extent.levels, below.levels + 1);
      if (extent.levels <= kMaxDepth) return;
      RefuseElement(file_, node, "nodes nested deeper than 64 levels once instances are followed");
    };
    for (const TiXmlElement* e = node.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string name = e->Value();
      if (name == "node") add(*e);
      const char* url = name == "instance_node" ? e->Attribute("url") : nullptr;
      if (url == nullptr || *url != '#') continue;
      // An importer may find the instanced node by its id or by its name.
      for (const TiXmlElement* target : named_[url + 1]) add(*target);
    }
    return extents_[&node] = extent;
  }

  std::string file_;
  std::vector<const TiXmlElement*> nodes_;
  std::map<std::string, std::set<const TiXmlElement*>> named_;
  std::map<const TiXmlElement*, Extent> extents_;
};

}  // namespace

void CheckColladaScene(const std::string& file, const TiXmlElement& collada) {
  SceneCheck(file).Run(collada);
}

}  // namespace dockyard
