#include "models/read/urdf.h"

#include <gmock/gmock.h>

#include <chrono>

#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
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
            "m.urdf:2:17: link 'a': mass: expected a number > 0, found '-1'");
  EXPECT_EQ(MessageFor(Inertial("1e9", "1", "1", "1")),
            "m.urdf:2:17: link 'a': mass: expected a number > 0 and <= 1e+05, found '1e+09'");
  EXPECT_EQ(
      MessageFor(Inertial("0", "1", "1", "1")),
      "m.urdf:2:17: link 'a': mass: expected a number > 0, or 0 with moments of 0, found '0'");
  EXPECT_EQ(MessageFor(Inertial("1", "1", "1", "2.1")),
            "m.urdf:2:17: link 'a': inertia: expected principal moments >= 0 of which none exceeds "
            "the sum of the others, found 1, 1 and 2.1 kg m^2: the largest exceeds the sum of the "
            "others by 0.1, 4.8 % of it");
  EXPECT_THAT(MessageFor(Inertial("1", "-1", "1", "1")), HasSubstr("-1, 1 and 1 kg m^2: -1 is"));
  EXPECT_THAT(MessageFor(Inertial("1", "0", "0", "1")), HasSubstr("0, 0 and 1 kg m^2"));
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
    EXPECT_THAT(MessageFor(Inertial("1", "0.0333", "0.0083", izz)), HasSubstr("exceeds the sum"));
  }
  // One digit each would explain anything: beyond 30 % nothing is taken for rounding.
  EXPECT_THAT(MessageFor(Inertial("1", "0.1", "0.1", "0.3")), HasSubstr("33 % of it"));
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

/// `text` n times.
std::string Times(std::size_t n, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < n; ++i) all += text;
  return all;
}

double Seconds(const std::function<void()>& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Urdf, NestingIsCountedOutsideCommentsCdataAndAttributes) {
  const std::string deep = Times(40000, "<a>") + Times(40000, "</a>");
  const std::string up = Times(40000, "</a>");
  for (const std::string& hidden :
       {"<!-- " + up + " -->", "<![CDATA[" + up + "]]>", "<b c=\"" + up.substr(0, 4000) + "\"/>"}) {
    EXPECT_THAT(MessageFor("<robot name=\"m\">" + hidden + deep + "</robot>"),
                HasSubstr("nested deeper than 64 levels"));
  }
  EXPECT_EQ(
      MessageFor("<robot name=\"m\"><!-- " + Times(100, "<a>") + " --><link name=\"a\"/></robot>"),
      "(no error)");
}

TEST(Urdf, BrokenTagsAreRefusedInLinearTime) {
  // 3.8 MB took more than 60 s where every '<' looked for its '>' anew; now 0.2 s.
  const auto call = [] {
    EXPECT_THAT(MessageFor("<robot>" + Times(1900000, "<a") + "/>"),
                HasSubstr("m.urdf:1:8: not usable XML: a tag without its end"));
  };
  EXPECT_LT(Seconds(call), 10.0);
}

TEST(Urdf, OneTagHoldsABoundedNumberOfAttributes) {
  // Each attribute of a tag is compared with all others.
  std::string tag = "<robot name=\"m\"><link name=\"a\"";
  for (int i = 0; i < 100000; ++i) tag += " a" + std::to_string(i) + "=\"\"";
  EXPECT_THAT(MessageFor(tag + "/></robot>"), HasSubstr("a tag of more than 8192 bytes"));
}

std::string Robot(const std::string& inside) {
  return MessageFor("<robot name=\"m\">\n" + inside + "\n</robot>\n");
}

/// Two links and a joint with this inside, in line 3.
std::string WithInJoint(const std::string& inside) {
  return Robot(
      "<link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"continuous\">"
      "<parent link=\"a\"/><child link=\"b\"/>" +
      inside + "</joint>");
}

TEST(UrdfElements, ThatWouldChangeTheMotionAreRefusedWithTheirLine) {
  EXPECT_EQ(WithInJoint("\n<mimic joint=\"k\"/>"),
            "m.urdf:4:1: <mimic>: joints that follow another are not simulated");
  EXPECT_EQ(WithInJoint("\n<dynamics damping=\"0.1\"/>"),
            "m.urdf:4:1: <dynamics>: damping: expected 0, the robot's YAML file has the motors' "
            "friction; found '0.1'");
  EXPECT_THAT(WithInJoint("\n<dynamics friction=\"1\"/>"), StartsWith("m.urdf:4:1: <dynamics>"));
  EXPECT_EQ(WithInJoint("\n<safety_controller k_velocity=\"1\"/>"),
            "m.urdf:4:1: <safety_controller>: its soft limits are not simulated; <limit> is");
}

TEST(UrdfElements, ThatWouldChangeTheImageAreRefusedWithTheirLine) {
  const auto material = [](const std::string& inside) {
    return Robot("<material name=\"x\">" + inside + "</material>\n<link name=\"a\"/>");
  };
  EXPECT_EQ(material("<color rgba=\"1 0 0 1\"/>"), "(no error)");
  EXPECT_THAT(material("<color rgba=\"1 0 0 0.5\"/>"), HasSubstr("nothing is drawn transparent"));
  EXPECT_THAT(material("<texture filename=\"a.png\"/>"), HasSubstr("m.urdf:2:20: <texture>: "));
}

TEST(UrdfElements, ThatAreUnknownAreRefusedWithTheirLine) {
  EXPECT_EQ(Robot("<link name=\"a\">\n<visuals/></link>"),
            "m.urdf:3:1: <visuals>: unknown element in <link>, did you mean 'visual'?");
  EXPECT_EQ(Robot("<link name=\"a\" kind=\"arm\"/>"),
            "m.urdf:2:1: <link>: kind: unknown attribute in <link>, known are: name");
  EXPECT_EQ(
      Robot("<xacro:wheel side=\"left\"/><link name=\"a\"/>"),
      "m.urdf:2:1: '<xacro:wheel>' is a macro or an argument: only `check` expands it; expand "
      "the file by hand: xacro m.urdf > m_expanded.urdf");
  EXPECT_THAT(MessageFor(Visual("<capsule radius=\"1\" length=\"1\"/>")), HasSubstr("<capsule>: "));
}

TEST(UrdfElements, ThatStandOnceAreRefusedTwice) {
  EXPECT_THAT(MessageFor(Visual("<sphere radius=\"1\"/><sphere radius=\"2\"/>")),
              HasSubstr("<sphere>: given twice in one <geometry>"));
  EXPECT_THAT(MessageFor(Visual("<sphere radius=\"1\"/><box size=\"1 1 1\"/>")),
              HasSubstr("<geometry>: expected one shape, found 2"));
  EXPECT_THAT(WithInJoint("<axis xyz=\"1 0 0\"/>\n<axis xyz=\"0 1 0\"/>"),
              HasSubstr("m.urdf:4:1: <axis>: given twice in one <joint>"));
}

TEST(UrdfElements, ThatMustStandAreMissed) {
  EXPECT_EQ(MessageFor(Link("<visual/>")), "m.urdf:2:17: <visual>: missing <geometry>");
  EXPECT_EQ(MessageFor(Link("<collision/>")), "m.urdf:2:17: <collision>: missing <geometry>");
  EXPECT_EQ(MessageFor(Link("<inertial><mass value=\"1\"/></inertial>")),
            "m.urdf:2:17: <inertial>: missing <inertia>");
}

TEST(UrdfElements, MaterialsHaveOneColour) {
  const auto with = [](const std::string& before, const std::string& material) {
    return Robot(before + "<link name=\"a\"><visual><geometry><sphere radius=\"1\"/></geometry>\n" +
                 material + "</visual></link>");
  };
  const std::string red = "<material name=\"x\"><color rgba=\"1 0 0 1\"/></material>";
  const std::string blue = "<material name=\"x\"><color rgba=\"0 0 1 1\"/></material>";
  EXPECT_EQ(with(red, "<material name=\"x\"/>"), "(no error)");
  EXPECT_EQ(with("", red), "(no error)");
  EXPECT_EQ(with("", "<material name=\"x\"/>"),
            "m.urdf:3:1: <material>: expected a <color>, or the name of a material before, found "
            "'x'");
  for (const char* same : {"1.0 0.0 0.0 1.0", " 1 -0  0e3 1 "}) {
    EXPECT_EQ(with(red, Replaced(red, "1 0 0 1", same)), "(no error)") << same;
  }
  EXPECT_THAT(with("", Replaced(red, "1 0 0 1", "255 0 0 1")),
              HasSubstr("m.urdf:3:20: <color>: rgba"));
  EXPECT_EQ(with(red, blue), "m.urdf:3:1: <material>: 'x' has another colour before");
}

TEST(UrdfElements, WithoutEffectAreLeftOutAndCounted) {
  const ScratchFolder folder;
  const UrdfModel model = LoadUrdf(folder.Write(
      "m.urdf",
      "<robot name=\"m\" xmlns:xacro=\"x\"><link name=\"a\"/><link name=\"b\"/>"
      "<gazebo reference=\"a\"><mu1>0.2</mu1></gazebo><gazebo/><transmission name=\"t\"/>"
      "<joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/>"
      "<calibration rising=\"0\"/><dynamics damping=\"0\" friction=\"0.0\"/></joint></robot>"));
  const std::map<std::string, int> expected{{"calibration", 1}, {"gazebo", 2}, {"transmission", 1}};
  EXPECT_EQ(model.left_out, expected);
}

TEST(UrdfElements, OfOldToolsAreLeftOutAndCounted) {
  const ScratchFolder folder;
  const UrdfModel model = LoadUrdf(folder.Write(
      "m.urdf",
      "<robot name=\"m\"><link name=\"a\" type=\"base\"><visual><geometry name=\"g\">"
      "<material name=\"x\"/><sphere radius=\"1\"/></geometry><material name=\"\">"
      "<texture filename=\"\"/></material></visual>"
      "<collision><geometry><sphere radius=\"2\"/><surface><friction/></surface></geometry>"
      "<surface/><material name=\"y\"/></collision><sensor name=\"s\"/></link><link name=\"b\"/>"
      "<joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/>"
      "<axis xyz=\"0 1 0\" rpy=\"0.0 0 -0\"/><joint_properties damping=\"some\" friction=\"1\"/>"
      "</joint></robot>"));
  const std::map<std::string, int> expected{
      {"axis rpy", 1}, {"geometry name", 1}, {"joint_properties", 1}, {"link type", 1},
      {"material", 3}, {"sensor", 1},        {"surface", 2},          {"texture", 1}};
  EXPECT_EQ(model.left_out, expected);
  EXPECT_EQ(model.Link("a").visuals[0].mesh->vertices.size(), SphereMesh(1.0).vertices.size());
  EXPECT_EQ(std::get<SphereShape>(model.Link("a").collisions[0].shape).radius_m, 2.0);
  EXPECT_EQ(model.Joint("j").axis_J, Eigen::Vector3d::UnitY());
}

TEST(UrdfElements, AnAxisWithARotationIsRefused) {
  EXPECT_EQ(WithInJoint("\n<axis xyz=\"0 1 0\" rpy=\"0 0 1.57\"/>"),
            "m.urdf:4:1: <axis>: rpy: expected 0 0 0, an axis is turned by its xyz alone; found "
            "'0 0 1.57'");
}

TEST(UrdfTree, LinksOutsideItAreRefusedWithTheirLine) {
  const auto joint = [](const std::string& parent, const std::string& child) {
    return "<joint name=\"" + parent + child + "\" type=\"fixed\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/></joint>\n";
  };
  const std::string links = "<link name=\"a\"/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n";
  EXPECT_EQ(Robot(links + joint("a", "b") + joint("b", "c")), "(no error)");
  EXPECT_EQ(Robot(links + joint("b", "c")),
            "m.urdf:2:1: <link>: 'a' hangs on no joint, expected one tree, its root is 'b'");
  EXPECT_EQ(Robot(links + joint("a", "c") + joint("b", "c")),
            "m.urdf:6:1: <joint>: link 'c' is the child of two joints, the first at m.urdf:5:1");
  EXPECT_EQ(Robot(links + joint("b", "c") + joint("c", "b")),
            "m.urdf:6:1: <joint>: joints in a circle, expected a tree");
  EXPECT_EQ(Robot("<link name=\"a\"/>\n" + joint("a", "a")),
            "m.urdf:3:1: <joint>: joints in a circle, expected a tree");
}

TEST(Urdf, AllPartsOfAFileTogetherAreBounded) {
  const auto robot = [](int links, int parts, const std::string& geometry) {
    std::string text = "<link name=\"root\"/>";
    for (int i = 0; i < links; ++i) {
      const std::string name = std::to_string(i);
      text += "<link name=\"" + name + "\">" +
              Times(static_cast<std::size_t>(parts),
                    "<collision><geometry>" + geometry + "</geometry></collision>") +
              "</link><joint name=\"" + name +
              "\" type=\"fixed\"><parent link=\"root\"/><child link=\"" + name + "\"/></joint>\n";
    }
    return "<robot name=\"m\">\n" + text + "</robot>\n";
  };
  EXPECT_THAT(MessageFor(robot(21, 100, "<sphere radius=\"1\"/>")),
              HasSubstr("more than 2000 visuals and collisions in one file"));
  EXPECT_EQ(MessageFor(robot(20, 100, "<sphere radius=\"1\"/>")), "(no error)");
  const ScratchFolder folder;
  std::string mesh;
  for (int i = 0; i < 40000; ++i) {
    mesh += "v " + std::to_string(i) + "e-4 0 0\nv 0 " + std::to_string(i) + "e-4 1\nv 0 0 " +
            std::to_string(i) + "e-4\nf -1 -2 -3\n";
  }
  folder.Write("big.obj", mesh);
  const std::string file = folder.Write("m.urdf", robot(1, 40, "<mesh filename=\"big.obj\"/>"));
  EXPECT_THAT(MessageOf([&] { LoadUrdf(file); }, folder),
              HasSubstr("more than 3 million mesh vertices in one file"));
}

TEST(UrdfTree, HasAtMostAThousandLinks) {
  std::string chain;
  for (int i = 0; i < 1001; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    chain += "<link name=\"" + n + "\"/>";
    if (i == 0) continue;
    chain += "<joint name=\"" + n + "\" type=\"fixed\"><parent link=\"" + before +
             "\"/><child link=\"" + n + "\"/></joint>\n";
  }
  EXPECT_THAT(Robot(chain), HasSubstr("more than 1000 links"));
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
