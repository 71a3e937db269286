// Welding links on fixed joints, against sums over the unwelded tree and closed forms.
#include "models/read/urdf_weld.h"

#include <gmock/gmock.h>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "support/bad_files.h"
#include "support/urdf_text.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

std::string Origin(const std::string& xyz, const std::string& rpy) {
  return "<origin xyz=\"" + xyz + "\" rpy=\"" + rpy + "\"/>";
}

/// A link that is a solid box of this mass about its own origin, drawn and collided as one.
std::string BoxLink(const std::string& name, double mass_kg, const Eigen::Vector3d& size) {
  const std::string box = BoxGeometry(size);
  return "<link name=\"" + name + "\">" + InertialOfBox(mass_kg, size) + "<visual name=\"v_" +
         name + "\">" + Origin("0.01 0.02 0.03", "0.3 0.2 0.1") + box +
         "</visual><collision name=\"c_" + name + "\">" + Origin("0.03 0.02 0.01", "0.1 0.2 0.3") +
         box + "</collision></link>\n";
}

std::string Joint(const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& origin) {
  const bool bounded = type == "revolute" || type == "prismatic";
  return "<joint name=\"to_" + child + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + origin + "<axis xyz=\"0 0.6 0.8\"/>" +
         (bounded ? "<limit lower=\"-1\" upper=\"1\" effort=\"0\" velocity=\"0\"/>" : "") +
         "</joint>\n";
}

UrdfModel Read(const std::string& inside) {
  const ScratchFolder folder;
  return LoadUrdf(folder.Write("m.urdf", "<robot name=\"m\">\n" + inside + "</robot>\n"));
}

/// Where a link lies in the root's frame, each moving joint turned or pushed by `q`.
Pose3 PlaceOfLink(const UrdfModel& model, const std::string& link, double q) {
  for (const UrdfJoint& joint : model.joints) {
    if (joint.child != link) continue;
    Pose3 X_JL;
    if (joint.type == "prismatic") X_JL.p = q * joint.axis_J;
    if (joint.type == "revolute" || joint.type == "continuous") {
      X_JL.R = Eigen::AngleAxisd(q, joint.axis_J).toRotationMatrix();
    }
    return PlaceOfLink(model, joint.parent, q) * joint.X_PJ * X_JL;
  }
  return {};
}

/// Second moments of the whole robot's mass about the root's origin: the 4 x 4 matrix of the
/// integral of (p, 1)(p, 1)^T dm. Independent of the parallel-axis formula.
Eigen::Matrix4d MassMatrix(const UrdfModel& model, double q) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const LinkModel& link : model.links) {
    Eigen::Matrix4d own = Eigen::Matrix4d::Zero();
    const Eigen::Vector3d first = link.mass_kg * link.p_LoCom_L;
    own.topLeftCorner<3, 3>() = 0.5 * link.I_LCom_L.trace() * Eigen::Matrix3d::Identity() -
                                link.I_LCom_L + first * link.p_LoCom_L.transpose();
    own.topRightCorner<3, 1>() = first;
    own.bottomLeftCorner<1, 3>() = first.transpose();
    own(3, 3) = link.mass_kg;
    const Pose3 X = PlaceOfLink(model, link.name, q);
    Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
    T.topLeftCorner<3, 3>() = X.R;
    T.topRightCorner<3, 1>() = X.p;
    sum += T * own * T.transpose();
  }
  return sum;
}

/// Every visual and collision by name, where a corner of it lies in the root's frame.
std::map<std::string, Eigen::Vector3d> Corners(const UrdfModel& model, double q) {
  std::map<std::string, Eigen::Vector3d> corners;
  for (const LinkModel& link : model.links) {
    const Pose3 X = PlaceOfLink(model, link.name, q);
    for (const Visual& v : link.visuals) corners[v.name] = X * (v.X_LV * v.mesh->vertices.at(7));
    for (const Collision& c : link.collisions) {
      corners[c.name] = X * (c.X_LG * (0.5 * std::get<BoxShape>(c.shape).size_m));
    }
  }
  return corners;
}

/// A trunk with chains of fixed links, one of them without mass, and joints that move between.
UrdfModel Tree() {
  return Read("<link name=\"frame\"/>\n" + BoxLink("trunk", 5, {0.5, 0.4, 0.3}) +
              BoxLink("mast", 2, {0.1, 0.1, 0.9}) + BoxLink("head", 0.7, {0.2, 0.1, 0.1}) +
              BoxLink("arm", 1.5, {0.8, 0.1, 0.1}) + BoxLink("hand", 0.4, {0.1, 0.2, 0.05}) +
              BoxLink("slide", 0.9, {0.3, 0.1, 0.1}) +
              Joint("fixed", "trunk", "frame", Origin("0.1 0 0.2", "0.2 0 0.5")) +
              Joint("fixed", "frame", "mast", Origin("0 0.1 0.4", "0 0.7 0")) +
              Joint("fixed", "mast", "head", Origin("0.05 0 0.5", "1 2 3")) +
              Joint("revolute", "frame", "arm", Origin("0.3 0 0.1", "0.4 0 1")) +
              Joint("fixed", "arm", "hand", Origin("0.5 0 0", "0 1 0")) +
              Joint("prismatic", "hand", "slide", Origin("0 0.2 0", "0.1 0.1 0.1")));
}

TEST(Weld, KeepsMassCentreAndInertiaOfTheWholeTreeInEveryPose) {
  const UrdfModel tree = Tree(), welded = WeldFixedLinks(tree);
  ASSERT_EQ(tree.links.size(), 7u);
  ASSERT_EQ(welded.links.size(), 3u);
  ASSERT_EQ(welded.joints.size(), 2u);
  EXPECT_NEAR(MassMatrix(tree, 0.0)(3, 3), 10.5, 1e-12);
  for (const double q : {-0.7, 0.0, 0.4}) {
    const Eigen::Matrix4d before = MassMatrix(tree, q), after = MassMatrix(welded, q);
    EXPECT_LT((before - after).cwiseAbs().maxCoeff(), 1e-12) << q;
  }
  EXPECT_GT((MassMatrix(tree, 0.4) - MassMatrix(tree, 0.0)).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Weld, LeavesWhatIsDrawnAndCollidesWhereItWas) {
  const UrdfModel tree = Tree(), welded = WeldFixedLinks(tree);
  for (const double q : {-0.7, 0.0, 0.4}) {
    const auto before = Corners(tree, q), after = Corners(welded, q);
    ASSERT_EQ(before.size(), 12u);
    ASSERT_EQ(after.size(), 12u);
    for (const auto& [name, p] : before) EXPECT_LT((after.at(name) - p).norm(), 1e-12) << name;
  }
}

TEST(Weld, OfTwoHalvesIsTheWholeBox) {
  // Along x, the second half turned so that its own long axis is y.
  const UrdfModel halves =
      Read(BoxLink("a", 3, {0.6, 0.4, 0.2}) + BoxLink("b", 3, {0.4, 0.6, 0.2}) +
           Joint("fixed", "a", "b", Origin("0.6 0 0", "0 0 1.5707963267948966")));
  const UrdfModel welded = WeldFixedLinks(halves);
  ASSERT_EQ(welded.links.size(), 1u);
  const LinkModel& box = welded.links[0];
  EXPECT_DOUBLE_EQ(box.mass_kg, 6.0);
  EXPECT_LT((box.p_LoCom_L - Eigen::Vector3d(0.3, 0, 0)).norm(), 1e-12);
  const double a = 1.2 * 1.2, b = 0.4 * 0.4, c = 0.2 * 0.2;
  const Eigen::Vector3d moments(6 * (b + c) / 12, 6 * (a + c) / 12, 6 * (a + b) / 12);
  EXPECT_LT((box.I_LCom_L - Eigen::Matrix3d(moments.asDiagonal())).cwiseAbs().maxCoeff(), 2e-6);
}

TEST(Weld, CarriesMassOnALinkThatHasNone) {
  const UrdfModel welded =
      WeldFixedLinks(Read("<link name=\"base\"/>\n" + BoxLink("b", 2, {1, 1, 1}) +
                          Joint("fixed", "base", "b", Origin("0 0 0.5", "0 0 0"))));
  EXPECT_EQ(welded.root, "base");
  EXPECT_DOUBLE_EQ(welded.Link("base").mass_kg, 2.0);
  EXPECT_EQ(welded.Link("base").p_LoCom_L, Eigen::Vector3d(0, 0, 0.5));
}

TEST(Weld, APointMayRideOnAnotherLinkAndNotMoveByItself) {
  // Two points of 1 kg, 0.2 m apart along x, on a link without mass: a dumbbell has no moment about
  // x.
  const std::string point =
      "<inertial><mass value=\"1\"/><inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" "
      "izz=\"0\"/></inertial></link>\n";
  const auto at = [](double x, double y) {
    return "<origin xyz=\"" + std::to_string(x) + " " + std::to_string(y) + " 0\"/>";
  };
  const std::string dumbbell =
      "<link name=\"root\"/><link name=\"a\">" + point + "<link name=\"b\">" + point +
      Joint("fixed", "root", "a", at(0.1, 0)) + Joint("fixed", "root", "b", at(-0.1, 0));
  const ScratchFolder folder;
  EXPECT_THAT(MessageOf([&] { RequireInertial(WeldFixedLinks(Read(dumbbell)), "root"); }, folder),
              HasSubstr("needs three principal moments > 0"));
  const UrdfModel plate = WeldFixedLinks(
      Read(dumbbell + "<link name=\"c\">" + point + Joint("fixed", "root", "c", at(0, 0.3))));
  const Eigen::Matrix3d I = RequireInertial(plate, "root").I_LCom_L;
  // sum m y^2 about the mean 0.1, sum m x^2, and their sum, since the points lie in a plane.
  EXPECT_LT((I.diagonal() - Eigen::Vector3d(0.06, 0.02, 0.08)).norm(), 1e-12);
  EXPECT_THAT(MessageOf([&] { RequireInertial(Read("<link name=\"a\"/>"), "a"); }, folder),
              HasSubstr("expected an <inertial>, found none"));
}

TEST(Weld, NamesWhatCarriesALink) {
  const UrdfModel tree = Tree();
  EXPECT_EQ(CarrierOf(tree, "head"), "trunk");
  EXPECT_EQ(CarrierOf(tree, "hand"), "arm");
  EXPECT_EQ(CarrierOf(tree, "slide"), "slide");
}

TEST(Weld, KeepsEveryBitWhereNothingIsFixed) {
  const UrdfModel axel = LoadUrdf(SourceFile("models/axel/axel.urdf"));
  const UrdfModel welded = WeldFixedLinks(axel);
  ASSERT_EQ(welded.links.size(), axel.links.size());
  for (std::size_t i = 0; i < axel.links.size(); ++i) {
    EXPECT_EQ(welded.links[i].mass_kg, axel.links[i].mass_kg);
    EXPECT_EQ(welded.links[i].p_LoCom_L, axel.links[i].p_LoCom_L);
    EXPECT_EQ(welded.links[i].I_LCom_L, axel.links[i].I_LCom_L);
    EXPECT_EQ(welded.links[i].collisions.size(), axel.links[i].collisions.size());
  }
  for (std::size_t i = 0; i < axel.joints.size(); ++i) {
    EXPECT_EQ(welded.joints[i].X_PJ.p, axel.joints[i].X_PJ.p);
    EXPECT_EQ(welded.joints[i].X_PJ.R, axel.joints[i].X_PJ.R);
  }
}

/// Of the rover's or the station's files, without their endings.
std::string PathOf(const std::string& model) {
  return model == "axel" ? "models/axel/axel" : "models/axel/station/station";
}

/// The message for a model with `added` before the end of its URDF.
std::string MessageWith(const std::string& model, const std::string& added) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string path = PathOf(model);
  folder.Write(path + ".urdf",
               Replaced(Slurp(SourceFile(path + ".urdf")), "</robot>", added + "</robot>"));
  const std::string file = (folder.path() / (path + ".yaml")).string();
  return MessageOf(
      [&] { model == "axel" ? (void)axel::LoadRover(file) : (void)axel::LoadStation(file); },
      folder);
}

/// The line of a URDF's closing tag, where MessageWith puts what it adds.
std::string LastLine(const std::string& model) {
  const std::string text = Slurp(SourceFile(PathOf(model) + ".urdf"));
  return std::to_string(std::count(text.begin(), text.end(), '\n'));
}

TEST(RoverLinks, AMastOnAFixedJointIsPartOfTheBody) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string mast = BoxLink("mast", 6, {0.1, 0.1, 0.5}) +
                           Joint("fixed", "body", "mast", Origin("0.1 0 0.5", "0 0 0"));
  folder.Write("models/axel/axel.urdf",
               Replaced(Slurp(SourceFile("models/axel/axel.urdf")), "</robot>", mast + "</robot>"));
  const axel::RoverModel plain = axel::LoadRover(SourceFile("models/axel/axel.yaml"));
  const axel::RoverModel rover =
      axel::LoadRover((folder.path() / "models/axel/axel.yaml").string());
  EXPECT_DOUBLE_EQ(rover.mass_kg(), 46.0);
  EXPECT_DOUBLE_EQ(rover.body.mass_kg, 30.0);
  const Eigen::Vector3d com((24 * -0.04 + 6 * 0.1) / 30, 0, 6 * 0.5 / 30);
  EXPECT_LT((rover.body.p_LoCom_L - com).norm(), 1e-12);
  // About the pitch axis: both, and the reduced mass between their centres.
  const double reduced_kg = 24.0 * 6.0 / 30.0, apart2 = 0.14 * 0.14 + 0.5 * 0.5;
  EXPECT_NEAR(rover.body.I_LCom_L(1, 1),
              plain.body.I_LCom_L(1, 1) + 6 * (0.01 + 0.25) / 12 + reduced_kg * apart2, 1e-6);
  EXPECT_EQ(rover.body.visuals.size(), plain.body.visuals.size() + 1);
  EXPECT_EQ(rover.body.collisions.size(), plain.body.collisions.size() + 1);
  EXPECT_EQ(rover.arm.I_LCom_L, plain.arm.I_LCom_L);
}

TEST(RoverLinks, AJointOfSeveralFreedomsIsRefusedWithItsLine) {
  for (const char* type : {"floating", "planar"}) {
    EXPECT_EQ(
        MessageWith("axel", BoxLink("extra", 2, {0.1, 0.1, 0.1}) + Joint(type, "arm", "extra", "")),
        "models/axel/axel.urdf:" + std::to_string(std::stoi(LastLine("axel")) + 1) +
            ":1: joint 'to_extra': a " + type +
            " joint from 'arm' to 'extra' is not simulated, only continuous, revolute, "
            "prismatic and fixed ones are");
  }
  for (const char* type : {"continuous", "revolute", "prismatic"}) {
    EXPECT_EQ(
        MessageWith("axel", BoxLink("extra", 2, {0.1, 0.1, 0.1}) + Joint(type, "arm", "extra", "")),
        "(no error)");
  }
}

TEST(RoverLinks, AFurtherLinkWithoutMassIsRefused) {
  EXPECT_THAT(
      MessageWith("axel", "<link name=\"ghost\"/>" + Joint("continuous", "body", "ghost", "")),
      HasSubstr("expected an <inertial>, found none"));
}

TEST(RoverLinks, TheNameOfAnotherBodyIsRefused) {
  EXPECT_THAT(
      MessageWith("axel", BoxLink("station", 1, {0.1, 0.1, 0.1}) +
                              Joint("continuous", "body", "station", "")),
      HasSubstr("expected another name than 'station', which something else has in the logs"));
}

TEST(RoverLinks, ALinkOnNoJointIsRefusedWithItsLine) {
  EXPECT_EQ(MessageWith("axel", "<link name=\"lost\"/>"),
            "models/axel/axel.urdf:" + LastLine("axel") +
                ":1: <link>: 'lost' hangs on no joint, expected one tree, its root is 'body'");
}

TEST(RoverLinks, APartOfTheArmThatReachesPastTheTipIsRefused) {
  // Past the tip's middle nothing but its disc meets the cone: it would be dropped.
  const std::string box = BoxLink("claw", 0.1, {0.02, 0.02, 0.02});
  EXPECT_EQ(MessageWith("axel", box + Joint("fixed", "arm", "claw", Origin("0.9 0 0", "0 0 0"))),
            "(no error)");
  EXPECT_THAT(MessageWith("axel", box + Joint("fixed", "arm", "claw", Origin("1.0 0 0", "0 0 0"))),
              HasSubstr("link 'arm': collision 'c_claw' reaches to x 1.0"));
}

TEST(RoverLinks, AMeshOnTheArmIsRefusedAsItsContactWithTheConeIsNotSimulated) {
  const std::string claw =
      "<link name=\"claw\"><collision name=\"c_claw\"><geometry>"
      "<mesh filename=\"meshes/wheel.obj\" scale=\"0.1 0.1 0.1\"/></geometry></collision></link>";
  EXPECT_THAT(MessageWith("axel", claw + Joint("fixed", "arm", "claw", Origin("0.5 0 0", "0 0 0"))),
              HasSubstr("collision 'c_claw': expected a cylinder, sphere or box, found a mesh"));
}

TEST(StationLinks, AFixedPartOfTheModuleCountsAndOneOfTheStandMayNotWeigh) {
  const std::string ballast = BoxLink("ballast", 5, {0.1, 0.1, 0.1});
  EXPECT_EQ(MessageWith("station",
                        ballast + Joint("fixed", "module", "ballast", Origin("-0.4 0 0", "0 0 0"))),
            "(no error)");
  EXPECT_THAT(MessageWith("station", ballast + Joint("fixed", "stand", "ballast", "")),
              HasSubstr("models/axel/station/station.urdf:" + LastLine("station") +
                        ":1: link 'ballast': expected neither <inertial> nor <collision>"));
  EXPECT_THAT(MessageWith("station", ballast + Joint("revolute", "module", "ballast", "")),
              HasSubstr("joint 'to_ballast': a revolute joint from 'module' to 'ballast' is not "
                        "simulated, only 'stand' and 'module' are"));
}

}  // namespace
}  // namespace dockyard
