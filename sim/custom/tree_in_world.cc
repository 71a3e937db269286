#include "sim/custom/tree_in_world.h"

#include <algorithm>
#include <utility>

namespace dockyard::custom {

TreeInWorld AddTree(const LinkTree& model, const std::vector<CommandedJoint>& motors,
                    const Pose3& X_GB, TreeBase base, RigidWorld& world) {
  std::vector<TreeLink> links(1);
  links[0].model.mass_kg = model.root.mass_kg;
  links[0].model.p_LoCom_L = model.root.p_LoCom_L;
  links[0].model.I_LCom_L = model.root.I_LCom_L;
  TreeInWorld tree;
  tree.places = AddJointedLinks(model.joints, {0}, links);
  for (const CommandedJoint& motor : motors) {
    links[static_cast<std::size_t>(tree.Place(motor.link))].rotor_kg_m2 = motor.rotor_kg_m2;
  }
  tree.body = world.Add(
      TreeBody(std::move(links), TiesOf(model.joints, tree.places), X_GB, {.base = base}));
  SetStartAngles(model.joints, tree.places, world.body(tree.body));
  LimitJoints(model.joints, tree.places, tree.body, world);
  return tree;
}

std::vector<LinkSolid> SolidsOf(const LinkTree& model, const std::vector<int>& without) {
  std::vector<LinkSolid> solids;
  for (int i = 0; i < model.link_count(); ++i) {
    if (std::find(without.begin(), without.end(), i) != without.end()) continue;
    for (const Collision& part : model.link(i).collisions) solids.push_back({i, SolidOf(part)});
  }
  return solids;
}

}  // namespace dockyard::custom
