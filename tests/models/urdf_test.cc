#include "models/urdf.h"

#include <gmock/gmock.h>

#include "bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string MessageFor(const std::string& text) {
  const ScratchFolder folder;
  folder.Write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string file = folder.Write("m.urdf", text);
  return MessageOf([&] { LoadUrdf(file); }, folder);
}

/// A robot of one link with this inside.
std::string Link(const std::string& inside) {
  return "<robot name=\"m\">\n <link name=\"a\">" + inside + "</link>\n</robot>\n";
}

std::string Inertial(const std::string& mass, const std::string& ixx, const std::string& iyy,
                     const std::string& izz) {
  return Link("<inertial><mass value=\"" + mass + "\"/><inertia ixx=\"" + ixx +
              "\" ixy=\"0\" ixz=\"0\" iyy=\"" + iyy + "\" iyz=\"0\" izz=\"" + izz +
              "\"/></inertial>");
}

std::string Visual(const std::string& geometry) {
  return Link("<visual><geometry>" + geometry + "</geometry></visual>");
}

TEST(Urdf, LinkWithASoundMeshLoads) {
  EXPECT_EQ(MessageFor(Visual("<mesh filename=\"mesh.obj\"/>")), "(no error)");
  EXPECT_EQ(MessageFor(Inertial("2", "1", "1", "1")), "(no error)");
}

TEST(Urdf, TurnsInertiaIntoTheLinksAxes) {
  const ScratchFolder folder;
  const std::string text =
      Replaced(Inertial("2", "1", "2", "2.5"), "<mass",
               "<origin xyz=\"0.1 0.2 0.3\" rpy=\"0 0 1.5707963267948966\"/><mass");
  const UrdfModel model = LoadUrdf(folder.Write("m.urdf", text));
  const LinkModel& link = model.Link("a");
  EXPECT_NEAR(link.I_LCom_L(0, 0), 2.0, 1e-12);
  EXPECT_NEAR(link.I_LCom_L(1, 1), 1.0, 1e-12);
  EXPECT_NEAR(link.I_LCom_L(2, 2), 2.5, 1e-12);
  EXPECT_EQ(link.p_LoCom_L, Eigen::Vector3d(0.1, 0.2, 0.3));
}

TEST(Urdf, XmlErrorsTellLineAndColumn) {
  EXPECT_THAT(MessageFor("<robot name=\"m\">\n<link name=\"a\">\n</robot>\n"),
              testing::MatchesRegex("m\\.urdf:[0-9]+:[0-9]+: not valid XML: .*"));
  EXPECT_THAT(MessageFor("<a/>"), HasSubstr("expected a <robot> element"));
}

TEST(Urdf, MassesAndInertiasThatNoBodyHasAreRefused) {
  EXPECT_EQ(MessageFor(Inertial("-1", "1", "1", "1")),
            "m.urdf:2:2: link 'a': mass: expected a number > 0, found '-1'");
  EXPECT_EQ(MessageFor(Inertial("1e9", "1", "1", "1")),
            "m.urdf:2:2: link 'a': mass: expected a number > 0 and <= 1e+05, found '1e+09'");
  const std::string impossible =
      "m.urdf:2:2: link 'a': inertia: expected principal moments > 0 of which none exceeds the sum "
      "of the others";
  EXPECT_EQ(MessageFor(Inertial("1", "1", "1", "2.1")), impossible);
  EXPECT_EQ(MessageFor(Inertial("1", "0", "1", "1")), impossible);
  EXPECT_EQ(MessageFor(Inertial("1", "-1", "1", "1")), impossible);
}

TEST(Urdf, NumbersThatAreNoneAreRefused) {
  for (const char* bad : {"nan", "inf", "ten", "", "1e999"}) {
    EXPECT_THAT(MessageFor(Inertial(bad, "1", "1", "1")), StartsWith("m.urdf")) << bad;
    EXPECT_THAT(MessageFor(Inertial("1", bad, "1", "1")), StartsWith("m.urdf")) << bad;
    EXPECT_THAT(MessageFor(Visual("<sphere radius=\"" + std::string(bad) + "\"/>")),
                StartsWith("m.urdf"))
        << bad;
  }
}

TEST(Urdf, NumbersAreToldWithTheirOwnPlace) {
  EXPECT_EQ(MessageFor(Inertial("ten", "1", "1", "1")),
            "m.urdf:2:27: <mass>: value: expected a number, found 'ten'");
  EXPECT_EQ(MessageFor(Visual("<box size=\"1 2\"/>")),
            "m.urdf:2:35: <box>: size: expected 3 numbers, found '1 2'");
}

TEST(Urdf, NamesAndReferencesMustMatch) {
  const auto robot = [](const std::string& inside) {
    return MessageFor("<robot name=\"m\">\n" + inside + "\n</robot>\n");
  };
  EXPECT_EQ(robot("<link/>"), "m.urdf:2:1: <link>: missing attribute 'name'");
  EXPECT_EQ(robot("<link name=\"a\"/>\n<link name=\"a\"/>"),
            "m.urdf:3:1: <link>: 'a' is given twice, first at m.urdf:2:1");
  EXPECT_EQ(robot("<link name=\"a\"/>\n<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/>\n"
                  "<child link=\"b\"/></joint>"),
            "m.urdf:4:1: <child>: expected the name of a link, found 'b'");
  EXPECT_THAT(robot("<link name=\"a\"/>\n<joint name=\"j\" type=\"hinge\"/>"),
              HasSubstr("m.urdf:3:1: <joint>: type: expected continuous, fixed, floating"));
}

TEST(Urdf, SizesMustBePositive) {
  EXPECT_THAT(MessageFor(Visual("<box size=\"1 0 1\"/>")),
              HasSubstr("box size: expected a number > 0, found '0'"));
  EXPECT_THAT(MessageFor(Visual("<cylinder radius=\"0.1\" length=\"1e5\"/>")),
              HasSubstr("cylinder length: expected a number > 0 and <= 100, found '1e+05'"));
}

TEST(Urdf, MeshesStayInsideTheModelsFolder) {
  const auto message = [](const std::string& filename) {
    return MessageFor(Visual("<mesh filename=\"" + filename + "\"/>"));
  };
  EXPECT_EQ(message("none.obj"),
            "m.urdf:2:2: link 'a': mesh filename: expected a file, found none at 'none.obj'");
  EXPECT_THAT(message("../mesh.obj"), HasSubstr("(it leads out of it)"));
  EXPECT_THAT(message("x/../../mesh.obj"), HasSubstr("(it leads out of it)"));
  EXPECT_THAT(message("/etc/passwd"), HasSubstr("(it is absolute)"));
  EXPECT_THAT(message("package://axel/mesh.obj"), HasSubstr("package:// or file:// are not"));
  EXPECT_THAT(message("file:///etc/passwd"), HasSubstr("package:// or file:// are not"));
}

TEST(Urdf, SymbolicLinksDoNotLeadOut) {
  const ScratchFolder outside, folder;
  const std::string target = outside.Write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::create_symlink(target, folder.path() / "link.obj");
  const std::string file = folder.Write("m.urdf", Visual("<mesh filename=\"link.obj\"/>"));
  EXPECT_THAT(MessageOf([&] { LoadUrdf(file); }, folder), HasSubstr("(it leads out of it)"));
}

TEST(Urdf, IsNotNestedWithoutBoundNorHasADoctype) {
  std::string deep = "<robot name=\"m\">";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THAT(MessageFor(deep), HasSubstr("nested deeper than 64 levels"));
  EXPECT_THAT(MessageFor("<!DOCTYPE x [<!ENTITY a \"b\">]><robot name=\"m\"/>"),
              HasSubstr("DOCTYPE"));
}

TEST(Urdf, ModelsHereHaveTheirNamedParts) {
  const UrdfModel axel = LoadUrdf(SourceFile("models/axel/axel.urdf"));
  EXPECT_EQ(axel.root, "body");
  EXPECT_EQ(axel.links.size(), 4u);
  EXPECT_EQ(axel.Joint("arm_joint").axis_J, Eigen::Vector3d::UnitY());
  EXPECT_EQ(axel.Joint("left_wheel_joint").X_PJ.p, Eigen::Vector3d(0, 0.425, 0));
}

}  // namespace
}  // namespace dockyard
