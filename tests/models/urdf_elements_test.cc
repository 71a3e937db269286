// Which elements a URDF file may have, and that its links make a tree.
#include <gmock/gmock.h>

#include "models/urdf_messages.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

/// Two links and a joint with this inside, in line 3.
std::string WithInJoint(const std::string& inside) {
  return RobotMessage(
      "<link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"continuous\">"
      "<parent link=\"a\"/><child link=\"b\"/>" +
      inside + "</joint>");
}

TEST(UrdfElements, ThatWouldChangeTheMotionAreRefusedWithTheirLine) {
  EXPECT_EQ(WithInJoint("\n<safety_controller k_velocity=\"1\"/>"),
            "m.urdf:4:1: <safety_controller>: its soft limits are not simulated; <limit> is");
}

TEST(UrdfElements, OfAJointsFrictionAndOfOneThatFollowsAreRead) {
  const ScratchFolder folder;
  const UrdfModel model = LoadUrdf(folder.Write(
      "m.urdf",
      "<robot name=\"m\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"continuous\">"
      "<parent link=\"a\"/><child link=\"b\"/><dynamics damping=\"0.5\" friction=\"0.25\"/>"
      "<mimic joint=\"k\" multiplier=\"-2\" offset=\"0.1\"/></joint></robot>"));
  const UrdfJoint& joint = model.Joint("j");
  EXPECT_EQ(joint.damping_nms_per_rad, 0.5);
  EXPECT_EQ(joint.friction_nm, 0.25);
  EXPECT_EQ(joint.mimics, "k");
  EXPECT_EQ(joint.mimic_ratio, -2.0);
  EXPECT_EQ(joint.mimic_offset_rad, 0.1);
  EXPECT_THAT(WithInJoint("\n<dynamics damping=\"-1\"/>"),
              HasSubstr("damping: expected a number >= 0"));
  EXPECT_THAT(WithInJoint("\n<mimic joint=\"k\" multiplier=\"two\"/>"),
              HasSubstr("multiplier: expected a number"));
}

TEST(UrdfElements, ThatWouldChangeTheImageAreRefusedWithTheirLine) {
  const auto material = [](const std::string& inside) {
    return RobotMessage("<material name=\"x\">" + inside + "</material>\n<link name=\"a\"/>");
  };
  EXPECT_EQ(material("<color rgba=\"1 0 0 1\"/>"), "(no error)");
  EXPECT_THAT(material("<color rgba=\"1 0 0 0.5\"/>"), HasSubstr("nothing is drawn transparent"));
  EXPECT_THAT(material("<texture filename=\"a.png\"/>"), HasSubstr("m.urdf:2:20: <texture>: "));
}

TEST(UrdfElements, ThatAreUnknownAreRefusedWithTheirLine) {
  EXPECT_EQ(RobotMessage("<link name=\"a\">\n<visuals/></link>"),
            "m.urdf:3:1: <visuals>: unknown element in <link>, did you mean 'visual'?");
  EXPECT_EQ(RobotMessage("<link name=\"a\" kind=\"arm\"/>"),
            "m.urdf:2:1: <link>: kind: unknown attribute in <link>, known are: name");
  EXPECT_EQ(
      RobotMessage("<xacro:wheel side=\"left\"/><link name=\"a\"/>"),
      "m.urdf:2:1: '<xacro:wheel>' is a macro or an argument: only `check` expands it; expand "
      "the file by hand: xacro m.urdf > m_expanded.urdf");
  EXPECT_THAT(UrdfMessage(VisualUrdf("<capsule radius=\"1\" length=\"1\"/>")),
              HasSubstr("<capsule>: "));
}

TEST(UrdfElements, ThatStandOnceAreRefusedTwice) {
  EXPECT_THAT(UrdfMessage(VisualUrdf("<sphere radius=\"1\"/><sphere radius=\"2\"/>")),
              HasSubstr("<sphere>: given twice in one <geometry>"));
  EXPECT_THAT(UrdfMessage(VisualUrdf("<sphere radius=\"1\"/><box size=\"1 1 1\"/>")),
              HasSubstr("<geometry>: expected one shape, found 2"));
  EXPECT_THAT(WithInJoint("<axis xyz=\"1 0 0\"/>\n<axis xyz=\"0 1 0\"/>"),
              HasSubstr("m.urdf:4:1: <axis>: given twice in one <joint>"));
}

TEST(UrdfElements, ThatMustStandAreMissed) {
  EXPECT_EQ(UrdfMessage(LinkUrdf("<visual/>")), "m.urdf:2:17: <visual>: missing <geometry>");
  EXPECT_EQ(UrdfMessage(LinkUrdf("<collision/>")), "m.urdf:2:17: <collision>: missing <geometry>");
  EXPECT_EQ(UrdfMessage(LinkUrdf("<inertial><mass value=\"1\"/></inertial>")),
            "m.urdf:2:17: <inertial>: missing <inertia>");
}

TEST(UrdfElements, MaterialsHaveOneColour) {
  const auto with = [](const std::string& before, const std::string& material) {
    return RobotMessage(before +
                        "<link name=\"a\"><visual><geometry><sphere radius=\"1\"/></geometry>\n" +
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

TEST(UrdfElements, AnglesOfMoreThanATurnAreRefusedAsDegrees) {
  EXPECT_EQ(WithInJoint("\n<origin xyz=\"0 0 0\" rpy=\"0 0 180\"/>"),
            "m.urdf:4:1: <origin>: rpy: expected angles in radians, up to a turn, found '0 0 180'");
}

TEST(UrdfTree, LinksOutsideItAreRefusedWithTheirLine) {
  const auto joint = [](const std::string& parent, const std::string& child) {
    return "<joint name=\"" + parent + child + "\" type=\"fixed\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/></joint>\n";
  };
  const std::string links = "<link name=\"a\"/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n";
  EXPECT_EQ(RobotMessage(links + joint("a", "b") + joint("b", "c")), "(no error)");
  EXPECT_EQ(RobotMessage(links + joint("b", "c")),
            "m.urdf:2:1: <link>: 'a' hangs on no joint, expected one tree, its root is 'b'");
  EXPECT_EQ(RobotMessage(links + joint("a", "c") + joint("b", "c")),
            "m.urdf:6:1: <joint>: link 'c' is the child of two joints, the first at m.urdf:5:1");
  EXPECT_EQ(RobotMessage(links + joint("b", "c") + joint("c", "b")),
            "m.urdf:6:1: <joint>: joints in a circle, expected a tree");
  EXPECT_EQ(RobotMessage("<link name=\"a\"/>\n" + joint("a", "a")),
            "m.urdf:3:1: <joint>: joints in a circle, expected a tree");
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
  EXPECT_THAT(RobotMessage(chain), HasSubstr("more than 1000 links"));
}

}  // namespace
}  // namespace dockyard
