#include "sim/axel/cable_tether.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {
namespace {

// The last mass stands between these shares of the spacing before the mouth.
constexpr double kFarthest = 1.5, kNearest = 0.5;
// Laying out: a mass inside a solid is pushed out by this per step [m]; the tether is paid out
// where it would pull by more than this [N], by this per step [m]. Numerical.
constexpr double kPushedOut_m = 5e-4, kLaidWith_n = 1.0, kPaidOut_m = 2e-4;
constexpr int kLayingSteps = 3000, kSettlingSteps = 1500;
constexpr double kLayingStep_s = 1e-3;

/// The massless tether in the cone, as the end of the cable outside.
class ConeEnd : public CableEnd {
 public:
  ConeEnd(const Tether& inner, const Pose3& X_GM, const StationBody& station)
      : inner_(inner), X_GM_(X_GM), X_MG_(Inverse(X_GM)), station_(station) {}

  /// Where the mass at p would be against the mouth after a step.
  Eigen::Vector3d After(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G, double h) const {
    return X_MG_ * (p_G + h * (v_G - station_.motion().VelocityAt(p_G)));
  }
  CablePull Try(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G, double h) const override {
    const Eigen::Vector3d p_M = After(p_G, v_G, h);
    const TetherLoad load = PullAt(p_M);
    CablePull pull;
    if (load.tension_n <= 0.0) return pull;
    const Eigen::Vector3d dir_M = load.force_on_tip_M / load.tension_n;
    constexpr double kDifference_m = 1e-6;
    const double more_n = PullAt(p_M - kDifference_m * dir_M).tension_n;
    const double stiffness = std::max(0.0, (more_n - load.tension_n) / kDifference_m);
    const Eigen::Vector3d dir = X_GM_.R * dir_M;
    const double across = load.tension_n / std::max(1e-3, (load.p_M[0] - p_M).norm());
    pull.force_G = load.tension_n * dir;
    pull.resistance = h * (stiffness - across) * dir * dir.transpose();
    pull.resistance.diagonal().array() += h * across;
    return pull;
  }

 private:
  TetherLoad PullAt(const Eigen::Vector3d& p_M) const {
    Tether tried = inner_;
    return tried.Step(p_M, Eigen::Vector3d::Zero(), inner_.free_m(), 0.0);
  }
  const Tether& inner_;
  Pose3 X_GM_, X_MG_;
  const StationBody& station_;
};

}  // namespace

TetherPlace CableTether::PlaceOf(const RoverBody& rover, const StationBody& station) const {
  const LinkMotion& arm = rover.motion(RoverLink::kArm);
  const Eigen::Vector3d p_GT = arm.X_GL * Eigen::Vector3d(arm_length_m_, 0.0, 0.0);
  return {station.X_GM(), p_GT, arm.VelocityAt(p_GT)};
}

// Way along the tether from a place to the lip, or to the mouth's plane where it passes clear of
// the lip; < 0 in the mouth.
double CableTether::MouthAhead_m(const Eigen::Vector3d& p_M) const {
  const double radius = std::hypot(p_M.y(), p_M.z());
  if (p_M.x() <= 0.0 && radius < mouth_radius_m_) return -1.0;
  const TetherPath& path = inner_.path();
  const Eigen::Vector2d at(p_M.x(), radius), next = path.nodes[1];
  const double share = next.x() < 0.0 ? at.x() / std::max(1e-9, at.x() - next.x()) : 1.0;
  return std::clamp(share, 0.0, 1.0) * (next - at).norm();
}

// Masses come and go before the mouth, where the strain on both sides is the same.
void CableTether::MoveEnds(const TetherPlace& place, const StationBody& station) {
  const Pose3 X_MG = Inverse(place.X_GM);
  const Eigen::Vector3d p_MT = X_MG * place.p_GT;
  const bool tip_in = MouthAhead_m(p_MT) < kNearest * spacing_m_;
  while (cable_.masses() > 0) {
    const Eigen::Vector3d p_M = X_MG * cable_.p_G(cable_.masses() - 1);
    const bool used_up = cable_.masses() == 1 && cable_.rest_m(0) < kNearest * spacing_m_;
    if (!tip_in && !used_up && MouthAhead_m(p_M) >= kNearest * spacing_m_) break;
    const double rest = cable_.DropLast();
    const bool none = cable_.masses() == 0;
    const Eigen::Vector3d before = none ? p_MT : X_MG * cable_.p_G(cable_.masses() - 1);
    inner_.BeginAt(before, -rest, none ? arm_length_m_ : 0.0, none ? model_.damping_ns_per_m : 0.0);
  }
  if (tip_in) return;
  for (;;) {
    const bool none = cable_.masses() == 0;
    const Eigen::Vector3d p_M = none ? p_MT : X_MG * cable_.p_G(cable_.masses() - 1);
    if (MouthAhead_m(p_M) < kFarthest * spacing_m_) return;
    const TetherPath& path = inner_.path();
    const double free = inner_.first_free_m(), inside = none ? arm_length_m_ : 0.0;
    const double strain = std::max(0.0, (path.length_m[0] - free) / (free + inside));
    // A slack piece may be longer than its way: then its masses share the slack.
    const double length = spacing_m_ + strain * (spacing_m_ + inside);
    const double rest = strain > 0.0 ? spacing_m_ : spacing_m_ * free / path.length_m[0];
    Eigen::Vector3d next_M(path.nodes[1].x(), 0.0, 0.0);
    const double radius = std::hypot(p_M.y(), p_M.z());
    if (radius > 0.0) next_M += path.nodes[1].y() / radius * Eigen::Vector3d(0.0, p_M.y(), p_M.z());
    const Eigen::Vector3d born_M = p_M + length * (next_M - p_M).normalized();
    const Eigen::Vector3d born_G = place.X_GM * born_M;
    cable_.AddLast(born_G, station.motion().VelocityAt(born_G), rest);
    inner_.BeginAt(born_M, rest, 0.0, 0.0);
  }
}

CableStep CableTether::MakeStep(const TetherPlace& place, const HeightGrid& ground,
                                const Eigen::Vector3d& gravity_G, double step_s) const {
  CableStep step;
  step.step_s = step_s;
  step.gravity_G = gravity_G;
  step.ground = &ground;
  step.bodies = &bodies_;
  step.p_GF = place.p_GT;
  step.v_GF_G = place.v_GT_G;
  step.end_rest_m = inner_.free_m();
  return step;
}

void CableTether::Relax(const TetherPlace& place, const StationBody& station,
                        const HeightGrid& ground) {
  // Without weight and at rest after every step it becomes the shortest way round.
  CableStep step = MakeStep(place, ground, Eigen::Vector3d::Zero(), kLayingStep_s);
  const ConeEnd end(inner_, place.X_GM, station);
  step.end = &end;
  cable_.deepest_m = kPushedOut_m;
  for (int i = 0; i < kLayingSteps && cable_.masses() > 0; ++i) {
    cable_.Calm();
    step.end_rest_m = inner_.free_m();
    step.fed_m = cable_.tension_at_fed_end_n() > kLaidWith_n ? kPaidOut_m : 0.0;
    cable_.Step(step);
    const int last = cable_.masses() - 1;
    inner_.Step(Inverse(place.X_GM) * cable_.p_G(last), Eigen::Vector3d::Zero(), inner_.free_m(),
                0.0);
    if (i > 10 && cable_.fastest_m_s() < 1e-3 && step.fed_m == 0.0) break;
  }
  cable_.deepest_m = 1e9;
  cable_.Calm();
}

double CableTether::TieUp(const RoverBody& rover, const StationBody& station,
                          const HeightGrid& ground, const Eigen::Vector3d& gravity_G,
                          double slack_m) {
  PlaceBodies(rover, station, true);
  TetherPlace place = PlaceOf(rover, station);
  place.v_GT_G.setZero();
  const Eigen::Vector3d p_MT = Inverse(place.X_GM) * place.p_GT;
  inner_.LayOut(p_MT, 1.0);
  inner_.LayOut(p_MT, inner_.path_m());
  cable_.Clear();
  MoveEnds(place, station);
  if (cable_.masses() == 0) {
    inner_.LayOut(p_MT, inner_.path_m() + slack_m);
    return inner_.free_m();
  }
  Relax(place, station, ground);
  CableStep step = MakeStep(place, ground, gravity_G, kLayingStep_s);
  const ConeEnd end(inner_, place.X_GM, station);
  step.end = &end;
  for (int i = 0; i < kSettlingSteps; ++i) {
    step.fed_m = 2 * i < kSettlingSteps ? 2.0 * slack_m / kSettlingSteps : 0.0;
    step.end_rest_m = inner_.free_m();
    cable_.Step(step);
    const int last = cable_.masses() - 1;
    inner_.Step(Inverse(place.X_GM) * cable_.p_G(last), Eigen::Vector3d::Zero(), inner_.free_m(),
                0.0);
  }
  return rest_m();
}

double CableTether::PullDirectly(const TetherPlace& place, double free_m, double free_rate_m_s,
                                 RoverBody& rover, StationBody& station) {
  const Pose3 X_MG = Inverse(place.X_GM);
  const Eigen::Vector3d v_G = place.v_GT_G - station.motion().VelocityAt(place.p_GT);
  const TetherLoad load = inner_.Step(X_MG * place.p_GT, X_MG.R * v_G, free_m, free_rate_m_s);
  tension_n_ = load.tension_n;
  Give(RoverLink::kArm, place.X_GM.R * load.force_on_tip_M, place.p_GT, rover);
  for (int i = 0; i < load.nodes; ++i) {
    Give(place.X_GM.R * load.force_on_station_M[i], place.X_GM * load.p_M[i], station);
  }
  return tension_n_;
}

double CableTether::Step(const HeightGrid& ground, const Eigen::Vector3d& gravity_G, double free_m,
                         double free_rate_m_s, double step_s, RoverBody& rover,
                         StationBody& station) {
  const TetherPlace place = PlaceOf(rover, station);
  MoveEnds(place, station);
  force_given_G_.setZero();
  if (cable_.masses() == 0) return PullDirectly(place, free_m, free_rate_m_s, rover, station);
  PlaceBodies(rover, station, false);
  CableStep step = MakeStep(place, ground, gravity_G, step_s);
  step.fed_m = free_m - rest_m();
  const ConeEnd end(inner_, place.X_GM, station);
  step.end = &end;
  cable_.Step(step);
  const int last = cable_.masses() - 1;
  const Eigen::Vector3d before_G = cable_.p_G(last) - step_s * cable_.v_G(last);
  const TetherLoad inner = inner_.Step(end.After(before_G, cable_.v_G(last), step_s),
                                       Eigen::Vector3d::Zero(), inner_.free_m(), 0.0);
  GiveForces(place, gravity_G, inner, rover, station);
  return tension_n_;
}

void CableTether::Give(RoverLink link, const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G,
                       RoverBody& rover) {
  rover.AddForce(link, force_G, p_G);
  force_given_G_ += force_G;
}

void CableTether::Give(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G,
                       StationBody& station) {
  station.AddForce(force_G, p_G);
  force_given_G_ += force_G;
}

void CableTether::GiveForces(const TetherPlace& place, const Eigen::Vector3d& gravity_G,
                             const TetherLoad& inner, RoverBody& rover, StationBody& station) {
  tension_n_ = cable_.tension_at_fed_end_n();
  Give(RoverLink::kArm, cable_.force_on_fed_end_G(), place.p_GT, rover);
  for (const CableLoad& load : cable_.loads()) {
    const Carried& carried = carried_[static_cast<std::size_t>(load.body)];
    if (carried.by == Carrier::kRover) {
      Give(carried.link, load.force_G, load.p_G, rover);
    } else if (carried.by == Carrier::kStation) {
      Give(load.force_G, load.p_G, station);
    }
  }
  // The cone takes what the last mass felt, at lip, throat and anchor as the inner part lies, and
  // the weight of that part.
  // But for the half of a spacing that the last mass stands for.
  const double held_m = inner_.free_m() - 0.5 * std::min(inner_.free_m(), spacing_m_);
  Eigen::Vector3d left_G = -cable_.force_of_end_G() + model_.mass_kg_per_m * held_m * gravity_G;
  for (int i = 0; i < inner.nodes; ++i) {
    const Eigen::Vector3d force_G = place.X_GM.R * inner.force_on_station_M[i];
    Give(force_G, place.X_GM * inner.p_M[i], station);
    left_G -= force_G;
  }
  Give(left_G, place.X_GM * inner.p_M[0], station);
}

double CableTether::path_m(const RoverBody& rover) const {
  if (cable_.masses() == 0) return inner_.path_m();
  const Eigen::Vector3d tip_A(arm_length_m_, 0.0, 0.0);
  return cable_.length_m(rover.motion(RoverLink::kArm).X_GL * tip_A) + inner_.path_m();
}

std::vector<Eigen::Vector3d> CableTether::Line(const RoverBody& rover,
                                               const StationBody& station) const {
  const TetherPlace place = PlaceOf(rover, station);
  std::vector<Eigen::Vector3d> line = cable_.Line(place.p_GT, bodies_);
  const Eigen::Vector3d p_M = Inverse(place.X_GM) * line.back();
  const double radius = std::hypot(p_M.y(), p_M.z());
  Eigen::Vector3d out_M = Eigen::Vector3d::UnitZ();
  if (radius > 0.0) out_M = Eigen::Vector3d(0.0, p_M.y(), p_M.z()) / radius;
  for (int i = 1; i <= inner_.path().pieces; ++i) {
    const Eigen::Vector2d& at = inner_.path().nodes[i];
    line.push_back(place.X_GM *
                   Eigen::Vector3d(at.x() * Eigen::Vector3d::UnitX() + at.y() * out_M));
  }
  return line;
}

std::uint64_t CableTether::StateHash(std::uint64_t seed) const {
  return inner_.StateHash(cable_.StateHash(seed));
}

}  // namespace dockyard::axel
