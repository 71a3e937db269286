#include "sim/spectator/near_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sim/spectator/sight_lines.h"
#include "sim/spectator/viewpoint.h"

namespace dockyard {
namespace {

// Radius about the point: three times its body's, so that a tool that takes it is in the image.
// Assumed, 2-5 times and 0.1-0.2 to 0.2-0.5 m; a tool of a rover is 0.1-0.2 m wide.
constexpr double kAroundBody = 3.0, kLeastRadius_m = 0.15, kLargestRadius_m = 0.3;
// The robot is at the point: assumed, 0.05-0.2 m, what an arm moves through as it works there.
constexpr double kAtPoint_m = 0.1;
// What is as near to the point is no obstacle but what the image is of; shares of the radius.
constexpr double kOwnShare = 0.5, kRingShare = 0.6;
// To the robot's parts, so that they do not fill the image. Assumed, 0.1-0.3 m.
constexpr double kClear_m = 0.15;
// What the nearness of a direction to the usual one is worth, in shares of the image's middle that
// nothing hides. Assumed, 0.02-0.1: it decides among directions that are about as free.
constexpr double kUsual = 0.05;
// Directions and samples that are tried; the surface of a target is within kSkin_m of its point.
constexpr int kAzimuths = 24, kRing = 8;
constexpr double kHeights_rad[] = {15.0 * kPi / 180.0, 24.0 * kPi / 180.0, 40.0 * kPi / 180.0};
constexpr std::size_t kSamples = 12, kSamplesOfAll = 40;
constexpr double kSkin_m = 0.03;

/// What a point is on.
struct Carrier {
  std::string body;  // empty: a place
  bool robot = false;
};

Carrier CarrierOf(const Aim& aim, const StageShapes& shapes) {
  if (aim.p_D) return {};
  std::string name = aim.name;
  for (const StagePoint& point : shapes.points) {
    if (point.name == aim.name) name = point.body;
  }
  for (const StageBody& body : shapes.bodies) {
    if (body.name == name || (aim.name == "robot" && body.robot)) return {body.name, body.robot};
  }
  return {};
}

std::vector<std::size_t> Thinned(const std::vector<std::size_t>& samples, std::size_t most) {
  if (samples.size() <= most) return samples;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < most; ++i) {
    kept.push_back(samples[i * (samples.size() - 1) / (most - 1)]);
  }
  return kept;
}

struct Tried {
  const LoggedRun& run;
  const StageShapes& shapes;
  const Aim& aim;
  const SightLines& lines;
  Carrier carrier;
  double radius_m = 0.0, distance_m = 0.0;
  std::vector<std::size_t> samples, all;  // at which the robot is at the point; of the whole run
  Eigen::Vector3d middle_W{0, 0, 0};      // of the point at the samples

  Eigen::Vector3d Point_W(std::size_t sample) const { return AimPlace(aim, run, shapes, sample); }
};

/// The robot's distance from the point, or of a point of the robot from the target.
double Apart_m(const Tried& tried, std::size_t sample) {
  const Eigen::Vector3d p_W = tried.Point_W(sample);
  if (!tried.carrier.robot) return tried.lines.RobotDistance_m(p_W, sample);
  return (AimPlace({"target", {}}, tried.run, tried.shapes, sample) - p_W).norm();
}

void FindSamples(std::size_t first, std::size_t last, Tried& tried) {
  std::vector<double> apart_m;
  for (std::size_t i = first; i <= last; ++i) {
    tried.all.push_back(i);
    apart_m.push_back(Apart_m(tried, i));
  }
  const double near_m = *std::min_element(apart_m.begin(), apart_m.end()) + kAtPoint_m;
  for (std::size_t i = first; i <= last; ++i) {
    if (apart_m[i - first] <= near_m) tried.samples.push_back(i);
  }
  tried.samples = Thinned(tried.samples, kSamples);
  tried.all = Thinned(tried.all, kSamplesOfAll);
  for (const std::size_t i : tried.samples) tried.middle_W += tried.Point_W(i);
  tried.middle_W /= static_cast<double>(tried.samples.size());
}

/// The nearest place in that direction from the middle that is as far as it has to be from the
/// point at all samples.
Eigen::Vector3d PlaceAlong(const Eigen::Vector3d& out, const Tried& tried) {
  double along_m = tried.distance_m;
  for (const std::size_t i : tried.samples) {
    const Eigen::Vector3d off = tried.Point_W(i) - tried.middle_W;
    const double ahead_m = off.dot(out), aside2 = off.squaredNorm() - ahead_m * ahead_m;
    const double rest2 = tried.distance_m * tried.distance_m - aside2;
    if (rest2 > 0.0) along_m = std::max(along_m, ahead_m + std::sqrt(rest2));
  }
  return tried.middle_W + along_m * out;
}

/// Share of the image's middle that nothing hides from there.
double FreeShare(const Eigen::Vector3d& from_W, std::size_t sample, const Tried& tried) {
  const Eigen::Vector3d point_W = tried.Point_W(sample);
  const Pose3 X_WC = PoseAimedAt(from_W, point_W);
  const Eigen::Vector3d z_W = X_WC.R.col(2);
  const auto own = [&](const StageBody& body) { return body.name == tried.carrier.body; };
  const auto others = [&](const StageBody& body) { return !own(body); };
  const double before_m = kOwnShare * tried.radius_m;
  double free = 0.0;
  if (!tried.lines.Blocked(from_W, point_W - before_m * z_W, sample, others) &&
      (tried.carrier.robot || !tried.lines.Blocked(from_W, point_W - kSkin_m * z_W, sample, own))) {
    free += 0.5;
  }
  for (int i = 0; i < kRing; ++i) {
    const double turn_rad = 2.0 * kPi * i / kRing;
    const Eigen::Vector3d end_W =
        point_W - before_m * z_W +
        kRingShare * tried.radius_m *
            (std::cos(turn_rad) * X_WC.R.col(0) + std::sin(turn_rad) * X_WC.R.col(1));
    if (!tried.lines.Blocked(from_W, end_W, sample, others)) free += 0.5 / kRing;
  }
  return free;
}

double WorthOf(const Eigen::Vector3d& from_W, const Tried& tried) {
  double free = 0.0;
  for (const std::size_t i : tried.samples) free += FreeShare(from_W, i, tried);
  free /= static_cast<double>(tried.samples.size());
  const bool entered = std::any_of(tried.all.begin(), tried.all.end(), [&](std::size_t sample) {
    return tried.lines.RobotDistance_m(from_W, sample) < kClear_m;
  });
  return entered ? free - 1.0 : free;
}

double RadiusOf(const Carrier& carrier, const Aim& aim, const SightLines& lines) {
  if (carrier.body.empty()) return kLargestRadius_m;
  const double reach_m = lines.Reach_m(carrier.body);
  if (aim.name == "robot") return std::max(kLargestRadius_m, reach_m);
  return std::clamp(kAroundBody * reach_m, kLeastRadius_m, kLargestRadius_m);
}

}  // namespace

NearView FindNearView(const LoggedRun& run, const StageShapes& shapes, const Aim& aim,
                      std::size_t first, std::size_t last, double vertical_fov_rad) {
  const SightLines lines(run, shapes);
  Tried tried{.run = run,
              .shapes = shapes,
              .aim = aim,
              .lines = lines,
              .carrier = CarrierOf(aim, shapes),
              .samples = {},
              .all = {}};
  tried.radius_m = RadiusOf(tried.carrier, aim, lines);
  tried.distance_m = tried.radius_m / std::sin(0.5 * vertical_fov_rad);
  FindSamples(first, last, tried);
  const double heading_rad = ToGround(run.X_WD[first]).heading;
  const Eigen::Vector3d usual_W = UsualDirection(heading_rad, shapes.light.to_sun_W);
  NearView best{.from_W = tried.middle_W, .at_W = tried.middle_W, .radius_m = tried.radius_m};
  double most = -std::numeric_limits<double>::infinity();
  for (const double height_rad : kHeights_rad) {
    for (int i = 0; i < kAzimuths; ++i) {
      // Over the site, which may be tilted.
      const Eigen::Vector3d out =
          run.X_WG[first].R * Direction(2.0 * kPi * i / kAzimuths, height_rad);
      const Eigen::Vector3d from_W = PlaceAlong(out, tried);
      const double worth = WorthOf(from_W, tried) + kUsual * out.dot(usual_W);
      if (worth <= most) continue;
      most = worth;
      best.from_W = from_W;
    }
  }
  return best;
}

}  // namespace dockyard
