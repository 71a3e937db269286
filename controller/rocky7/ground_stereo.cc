#include "controller/rocky7/ground_stereo.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "controller/base/median.h"
#include "controller/stereo/fill_gaps.h"
#include "controller/stereo/ground_plane.h"
#include "controller/stereo/sand_and_stones.h"

namespace dockyard::rocky7 {
namespace {

// Half the side of a map: the largest window, and the shape in it. Assumed, 0.2-0.5 m.
constexpr double kHalf_m = 0.3;
// Cells of a map: 5 mm near by (assumed, 2.5-10 mm), and this share of a pixel's footprint along
// the ground (assumed, 0.5-1).
constexpr double kFinest_m = 0.005, kOfFootprint = 0.7;
// Range data about a pixel: those within this of it. Assumed, 1-4 px.
constexpr int kAbout_px = 2;
// Of a user's click on a stone's middle, 1 sigma along each side. Assumed, 1-4.
constexpr double kClick_px = 2.0;
// Cells without a pixel of their own, in a row. Assumed, 2-5.
constexpr int kGap_cells = 3;
// Of the ground ahead of the cameras so much tells the rover's motion; further away a pixel shows
// more than a cell. Assumed, 0.7-1.2 m and 0.4-0.7 m.
constexpr double kAhead_m = 0.95, kAside_m = 0.5;
// The plane of the ground where users click: from the rover's front to so far away and aside.
// Assumed, 2-3 m and 0.6-1 m. Cells (assumed, 2-5 cm), and their least number (assumed, 100-500).
constexpr double kPlaneFrom_m = 0.5, kPlaneTo_m = 2.4, kPlaneAside_m = 0.8, kPlaneCell_m = 0.03;
constexpr int kLeastPlaneCells = 200;
// A click's range is wild beyond this multiple of its sigma off that plane (assumed, 2-4). Into it
// goes what the ground departs from the plane (assumed, 0.5-2 cm).
constexpr double kWildClick = 2.5, kPlane_m = 0.01;

// Level ground below R, in R.
Plane GroundIn(const Nominal& nominal, const ImuSample& attitude) {
  const Eigen::Matrix3d R_ER = RotY(attitude.pitch_rad) * RotX(attitude.roll_rad);
  return {R_ER.transpose() * Eigen::Vector3d::UnitZ(), -nominal.rolling_radius_m};
}

// By the paper's front end: the body pair's ground lies within 128 px from 0.2 m on.
constexpr MatchSettings kBlocks7{.matcher = Matcher::kBandPassed, .block_px = 7};

int BlockOf(FrontEnd front_end) {
  return front_end == FrontEnd::kBlocks7 ? kBlocks7.block_px
                                         : SandAndStonesSettings{}.stones.block_px;
}

Disparities MatchGround(const Rectifier& rectifier, const StereoImages& images,
                        const Plane& ground_R, FrontEnd front_end) {
  if (front_end == FrontEnd::kBlocks7) return Match(rectifier, images, kBlocks7);
  const PlaneDisparity ground = DisparityOf(rectifier.pair(), ground_R);
  return WithoutEdges(MatchSandAndStones(rectifier, images, ground), ground);
}

std::optional<StereoImages> PairOf(const SensorFrame& frame, int left_camera, int right_camera) {
  const GrayImage* left = GrayImageOf(frame, left_camera);
  const GrayImage* right = GrayImageOf(frame, right_camera);
  if (left == nullptr || right == nullptr) return std::nullopt;
  return StereoImages{*left, *right};
}

}  // namespace

GroundStereo::GroundStereo(const Nominal& nominal, FrontEnd front_end)
    : nominal_(nominal), front_end_(front_end), rectifier_(nominal.front) {}

GroundScan GroundStereo::Look(const StereoImages& images, const ImuSample& attitude) const {
  GroundScan scan;
  scan.ground_R = GroundIn(nominal_, attitude);
  scan.X_RE = FrameOn(scan.ground_R);
  scan.disparities = MatchGround(rectifier_, images, scan.ground_R, front_end_);
  return scan;
}

GroundMaps GroundStereo::MapsAbout(const GroundScan& scan, const Eigen::Vector2d& p_E) const {
  const RectifiedPair& pair = rectifier_.pair();
  const Eigen::Vector3d p_EC = (Inverse(scan.X_RE) * pair.X_RC).p;
  const double away_m = (p_E - p_EC.head<2>()).norm(), up_m = std::max(0.05, p_EC.z());
  const double footprint_m = (away_m * away_m + up_m * up_m) / (up_m * pair.focal_px);
  ElevationSettings settings{.cell_m = kFinest_m,
                             .x_low_m = p_E.x() - kHalf_m,
                             .x_high_m = p_E.x() + kHalf_m,
                             .y_low_m = p_E.y() - kHalf_m,
                             .y_high_m = p_E.y() + kHalf_m};
  GroundMaps maps;
  maps.p_EC = p_EC;
  maps.focal_baseline_px_m = pair.focal_px * pair.baseline_m;
  maps.fine = Heights(scan, settings);
  settings.cell_m = std::max(kFinest_m, kOfFootprint * footprint_m);
  maps.closed = Heights(scan, settings);
  FillGaps(kGap_cells, maps.closed);
  return maps;
}

ElevationMap GroundStereo::Heights(const GroundScan& scan, const ElevationSettings& window) const {
  return MapHeights(rectifier_.pair(), scan.disparities, scan.ground_R, BlockOf(front_end_),
                    window);
}

GroundImage GroundStereo::ImageAhead(const GroundScan& scan, const StereoImages& images) const {
  const RectifiedPair& pair = rectifier_.pair();
  const Eigen::Vector3d p_EC = (Inverse(scan.X_RE) * pair.X_RC).p;
  ElevationMap heights = Heights(scan, {.cell_m = kFinest_m,
                                        .x_low_m = p_EC.x(),
                                        .x_high_m = p_EC.x() + kAhead_m,
                                        .y_low_m = -kAside_m,
                                        .y_high_m = kAside_m});
  FillGaps(kGap_cells, heights);
  return FromAbove(pair, rectifier_.Rectified(images).left, heights);
}

std::optional<Eigen::Vector2d> GroundStereo::PlaceOf(const GroundScan& scan,
                                                     const Eigen::Vector2d& pixel) const {
  const RectifiedPair& pair = rectifier_.pair();
  const Eigen::Vector3d ray_C =
      pair.X_RC.R.transpose() * nominal_.front.X_RL.R * nominal_.front.left.Direction(pixel);
  if (ray_C.z() <= 0.0) return std::nullopt;
  const Eigen::Vector2d at = pair.centre_px + pair.focal_px * ray_C.head<2>() / ray_C.z();
  std::vector<double> found;
  const int u0 = static_cast<int>(std::lround(at.x())), v0 = static_cast<int>(std::lround(at.y()));
  for (int v = v0 - kAbout_px; v <= v0 + kAbout_px; ++v) {
    for (int u = u0 - kAbout_px; u <= u0 + kAbout_px; ++u) {
      if (u < 0 || v < 0 || u >= pair.width || v >= pair.height) continue;
      const double disparity_px = scan.disparities.at(u, v);
      if (std::isfinite(disparity_px) && disparity_px > 0.0) found.push_back(disparity_px);
    }
  }
  if (found.empty()) return std::nullopt;
  const Eigen::Vector3d p_C = pair.Point(at.x(), at.y(), Median(std::move(found)));
  const Eigen::Vector3d p_E = Inverse(scan.X_RE) * (pair.X_RC * p_C);
  return p_E.head<2>().eval();
}

std::optional<Clicked> GroundStereo::ClickOf(const GroundScan& scan,
                                             const Eigen::Vector2d& pixel) const {
  const auto p_E = PlaceOf(scan, pixel);
  if (!p_E) return std::nullopt;
  const Eigen::Matrix3d R_EL = scan.X_RE.R.transpose() * nominal_.front.X_RL.R;
  Clicked clicked{*p_E, R_EL * nominal_.front.left.Direction(pixel),
                  kClick_px / rectifier_.pair().focal_px};
  if (front_end_ == FrontEnd::kBlocks7) return clicked;
  const auto on_ground = OnGround(scan, clicked.ray_E);
  if (!on_ground) return clicked;
  const Eigen::Vector3d p_EC = (Inverse(scan.X_RE) * rectifier_.pair().X_RC).p;
  const double r = (*on_ground - p_EC.head<2>()).norm(), h = p_EC.z();
  const double sigma_m = std::hypot(clicked.sigma_rad * (r * r + h * h) / h, kPlane_m * r / h);
  if ((clicked.p_E - *on_ground).norm() > kWildClick * sigma_m) clicked.p_E = *on_ground;
  return clicked;
}

std::optional<Eigen::Vector2d> GroundStereo::OnGround(const GroundScan& scan,
                                                      const Eigen::Vector3d& ray_E) const {
  const ElevationMap map = Heights(scan, {.cell_m = kPlaneCell_m,
                                          .x_low_m = kPlaneFrom_m,
                                          .x_high_m = kPlaneTo_m,
                                          .y_low_m = -kPlaneAside_m,
                                          .y_high_m = kPlaneAside_m});
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < map.nx * map.ny; ++i) {
    const double height_m = map.height_m[static_cast<std::size_t>(i)];
    if (std::isnan(height_m)) continue;
    points.emplace_back(map.x0_m + map.cell_m * (i % map.nx), map.y0_m + map.cell_m * (i / map.nx),
                        height_m);
  }
  const auto plane = FitGroundPlane(points, Eigen::Vector3d::Zero(), kLeastPlaneCells);
  if (!plane) return std::nullopt;
  const Eigen::Vector3d p_EC = (Inverse(scan.X_RE) * rectifier_.pair().X_RC).p;
  const double falls = ray_E.z() - plane->tail<2>().dot(ray_E.head<2>());
  if (falls >= 0.0) return std::nullopt;
  const double over_m = p_EC.z() - plane->dot(Eigen::Vector3d(1.0, p_EC.x(), p_EC.y()));
  return (p_EC - over_m / falls * ray_E).head<2>().eval();
}

std::optional<StereoImages> FrontPair(const SensorFrame& frame) {
  return PairOf(frame, kFrontLeft, kFrontRight);
}

std::optional<StereoImages> BackPair(const SensorFrame& frame) {
  return PairOf(frame, kBackLeft, kBackRight);
}

Tick ExposureOfFront(const SensorFrame& frame) {
  for (const CameraImage& image : frame.images) {
    if (image.camera == kFrontLeft) return image.exposed;
  }
  return frame.tick;
}

}  // namespace dockyard::rocky7
