// How a robot rests on level ground: on which of its wheels, and which of them hang in the air. Of
// rigid robots, whose wheels are at their places but for casters and steering.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "controller/base/number_text.h"
#include "models/parts/gravity.h"
#include "models/read/load_model_yaml.h"
#include "sim/custom/findings.h"

namespace dockyard::custom {
namespace {

using Eigen::Vector3d;

constexpr double kUpright = 0.999;  // cosine; of a joint that steers
// Off the ground by this a wheel is as its maker meant it: casters are set so that the driven
// wheels always bear. Assumed, 1-5 mm.
constexpr double kPlay_m = 2e-3;
// A robot that rests turned by more does not have its cameras and pins where its drawing has them.
// Assumed, 0.5-2 deg.
constexpr double kLevel_rad = Radians(1.0);

struct Tread {
  std::string name;
  Vector3d p_R{0, 0, 0};  // its lowest point
  double yields_m = 0.0;  // under the whole robot
  bool driven = false;
};

/// The plane z = height at the centre of mass + slope . (x, y from there), in R.
struct Ground {
  double height_m = 0.0;
  Eigen::Vector2d slope{0, 0};
  Vector3d p_RCom{0, 0, 0};

  double Below(const Vector3d& p_R) const {
    return p_R.z() - height_m - slope.dot((p_R - p_RCom).head<2>());
  }
};

/// Whether joints between the wheel and the root may let it up or down.
bool IsSprung(const LinkTree& tree, const std::vector<Pose3>& X_RL, const WheelFit& wheel) {
  if (wheel.link == 0) return false;
  const auto upright = [&](int link) {
    const Vector3d axis_R = X_RL[static_cast<std::size_t>(link)].R * tree.joint(link).axis_L;
    return !tree.joint(link).slides && std::abs(axis_R.z()) > kUpright;
  };
  for (int at = wheel.tyre.ball ? wheel.link : tree.joint(wheel.link).carrier; at > 0;
       at = tree.joint(at).carrier) {
    if (!upright(at)) return true;
  }
  return false;
}

/// The URDF's link that is the wheel: a ball's may be fixed to another.
std::string NameOf(const LinkTree& tree, const WheelFit& wheel) {
  std::string name = tree.link(wheel.link).name;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const NamedFrame& frame : tree.frames) {
    const double off_m = (frame.X_LF.p - wheel.p_LK).norm();
    if (frame.link != wheel.link || off_m >= nearest_m) continue;
    nearest_m = off_m;
    name = frame.name;
  }
  return name;
}

std::vector<Tread> TreadsOf(const RobotModel& robot, const std::vector<Pose3>& X_RL) {
  std::vector<Tread> treads;
  const double weight_n = robot.tree.mass_kg() * kEarthGravity_m_s2;
  for (const WheelFit& wheel : robot.wheels) {
    Tread& tread = treads.emplace_back();
    tread.name = NameOf(robot.tree, wheel);
    tread.p_R = X_RL[static_cast<std::size_t>(wheel.link)] * wheel.p_LK -
                wheel.tyre.radius_m * Vector3d::UnitZ();
    tread.yields_m = weight_n / wheel.tyre.stiffness_n_per_m;
    tread.driven = std::any_of(robot.motors.begin(), robot.motors.end(),
                               [&](const MotorFit& motor) { return motor.link == wheel.link; });
  }
  return treads;
}

Vector3d CentreOfMass(const LinkTree& tree, const std::vector<Pose3>& X_RL) {
  Vector3d sum{0, 0, 0};
  for (int i = 0; i < tree.link_count(); ++i) {
    sum += tree.link(i).mass_kg * (X_RL[static_cast<std::size_t>(i)] * tree.link(i).p_LoCom_L);
  }
  return sum / tree.mass_kg();
}

/// Whether p is within the triangle, in plan.
bool IsBetween(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto side = [&](const Vector3d& from, const Vector3d& to) {
    return (to - from).head<2>().dot(Eigen::Vector2d((p - from).y(), -(p - from).x()));
  };
  const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
  return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
}

/// How the treads bear: on the plane through three of them that lies under all of them, with the
/// weight between the three.
struct Support {
  bool in_a_row = true;  // the treads, in plan
  std::optional<Ground> ground;
};

void TrySupport(const std::array<Vector3d, 3>& on, const Vector3d& p_RCom,
                const std::vector<Tread>& treads, Support& support) {
  constexpr double kInARow_m2 = 1e-6, kUnder_m = 1e-9;  // numerical
  const Vector3d normal = (on[1] - on[0]).cross(on[2] - on[0]);
  if (std::abs(normal.z()) < kInARow_m2) return;
  support.in_a_row = false;
  if (!IsBetween(p_RCom, on[0], on[1], on[2])) return;
  Ground ground;
  ground.p_RCom = p_RCom;
  ground.slope = -normal.head<2>() / normal.z();
  ground.height_m = on[0].z() + ground.slope.dot((p_RCom - on[0]).head<2>());
  const bool under = std::all_of(treads.begin(), treads.end(), [&](const Tread& tread) {
    return ground.Below(tread.p_R) >= -kUnder_m;
  });
  if (under) support.ground = ground;
}

Support SupportOf(const std::vector<Tread>& treads, const Vector3d& p_RCom) {
  Support support;
  for (std::size_t i = 0; i < treads.size(); ++i) {
    for (std::size_t j = i + 1; j < treads.size(); ++j) {
      for (std::size_t k = j + 1; k < treads.size(); ++k) {
        TrySupport({treads[i].p_R, treads[j].p_R, treads[k].p_R}, p_RCom, treads, support);
      }
    }
  }
  return support;
}

std::string WheelsPlace(const std::string& file) {
  const YamlNode root = LoadModelYaml(file);
  const YamlNode* wheels = root.Find("wheels");
  return (wheels == nullptr ? root : *wheels).place.Text() + ": wheels: ";
}

/// Texts of the wheels that the ground does not reach. drives: whether a driven one is on it.
std::vector<std::string> Hanging(const std::vector<Tread>& treads, const Ground& ground,
                                 const std::string& place, bool& drives) {
  std::vector<std::string> texts;
  for (const Tread& tread : treads) {
    const double over_m = ground.Below(tread.p_R);
    const bool hangs = over_m > tread.yields_m + kPlay_m;
    drives = drives || (tread.driven && !hangs);
    if (!hangs) continue;
    texts.push_back(place + "expected '" + tread.name + "' on level ground, found its tread " +
                    Fixed(1e3 * over_m, 1) + " mm above that as the robot rests on the others" +
                    kWhatIsChecked);
  }
  return texts;
}

}  // namespace

Findings FindHangingWheels(const RobotModel& robot, const std::string& file) {
  Findings findings;
  const std::vector<Pose3> X_RL = StartPoses(robot.tree);
  for (const WheelFit& wheel : robot.wheels) {
    if (IsSprung(robot.tree, X_RL, wheel)) return findings;
  }
  const std::vector<Tread> treads = TreadsOf(robot, X_RL);
  const Vector3d p_RCom = CentreOfMass(robot.tree, X_RL);
  const Support support = SupportOf(treads, p_RCom);
  if (support.in_a_row) return findings;  // it rests on its body as well
  const std::string place = WheelsPlace(file);
  if (!support.ground) {
    findings.doubts.push_back(place + "expected the robot's weight between its wheels, found it " +
                              Fixed(p_RCom.x(), 3) + " m ahead and " + Fixed(p_RCom.y(), 3) +
                              " m to the left of its root, outside of them: it tips onto its body" +
                              kWhatIsChecked);
    return findings;
  }
  const double tilt_rad = std::atan(support.ground->slope.norm());
  if (tilt_rad > kLevel_rad) {
    findings.doubts.push_back(place + "expected treads at one height, found the robot tilted by " +
                              Fixed(Degrees(tilt_rad), 1) +
                              " deg as it rests on them: are the wheels' places and radii right?" +
                              kWhatIsChecked);
  }
  bool drives = false;
  const std::vector<std::string> hanging = Hanging(treads, *support.ground, place, drives);
  const bool driven =
      std::any_of(treads.begin(), treads.end(), [](const Tread& tread) { return tread.driven; });
  std::vector<std::string>& to = driven && !drives ? findings.faults : findings.doubts;
  to.insert(to.end(), hanging.begin(), hanging.end());
  return findings;
}

}  // namespace dockyard::custom
