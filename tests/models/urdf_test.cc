#include "models/read/urdf.h"

#include <gmock/gmock.h>

#include "models/urdf_messages.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string Inertial(const std::string& mass, const std::string& ixx, const std::string& iyy,
                     const std::string& izz) {
  return LinkUrdf("<inertial><mass value=\"" + mass + "\"/><inertia ixx=\"" + ixx +
                  "\" ixy=\"0\" ixz=\"0\" iyy=\"" + iyy + "\" iyz=\"0\" izz=\"" + izz +
                  "\"/></inertial>");
}

TEST(Urdf, LinkWithASoundMeshLoads) {
  EXPECT_EQ(UrdfMessage(VisualUrdf("<mesh filename=\"mesh.obj\"/>")), "(no error)");
  EXPECT_EQ(UrdfMessage(Inertial("2", "1", "1", "1")), "(no error)");
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
  EXPECT_THAT(UrdfMessage("<robot name=\"m\">\n<link name=\"a\">\n</robot>\n"),
              testing::MatchesRegex("m\\.urdf:[0-9]+:[0-9]+: not valid XML: .*"));
  EXPECT_THAT(UrdfMessage("<a/>"), HasSubstr("expected a <robot> element"));
}

TEST(Urdf, MassesAndInertiasThatNoBodyHasAreRefused) {
  EXPECT_EQ(UrdfMessage(Inertial("-1", "1", "1", "1")),
            "m.urdf:2:17: link 'a': mass: expected a number > 0, found '-1'");
  EXPECT_EQ(UrdfMessage(Inertial("1e9", "1", "1", "1")),
            "m.urdf:2:17: link 'a': mass: expected a number > 0 and <= 1e+05, found '1e+09'");
  EXPECT_EQ(
      UrdfMessage(Inertial("0", "1", "1", "1")),
      "m.urdf:2:17: link 'a': mass: expected a number > 0, or 0 with moments of 0, found '0'");
  EXPECT_EQ(UrdfMessage(Inertial("1", "1", "1", "2.1")),
            "m.urdf:2:17: link 'a': inertia: expected principal moments >= 0 of which none exceeds "
            "the sum of the others, found 1, 1 and 2.1 kg m^2: the largest exceeds the sum of the "
            "others by 0.1, 4.8 % of it");
  EXPECT_THAT(UrdfMessage(Inertial("1", "-1", "1", "1")), HasSubstr("-1, 1 and 1 kg m^2: -1 is"));
  EXPECT_THAT(UrdfMessage(Inertial("1", "0", "0", "1")), HasSubstr("0, 0 and 1 kg m^2"));
}

/// The warnings about a file that loads.
std::vector<std::string> WarningsFor(const std::string& text) {
  const ScratchFolder folder;
  std::vector<std::string> warnings =
      LoadUrdf(folder.Write("m.urdf", text), UrdfOptions()).warnings;
  for (std::string& warning : warnings) warning.erase(0, warning.find("m.urdf"));
  return warnings;
}

TEST(Urdf, MomentsRoundedByAnExporterAreTakenWithAWarning) {
  // Flat plates obey Izz = Ixx + Iyy. Their moments, rounded to some digits, need not.
  EXPECT_THAT(
      WarningsFor(Inertial("1.2", "0.0333", "0.0083", "0.0417")),
      ElementsAre("m.urdf:2:17: link 'a': inertia: the principal moments are 0.0083, 0.0333 "
                  "and 0.0417 kg m^2: the largest exceeds the sum of the others by 0.0001, "
                  "0.24 % of it, taken for rounding of the printed digits"));
  EXPECT_EQ(WarningsFor(Inertial("1", "1.2e-05", "3e-06", "1.6e-05")).size(), 1u);
  EXPECT_EQ(WarningsFor(Inertial("1", "0.002", "0.001", "0.004")).size(), 1u);
  EXPECT_EQ(WarningsFor(Inertial("1", "100", "100", "201")).size(), 1u);
  EXPECT_EQ(WarningsFor(Inertial("1", "0.0333", "0.0084", "0.0417")).size(), 0u);
}

TEST(Urdf, MomentsBeyondTheirRoundingAreRefused) {
  for (const char* izz : {"0.0430", "0.05", "0.5"}) {
    EXPECT_THAT(UrdfMessage(Inertial("1", "0.0333", "0.0083", izz)), HasSubstr("exceeds the sum"));
  }
  // One digit each would explain anything: beyond 30 % nothing is taken for rounding.
  EXPECT_THAT(UrdfMessage(Inertial("1", "0.1", "0.1", "0.3")), HasSubstr("33 % of it"));
}

TEST(Urdf, MomentsMayHaveSpacesAroundThem) {
  EXPECT_EQ(WarningsFor(Inertial("1", " 0.0333", "0.0084", "\t0.0417")).size(), 0u);
  EXPECT_EQ(WarningsFor(Inertial("1.2", " 0.0333", "0.0083", " 0.0417")).size(), 1u);
}

TEST(Urdf, AMomentOfZeroIsThatOfARodOrAPoint) {
  for (const char* ixx : {"0", "0.0", "0.000"}) {
    const auto warnings = WarningsFor(Inertial("1", ixx, "1", "1"));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_THAT(warnings[0], HasSubstr("a principal moment of 0"));
  }
  EXPECT_EQ(WarningsFor(Inertial("1", "0", "0", "0")).size(), 1u);
}

TEST(Urdf, MassAndMomentsOfZeroCountAsNoInertial) {
  const ScratchFolder folder;
  const std::string text =
      Replaced(Inertial("0", "0", "0", "0.0"), "<mass", "<origin xyz=\"1 2 3\"/><mass");
  const UrdfModel model = LoadUrdf(folder.Write("m.urdf", text));
  EXPECT_EQ(model.Link("a").mass_kg, 0.0);
  EXPECT_EQ(model.Link("a").p_LoCom_L, Eigen::Vector3d::Zero());
  EXPECT_EQ(model.warnings.size(), 0u);
}

TEST(Urdf, NumbersThatAreNoneAreRefused) {
  for (const char* bad : {"nan", "inf", "ten", "", "1e999"}) {
    EXPECT_THAT(UrdfMessage(Inertial(bad, "1", "1", "1")), StartsWith("m.urdf")) << bad;
    EXPECT_THAT(UrdfMessage(Inertial("1", bad, "1", "1")), StartsWith("m.urdf")) << bad;
    EXPECT_THAT(UrdfMessage(VisualUrdf("<sphere radius=\"" + std::string(bad) + "\"/>")),
                StartsWith("m.urdf"))
        << bad;
  }
}

TEST(Urdf, NumbersAreToldWithTheirOwnPlace) {
  EXPECT_EQ(UrdfMessage(Inertial("ten", "1", "1", "1")),
            "m.urdf:2:27: <mass>: value: expected a number, found 'ten'");
  EXPECT_EQ(UrdfMessage(VisualUrdf("<box size=\"1 2\"/>")),
            "m.urdf:2:35: <box>: size: expected 3 numbers, found '1 2'");
}

TEST(Urdf, NamesAndReferencesMustMatch) {
  const auto robot = [](const std::string& inside) {
    return UrdfMessage("<robot name=\"m\">\n" + inside + "\n</robot>\n");
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
  EXPECT_THAT(UrdfMessage(VisualUrdf("<box size=\"1 0 1\"/>")),
              HasSubstr("box size: expected a number > 0, found '0'"));
  EXPECT_THAT(UrdfMessage(VisualUrdf("<cylinder radius=\"0.1\" length=\"1e5\"/>")),
              HasSubstr("cylinder length: expected a number > 0 and <= 100, found '1e+05'"));
}

TEST(Urdf, MeshesStayInsideTheModelsFolder) {
  const auto message = [](const std::string& filename) {
    return UrdfMessage(VisualUrdf("<mesh filename=\"" + filename + "\"/>"));
  };
  EXPECT_EQ(message("none.obj"),
            "m.urdf:2:17: link 'a': mesh filename: expected a file, found none at 'none.obj'");
  EXPECT_THAT(message("../mesh.obj"), HasSubstr("(it leads out of it)"));
  EXPECT_THAT(message("x/../../mesh.obj"), HasSubstr("(it leads out of it)"));
  EXPECT_THAT(message("/etc/passwd"), HasSubstr("(it is absolute and leads elsewhere; copy"));
  EXPECT_THAT(message("file:///etc/passwd"),
              HasSubstr("(it is absolute and leads elsewhere; copy"));
  EXPECT_THAT(message("http://example.org/a.obj"), HasSubstr("are followed"));
}

TEST(Urdf, SymbolicLinksDoNotLeadOut) {
  const ScratchFolder outside, folder;
  const std::string target = outside.Write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::create_symlink(target, folder.path() / "link.obj");
  const std::string file = folder.Write("m.urdf", VisualUrdf("<mesh filename=\"link.obj\"/>"));
  EXPECT_THAT(MessageOf([&] { LoadUrdf(file); }, folder), HasSubstr("(it leads out of it)"));
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
