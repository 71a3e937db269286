#include "models/read/urdf_tree.h"

#include <map>
#include <set>
#include <vector>

namespace dockyard {
namespace {

// Parsers and the code after them recurse from link to link.
constexpr std::size_t kMaxLinks = 1000;

class TreeCheck {
 public:
  TreeCheck(const TiXmlElement& robot, UrdfFaults& faults) : faults_(faults) {
    for (const TiXmlElement* e = robot.FirstChildElement("link"); e;
         e = e->NextSiblingElement("link")) {
      links_.push_back(e);
      if (links_.size() <= kMaxLinks) continue;
      faults_.Add(*e, "more than 1000 links");
      return;
    }
    for (const TiXmlElement* e = robot.FirstChildElement("joint"); e;
         e = e->NextSiblingElement("joint")) {
      TakeJoint(*e);
    }
  }

  void Run() {
    if (links_.size() > kMaxLinks) return;
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
        faults_.Add(*link, "'" + name + "' hangs on no joint, expected one tree" +
                               (root.empty() ? "" : ", its root is '" + root + "'"));
      } else if (root.empty() || InCircle(name)) {
        TakeCircle(name);
      }
    }
  }

 private:
  void TakeJoint(const TiXmlElement& joint) {
    const std::string parent = joint.FirstChildElement("parent")->Attribute("link");
    const std::string child = joint.FirstChildElement("child")->Attribute("link");
    const auto [at, fresh] = parent_joint_.emplace(child, &joint);
    if (!fresh) {
      faults_.Add(joint, "link '" + child + "' is the child of two joints, the first at " +
                             faults_.PlaceOf(*at->second));
      return;
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

  /// One fault a circle, not one for each link that hangs on it.
  void TakeCircle(const std::string& link) {
    bool fresh = true;
    std::set<std::string> circle;
    for (auto at = parent_.find(link); at != parent_.end(); at = parent_.find(at->second)) {
      if (!circle.insert(at->first).second) break;
      fresh = fresh && in_circles_.count(at->first) == 0;
    }
    if (fresh) faults_.Add(*parent_joint_.at(link), "joints in a circle, expected a tree");
    in_circles_.insert(circle.begin(), circle.end());
  }

  UrdfFaults& faults_;
  std::set<std::string> in_circles_;
  std::vector<const TiXmlElement*> links_;
  std::map<std::string, const TiXmlElement*> parent_joint_;  // by child link
  std::map<std::string, std::string> parent_;                // link by child link
  std::map<std::string, std::vector<std::string>> children_;
};

}  // namespace

void CheckUrdfTree(const TiXmlElement& robot, UrdfFaults& faults) {
  TreeCheck(robot, faults).Run();
}

}  // namespace dockyard
