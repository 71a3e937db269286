#include "sim/paths/path_watch.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/paths/plan_meshes.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPeriod_s = 0.1;
constexpr double kStill_s = 1.0;  // at the end
// How the rover is drawn; no path depends on it.
constexpr double kBodyLow_m = 0.14, kBodyHigh_m = 0.30, kObstacleHeight_m = 0.12;
constexpr double kThin_m = 0.003, kMiddle_m = 0.006, kThick_m = 0.02;  // of lines
const Vector3d kKept_rgb{0.35, 0.42, 0.5}, kLeftOut_rgb{0.55, 0.2, 0.15}, kPath_rgb{0.02, 0.2, 0.6};
const Vector3d kBody_rgb{0.55, 0.5, 0.4}, kWheel_rgb{0.15, 0.15, 0.16}, kStone_rgb{0.4, 0.3, 0.2};

/// The rover at one time.
struct Moment {
  Pose2 X_AR;
  std::vector<double> steer_rad, way_m, speed_m_s;  // by wheel; way since the start
};

std::vector<Disc> ShownDiscs(const PathTask& task) {
  std::vector<Disc> discs = task.demands.obstacles.discs;
  if (discs.size() <= kMostShownDiscs) return discs;
  const auto Away = [&](const Disc& disc) {
    return std::min(disc.centre.norm(), (disc.centre - task.p_AG).norm()) - disc.radius_m;
  };
  std::stable_sort(discs.begin(), discs.end(),
                   [&](const Disc& a, const Disc& b) { return Away(a) < Away(b); });
  discs.resize(kMostShownDiscs);
  return discs;
}

/// The moments of a path, every period.
class Film {
 public:
  explicit Film(const RoverPlan& rover) : rover_(rover) {
    const std::vector<double> zeros(rover.wheels.size(), 0.0);
    now_ = {{}, zeros, zeros, zeros};
    moments.push_back(now_);
  }

  void Steer(const Arc& arc) {
    std::vector<double> to;
    double most = 0.0;
    for (std::size_t i = 0; i < rover_.wheels.size(); ++i) {
      to.push_back(OnArc(rover_.wheels[i], arc).steer_rad);
      most = std::max(most, std::abs(to[i] - now_.steer_rad[i]));
    }
    const Moment from = now_;
    Pass(most / rover_.steer_rate_rad_s, [&](double share) {
      for (std::size_t i = 0; i < to.size(); ++i) {
        now_.steer_rad[i] = from.steer_rad[i] + share * (to[i] - from.steer_rad[i]);
      }
    });
  }

  void Drive(const Arc& arc) {
    std::vector<double> ways;
    double most = std::abs(arc.length_m);
    for (const WheelPlan& wheel : rover_.wheels) {
      ways.push_back(OnArc(wheel, arc).way_m);
      most = std::max(most, std::abs(ways.back()));
    }
    const Moment from = now_;
    const double time_s = most / rover_.speed_m_s;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      now_.speed_m_s[i] = time_s > 0.0 ? ways[i] / time_s : 0.0;
    }
    Pass(time_s, [&](double share) {
      now_.X_AR = Advance(from.X_AR, Part(arc, share));
      for (std::size_t i = 0; i < ways.size(); ++i) now_.way_m[i] = from.way_m[i] + share * ways[i];
    });
    std::fill(now_.speed_m_s.begin(), now_.speed_m_s.end(), 0.0);
  }

  void Wait(double time_s) {
    Pass(time_s, [](double) {});
  }

  double time_s() const { return kPeriod_s * static_cast<double>(moments.size() - 1); }

  std::vector<Moment> moments;

 private:
  // Whole periods, so that each part ends on a moment.
  template <class Set>
  void Pass(double time_s, const Set& set) {
    const int count = static_cast<int>(std::ceil(time_s / kPeriod_s - 1e-9));
    for (int i = 1; i <= count; ++i) {
      set(static_cast<double>(i) / count);
      moments.push_back(now_);
    }
  }

  const RoverPlan& rover_;
  Moment now_;
};

Pose3 WheelPose(const RoverPlan& rover, std::size_t wheel, const Moment& at) {
  const Vector2d& p = rover.wheels[wheel].p_RW;
  Pose3 X_RW = Pose3::Translation(p.x(), p.y(), rover.wheel_radius_m);
  X_RW.R = RotZ(at.steer_rad[wheel]) * RotY(at.way_m[wheel] / rover.wheel_radius_m);
  return FromGround(at.X_AR, 0.0) * X_RW;
}

StageLine LineOf(const std::vector<Arc>& arcs, double diameter_m, const Vector3d& rgb) {
  StageLine line{"", diameter_m, rgb, {}};
  for (const Pose2& X : PosesAlong(arcs, 0.03, 0.05)) {
    line.points_W.emplace_back(X.x, X.y, 0.5 * diameter_m);
  }
  return line;
}

}  // namespace

LoggedRun WatchedPath(const PathTask& task, const PlannedPath& plan) {
  DOCKYARD_CHECK(plan.best && !task.rover.wheels.empty());
  const RoverPlan& rover = task.rover;
  LoggedRun run;
  Film film(rover);
  int number = 0;
  for (const Arc& arc : plan.best->arcs) {
    const std::string name = "arc " + std::to_string(++number);
    run.notes.push_back({film.time_s(), {"phase", "steering for " + name}});
    film.Steer(arc);
    run.notes.push_back({film.time_s(), {"phase", name}});
    film.Drive(arc);
  }
  run.notes.push_back({film.time_s(), {"phase", "at the goal"}});
  film.Wait(kStill_s);

  const std::size_t samples = film.moments.size();
  run.complete = true;
  run.outcome = {{"failure_note", Words(plan)}};
  run.body_names = {rover.name};
  for (const WheelPlan& wheel : rover.wheels) run.body_names.push_back(wheel.name);
  run.body_names.push_back("obstacles");
  run.X_WO.resize(run.body_names.size());
  run.X_WG.assign(samples, {});
  // The target's frame: at the goal, its x axis against the rover's.
  const Pose2 X_AE = Advance({}, plan.best->arcs);
  const Vector2d p_AP = X_AE * task.p_RP;
  const Pose2 X_AD{p_AP.x(), p_AP.y(), WrapPi(X_AE.heading + kPi)};
  run.X_WD.assign(samples, FromGround(X_AD, 0.0));
  for (std::size_t k = 0; k < samples; ++k) {
    const Moment& at = film.moments[k];
    run.times_s.push_back(kPeriod_s * static_cast<double>(k));
    run.X_WO[0].push_back(FromGround(at.X_AR, 0.0));
    for (std::size_t i = 0; i < rover.wheels.size(); ++i) {
      run.X_WO[i + 1].push_back(WheelPose(rover, i, at));
      run.truth["steer_" + rover.wheels[i].name + "_deg"].push_back(Degrees(at.steer_rad[i]));
      run.truth["speed_" + rover.wheels[i].name + "_m_s"].push_back(at.speed_m_s[i]);
    }
    run.X_WO.back().push_back({});
    const Pose2 X_DR = Inverse(X_AD) * at.X_AR;
    run.truth["x_m"].push_back(X_DR.x);
    run.truth["y_m"].push_back(X_DR.y);
    run.truth["heading_rad"].push_back(X_DR.heading);
  }
  int shown = 0;
  for (const Candidate& candidate : plan.candidates) {
    const bool usable = candidate.IsUsable();
    run.lines["candidate " + std::to_string(++shown)].assign(
        samples,
        LineOf(candidate.arcs, usable ? kMiddle_m : kThin_m, usable ? kKept_rgb : kLeftOut_rgb));
  }
  run.lines["path"].assign(samples, LineOf(plan.best->arcs, kThick_m, kPath_rgb));
  return run;
}

StageShapes ShapesOf(const PathTask& task) {
  const RoverPlan& rover = task.rover;
  StageShapes shapes;
  StageBody body{rover.name, true, {}};
  for (const Polygon& part : rover.body) {
    body.parts.push_back({PrismMesh(part, kBodyLow_m, kBodyHigh_m), {}, kBody_rgb});
  }
  shapes.bodies.push_back(body);
  const auto wheel = PrismMesh(Round({{0, 0}, rover.wheel_radius_m}, 20),
                               -0.5 * rover.wheel_width_m, 0.5 * rover.wheel_width_m);
  Pose3 X_OP;
  X_OP.R = RotX(0.5 * kPi);  // the prism's upright axis becomes the axle
  for (const WheelPlan& mount : rover.wheels) {
    shapes.bodies.push_back({mount.name, true, {{wheel, X_OP, kWheel_rgb}}});
  }
  StageBody stones{"obstacles", false, {}};
  for (const Disc& disc : ShownDiscs(task)) {
    stones.parts.push_back({PrismMesh(Round(disc, 32), 0.0, kObstacleHeight_m), {}, kStone_rgb});
  }
  for (const Polygon& polygon : task.demands.obstacles.polygons) {
    stones.parts.push_back({PrismMesh(polygon, 0.0, kObstacleHeight_m), {}, kStone_rgb});
  }
  shapes.bodies.push_back(stones);
  shapes.light.to_sun_W = Vector3d(0.4, 0.3, 0.87).normalized();
  return shapes;
}

std::vector<Column> WatchedChannels(const RoverPlan& rover) {
  std::vector<Column> columns;
  for (const WheelPlan& wheel : rover.wheels) {
    if (wheel.steer_limit_rad == 0.0) continue;
    columns.push_back({"steer_" + wheel.name + "_deg", "deg", "steering angle, to the left"});
  }
  for (const WheelPlan& wheel : rover.wheels) {
    columns.push_back({"speed_" + wheel.name + "_m_s", "m/s", "of the wheel's rim, forwards"});
  }
  return columns;
}

}  // namespace dockyard
