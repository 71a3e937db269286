#include "models/read/urdf_tree.h"

#include <map>
#include <set>
#include <vector>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

// Parsers and the code after them recurse from link to link.
constexpr std::size_t kMaxLinks = 1000;

class TreeCheck {
 public:
  TreeCheck(const TiXmlElement& robot, std::string file) : file_(std::move(file)) {
    for (const TiXmlElement* e = robot.FirstChildElement("link"); e;
         e = e->NextSiblingElement("link")) {
      if (links_.size() >= kMaxLinks) Refuse(*e, "more than 1000 links");
      links_.push_back(e);
    }
    for (const TiXmlElement* e = robot.FirstChildElement("joint"); e;
         e = e->NextSiblingElement("joint")) {
      TakeJoint(*e);
    }
  }

  void Run() const {
    std::set<std::string> largest;
    std::string root;
    for (const TiXmlElement* link : links_) {
      const std::string name = link->Attribute("name");
      if (parent_joint_.count(name) > 0) continue;
      const std::set<std::string> reached = ReachedFrom(name);
      if (reached.size() <= largest.size()) continue;
      largest = reached;
      root = name;
    }
    for (const TiXmlElement* link : links_) {
      const std::string name = link->Attribute("name");
      if (largest.count(name) > 0) continue;
      if (parent_joint_.count(name) == 0) {
        Refuse(*link, "'" + name + "' hangs on no joint, expected one tree" +
                          (root.empty() ? "" : ", its root is '" + root + "'"));
      }
      if (root.empty() || InCircle(name)) {
        Refuse(*parent_joint_.at(name), "joints in a circle, expected a tree");
      }
    }
  }

 private:
  [[noreturn]] void Refuse(const TiXmlElement& at, const std::string& what) const {
    throw ConfigError(Place(at) + ": <" + at.Value() + ">: " + what);
  }
  std::string Place(const TiXmlElement& at) const {
    return file_ + ":" + std::to_string(at.Row()) + ":" + std::to_string(at.Column());
  }

  void TakeJoint(const TiXmlElement& joint) {
    const std::string parent = joint.FirstChildElement("parent")->Attribute("link");
    const std::string child = joint.FirstChildElement("child")->Attribute("link");
    const auto [at, fresh] = parent_joint_.emplace(child, &joint);
    if (!fresh) {
      Refuse(joint,
             "link '" + child + "' is the child of two joints, the first at " + Place(*at->second));
    }
    parent_[child] = parent;
    children_[parent].push_back(child);
  }

  std::set<std::string> ReachedFrom(const std::string& root) const {
    std::set<std::string> reached{root};
    std::vector<std::string> open{root};
    while (!open.empty()) {
      const auto at = children_.find(open.back());
      open.pop_back();
      if (at == children_.end()) continue;
      for (const std::string& child : at->second) {
        if (reached.insert(child).second) open.push_back(child);
      }
    }
    return reached;
  }

  /// Whether the way up from the link never ends.
  bool InCircle(const std::string& link) const {
    std::set<std::string> seen;
    for (auto at = parent_.find(link); at != parent_.end(); at = parent_.find(at->second)) {
      if (!seen.insert(at->first).second) return true;
    }
    return false;
  }

  std::string file_;
  std::vector<const TiXmlElement*> links_;
  std::map<std::string, const TiXmlElement*> parent_joint_;  // by child link
  std::map<std::string, std::string> parent_;                // link by child link
  std::map<std::string, std::vector<std::string>> children_;
};

}  // namespace

void CheckUrdfTree(const TiXmlElement& robot, const std::string& file) {
  TreeCheck(robot, file).Run();
}

}  // namespace dockyard
