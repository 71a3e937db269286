// A URDF's frames and joints as a tree of links.
#include "models/read/load_link_tree.h"

#include <gmock/gmock.h>

#include "models/read/config_error.h"
#include "support/bad_files.h"
#include "support/urdf_text.h"

namespace dockyard {
namespace {

std::string Link(const std::string& name, double mass_kg) {
  return "<link name=\"" + name + "\">" +
         (mass_kg > 0.0 ? InertialOfBox(mass_kg, {0.1, 0.1, 0.1}) : "") + "</link>";
}

std::string Joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& xyz, const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"" + xyz + "\"/>" + more + "</joint>";
}

/// base - mast (turns about z) - head (fixed) and lift (slides along z).
LinkTree TreeOf(const std::string& joints) {
  const ScratchFolder folder;
  const std::string limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
  folder.Write(
      "tree.urdf",
      "<robot name=\"t\">" + Link("base", 2.0) + Link("mast", 1.0) + Link("head", 0.0) +
          Link("lift", 0.5) +
          Joint("turn", "revolute", "base", "mast", "0.1 0 0.2", "<axis xyz=\"0 0 1\"/>" + limit) +
          Joint("neck", "fixed", "mast", "head", "0 0.3 0") +
          Joint("lifts", "prismatic", "head", "lift", "0 0 0.05", "<axis xyz=\"0 0 1\"/>" + limit) +
          "</robot>");
  const YamlNode root = ParseYaml(joints, "tree.yaml");
  JointsFile file;
  const auto visit = [&](Keys& keys) { VisitJoints(keys, file); };
  ReadKeys(root, "", visit);
  return TakeLinkTree(YamlReader(root, "", KeyNames(visit)),
                      LoadUrdf((folder.path() / "tree.urdf").string()), file);
}

TEST(LinkTree, NamesEveryLinkAsAFrameInTheLinkThatCarriesIt) {
  const LinkTree tree = TreeOf("{}");
  EXPECT_EQ(tree.link_count(), 3);
  const NamedFrame& head = RequireFrame(tree, "head", "x");
  EXPECT_EQ(tree.link(head.link).name, "mast");
  EXPECT_TRUE(head.X_LF.p.isApprox(Eigen::Vector3d(0.0, 0.3, 0.0)));
  EXPECT_EQ(RequireFrame(tree, "base", "x").link, 0);
  EXPECT_DOUBLE_EQ(tree.mass_kg(), 3.5);
}

TEST(LinkTree, PutsLinksWhereTheirJointsStart) {
  const LinkTree tree =
      TreeOf("joints: [{name: turn, start_deg: 30}, {name: lifts, start_m: 0.4}]");
  const std::vector<Pose3> X_RL = StartPoses(tree);
  const int lift = tree.LinkOfJoint("lifts");
  // 0.1 ahead, then 0.3 to the left of the turned mast, then up.
  const double angle = Radians(30.0);
  const Eigen::Vector3d expected(0.1 - 0.3 * std::sin(angle), 0.3 * std::cos(angle),
                                 0.2 + 0.05 + 0.4);
  EXPECT_TRUE(X_RL[static_cast<std::size_t>(lift)].p.isApprox(expected, 1e-12));
}

TEST(LinkTree, RefusesAFrameThatIsNotThereWithTheNearestName) {
  const LinkTree tree = TreeOf("{}");
  try {
    RequireFrame(tree, "haed", "robot.yaml:3:5: cameras[0].link");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "robot.yaml:3:5: cameras[0].link: expected a link of the URDF file, found 'haed', "
                 "did you mean 'head'?");
  }
}

}  // namespace
}  // namespace dockyard
