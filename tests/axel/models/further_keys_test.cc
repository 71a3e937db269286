// Keys of joints that a rover's files add, and what is refused of them.
#include <gmock/gmock.h>

#include "axel/further_rover.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

const std::string kLimit = "<limit lower=\"-1\" upper=\"2\" effort=\"0\" velocity=\"0\"/>";

/// A rover with a mast that turns, its camera on a slide, and these keys.
RoverModel WithKeys(const std::string& yaml, const std::string& of_mast = "") {
  return AxelWith(SolidLink("mast", 2.0, {0.1, 0.1, 0.5}) +
                      SolidLink("camera", 0.5, {0.1, 0.1, 0.1}) +
                      JointTo("mast", "body", "revolute", "0 0 0.6", "0 0 2", kLimit + of_mast) +
                      JointTo("camera", "mast", "prismatic", "0.2 0 0", "1 0 0", kLimit),
                  yaml);
}

std::string Message(const std::string& yaml, const std::string& of_mast = "") {
  const ScratchFolder folder;
  return MessageOf([&] { WithKeys(yaml, of_mast); }, folder);
}

const JointedLink& LinkBy(const RoverModel& rover, const std::string& name) {
  for (const JointedLink& each : rover.further.links) {
    if (each.link.name == name) return each;
  }
  throw std::out_of_range(name);
}

TEST(FurtherJoints, ComeFromTheUrdfAndTheirKeys) {
  const RoverModel rover = WithKeys(
      "joints:\n  - name: to_mast\n    start_deg: 45\n    rate_deg_s: -30\n" + SmallMotor("    ") +
          "  - name: to_camera\n    start_m: 0.5\n"
          "    stop: {stiffness_n_per_m: 1e4, damping_ns_per_m: 20}\n"
          "    spring: {stiffness_n_per_m: 300, rest_m: 0.25}\n"
          "link_contact: {stiffness_n_per_m: 2e5, damping_ns_per_m: 500, friction: 0.3}\n",
      "<dynamics damping=\"0.5\" friction=\"0.25\"/>");
  EXPECT_DOUBLE_EQ(rover.mass_kg(), 42.5);
  ASSERT_EQ(rover.further.links.size(), 2u);
  const JointedLink &mast = LinkBy(rover, "mast"), &camera = LinkBy(rover, "camera");
  EXPECT_EQ(mast.carrier, 0);
  EXPECT_EQ(camera.carrier, 4 + static_cast<int>(&mast - rover.further.links.data()));
  EXPECT_EQ(mast.axis_L, Eigen::Vector3d::UnitZ());
  EXPECT_FALSE(mast.slides);
  EXPECT_DOUBLE_EQ(mast.low_rad, -1.0);
  EXPECT_DOUBLE_EQ(mast.high_rad, 2.0);
  EXPECT_DOUBLE_EQ(mast.damping_nms_per_rad, 0.5);
  EXPECT_DOUBLE_EQ(mast.friction_nm, 0.25);
  EXPECT_DOUBLE_EQ(mast.start_rad, Radians(45.0));
  ASSERT_TRUE(mast.motor);
  EXPECT_DOUBLE_EQ(mast.motor->rate_rad_s, Radians(-30.0));
  EXPECT_DOUBLE_EQ(mast.motor->model.brake_torque_nm, 6.0);
  EXPECT_TRUE(camera.slides);
  EXPECT_DOUBLE_EQ(camera.start_rad, 0.5);
  EXPECT_DOUBLE_EQ(camera.stop.stiffness_nm_per_rad, 1e4);
  EXPECT_DOUBLE_EQ(camera.stop.damping_nms_per_rad, 20.0);
  EXPECT_DOUBLE_EQ(camera.spring_nm_per_rad, 300.0);
  EXPECT_DOUBLE_EQ(camera.rest_rad, 0.25);
  EXPECT_FALSE(camera.motor);
  EXPECT_DOUBLE_EQ(rover.further.contact.stiffness_n_per_m, 2e5);
  EXPECT_DOUBLE_EQ(rover.further.contact.friction, 0.3);
}

TEST(FurtherJoints, KeysThatDoNotFitTheJointAreRefusedWithTheirPlace) {
  const auto one = [](const std::string& keys) { return Message("joints: [{" + keys + "}]\n"); };
  EXPECT_THAT(one("name: mast"),
              HasSubstr("joints[0]: expected the name of a joint of the URDF file "
                        "that moves a further link, found 'mast'"));
  EXPECT_THAT(one("name: arm_joint"), HasSubstr("moves a further link, found 'arm_joint'"));
  EXPECT_THAT(
      one("name: to_mast, start_m: 0.1"),
      HasSubstr("expected keys of a turn (start_deg, rest_deg, nm_per_rad): the joint turns"));
  EXPECT_THAT(one("name: to_camera, start_deg: 1"),
              HasSubstr("expected keys of a slide (start_m, rest_m, n_per_m): the joint slides"));
  EXPECT_THAT(one("name: to_mast, start_deg: 170"),
              HasSubstr("joint 'to_mast': expected a start within its limits, found 170 deg"));
  EXPECT_THAT(one("name: to_mast, rate_deg_s: 5"), HasSubstr("expected a motor with the rate"));
  EXPECT_THAT(one("name: to_mast, colour: red"), HasSubstr("colour"));
  const auto driven = [](const std::string& name, const std::string& keys) {
    return Message("joints:\n  - name: " + name + "\n" + SmallMotor("    ") + keys);
  };
  EXPECT_THAT(driven("to_camera", ""), HasSubstr("expected lead_m_per_turn of the slide's motor"));
  EXPECT_THAT(driven("to_mast", "    lead_m_per_turn: 0.1\n"),
              HasSubstr("expected no lead_m_per_turn: the joint turns"));
  EXPECT_THAT(one("name: to_mast, lead_m_per_turn: 0.1"),
              HasSubstr("expected a motor with lead_m_per_turn"));
  EXPECT_THAT(one("name: to_mast, spring: {rest_deg: 20}"),
              HasSubstr("expected the spring's stiffness with where it is free"));
  EXPECT_THAT(one("name: to_mast, start_deg: 5}, {name: to_mast"),
              HasSubstr("joints[1]: expected each joint once, found 'to_mast' again"));
  EXPECT_THAT(driven("to_mast", "    rate_deg_s: 400\n"),
              HasSubstr("expected a rate of no more than motor.max_speed_rad_s"));
}

TEST(FurtherJoints, PinsAndFollowersNeedWhatTheyName) {
  const auto pin = [](const std::string& keys) { return Message("pins: [{" + keys + "}]\n"); };
  EXPECT_THAT(pin("link: mast, to: boom, at_m: [0, 0, 0]"),
              HasSubstr("pins[0]: expected the name of a link that moves, found 'boom'"));
  EXPECT_THAT(pin("link: mast, to: mast, at_m: [0, 0, 0]"), HasSubstr("expected two links"));
  EXPECT_EQ(pin("link: camera, to: body, at_m: [0, 0, 0]"), "(no error)");
  EXPECT_THAT(pin("link: arm, to: body, at_m: [0, 0, 0]"),
              HasSubstr("expected a pin of at least one further link"));
  EXPECT_THAT(pin("link: camera, to: body, at_m: [0, 0, 0]}, {link: camera, to: body, at_m: "
                  "[0, 0, 0]"),
              HasSubstr("pins[1]: expected each pin once"));
  EXPECT_THAT(Message("", "<mimic joint=\"to_boom\"/>"),
              HasSubstr("<mimic>: expected the name of another joint that moves, found 'to_boom'"));
}

TEST(FurtherJoints, FollowersComeAfterThoseThatTheyFollowAndInNoCircle) {
  const auto followers = [](const std::string& of_a, const std::string& of_b,
                            const std::string& of_c) {
    std::string urdf;
    for (const auto& [name, more] :
         {std::pair("a", of_a), std::pair("b", of_b), std::pair("c", of_c)}) {
      urdf += SolidLink(name, 1.0, {0.1, 0.1, 0.1}, false) +
              JointTo(name, "body", "continuous", "0 0 0.5", "0 0 1", more);
    }
    return urdf;
  };
  const auto mimic = [](const std::string& joint) { return "<mimic joint=\"to_" + joint + "\"/>"; };
  const RoverModel rover = AxelWith(followers(mimic("b"), mimic("c"), ""), "");
  const auto number = [&](const std::string& name) {
    return 4 + static_cast<int>(&LinkBy(rover, name) - rover.further.links.data());
  };
  ASSERT_EQ(rover.further.ratios.size(), 2u);
  EXPECT_EQ(rover.further.ratios[0].link, number("b"));
  EXPECT_EQ(rover.further.ratios[1].link, number("a"));
  const ScratchFolder folder;
  EXPECT_THAT(
      MessageOf([&] { AxelWith(followers(mimic("b"), mimic("c"), mimic("a")), ""); }, folder),
      HasSubstr("<mimic>: joints that follow each other in a circle"));
  EXPECT_THAT(MessageOf(
                  [&] {
                    AxelWith(followers(mimic("b"), "", ""),
                             "joints: [{name: to_a, start_deg: 5}]\n");
                  },
                  folder),
              HasSubstr("expected no start of a joint that follows another"));
}

TEST(FurtherJoints, AStartOutsideOfTheLimitsIsRefusedWithoutAKeyToo) {
  const ScratchFolder folder;
  EXPECT_THAT(MessageOf(
                  [&] {
                    AxelWith(SolidLink("mast", 2.0, {0.1, 0.1, 0.5}) +
                                 JointTo("mast", "body", "revolute", "0 0 0.6", "0 0 1",
                                         "<limit lower=\"0.2\" upper=\"2\" effort=\"0\" "
                                         "velocity=\"0\"/>"),
                             "");
                  },
                  folder),
              HasSubstr("joint 'to_mast': expected a start within its limits, found 0 deg"));
}

TEST(FurtherJoints, FrictionOfTheRoversOwnJointsIsRefused) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string urdf = Slurp(SourceFile("models/axel/axel.urdf"));
  const std::size_t at = urdf.find("</joint>", urdf.find("arm_joint"));
  folder.Write("models/axel/axel.urdf",
               urdf.substr(0, at) + "<dynamics damping=\"0.1\"/>" + urdf.substr(at));
  EXPECT_THAT(
      MessageOf([&] { LoadRover((folder.path() / "models/axel/axel.yaml").string()); }, folder),
      HasSubstr("joint 'arm_joint': expected neither damping, friction nor <mimic>: the robot's "
                "YAML file has the motors' friction"));
}

}  // namespace
}  // namespace dockyard::axel
