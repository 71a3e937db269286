#include "controller/base/median.h"
#include "controller/vision/board/fiducials.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "controller/vision/board/bar.h"
#include "controller/vision/board/blobs.h"
#include "controller/vision/board/disc_fit.h"
#include "controller/vision/board/guided.h"
#include "controller/vision/board/rim.h"

namespace dockyard {
namespace {

// Tuned on synthetic views, range 1-6 m, three kinds of light (assumed, +-0.1).
constexpr double kMinInner = 0.55;
// A disc under 10 px across hardly shows its bar; its surround must then match better.
constexpr double kSmallRadius = 5.0, kMinInnerSmall = 0.25, kMinWholeSmall = 0.78;
constexpr double kMinWhole = 0.70;
constexpr double kMinContrast = 0.25;
// A disc without a bar is recognised by its rim alone, so it must match better.
constexpr double kMinWholePlain = 0.85;
// Blur of a flat image, 1 sigma [px]: lens and pixel 0.67, smoothing 0.7; coarser levels see less
// of the lens.
constexpr double kFineBlur = 0.97, kCoarseBlur = 0.80;

// White starts at this multiple of the threshold that separated it from black (assumed, 1.4-2).
constexpr double kWhiteOverThreshold = 1.6;

// Errors of centres on rendered pairs, one axis [px] (docs/results/perception.md). From the grey
// levels: their noise [DN], and the error that blur and print leave in the pattern. From the rim
// alone: under a shadow's edge.
constexpr double kGreyNoise = 2.0;  // assumed, 1-3
constexpr double kPatternSigma = 0.006, kPatternSigmaRadius = 0.05;
constexpr double kRimSigma = 0.12;

// Bounds on the time for images of noise and of patterns. The finest level of a rendered image 1024
// px wide has 50 blobs, of 12 megapixels of noise 1700; a board has at most 100 discs.
constexpr std::size_t kMostBlobs = 20000, kMostFound = 400;

static_assert(kBarAngles == std::tuple_size_v<decltype(DetectedFiducial::bar_match)>);

Ellipse ToLevel(const Ellipse& rim, const BlobLevel& level) {
  return {.centre_px = level.FromImage(rim.centre_px), .shape_px = rim.shape_px / level.scale()};
}
Ellipse ToImage(const Ellipse& rim, const BlobLevel& level) {
  return {.centre_px = level.ToImage(rim.centre_px), .shape_px = rim.shape_px * level.scale()};
}

std::optional<DetectedFiducial> Verify(const GrayImage& image, const BlobLevel& level,
                                       const Blob& blob, const FiducialBoard& board) {
  const std::optional<RimFit> rim = RefineRim(image, ToImage(blob.moments, level));
  if (!rim) return std::nullopt;
  const auto bar = MatchBar(level.flat, ToLevel(rim->ellipse, level), board,
                            level.level == 0 ? kFineBlur : kCoarseBlur,
                            std::min(1.0, kWhiteOverThreshold * blob.threshold));
  if (!bar || bar->contrast < kMinContrast) return std::nullopt;
  if (!board.HasBars()) {
    if (bar->whole < kMinWholePlain) return std::nullopt;
    return DetectedFiducial{
        .rim = rim->ellipse, .match = bar->whole, .bar_match = bar->inner, .clear = true};
  }
  const double inner = *std::max_element(bar->inner.begin(), bar->inner.end());
  const bool matches = inner >= kMinInner && bar->whole >= kMinWhole;
  const bool small_matches = rim->ellipse.mean_radius_px() < kSmallRadius &&
                             inner >= kMinInnerSmall && bar->whole >= kMinWholeSmall;
  if (!matches && !small_matches) return std::nullopt;
  return DetectedFiducial{
      .rim = rim->ellipse, .match = bar->whole, .bar_match = bar->inner, .clear = matches};
}

/// Whether a disc has been found about this place: at another threshold, on a finer level.
bool IsKnown(const std::vector<DetectedFiducial>& found, const Eigen::Vector2d& pixel) {
  return std::any_of(found.begin(), found.end(), [&](const DetectedFiducial& other) {
    return other.rim.ToDisc(pixel).norm() < 0.7;
  });
}

/// Small unclear discs are marks when the board is far, and stones when it is near. With three
/// clear marks or more, an unclear disc under half their median size is dropped.
void DropStones(std::vector<DetectedFiducial>& found) {
  std::vector<double> radii;
  for (const DetectedFiducial& fiducial : found) {
    if (fiducial.clear) radii.push_back(fiducial.rim.mean_radius_px());
  }
  if (radii.size() < 3) return;
  const double median = Median(std::move(radii));
  std::erase_if(found, [&](const DetectedFiducial& fiducial) {
    return !fiducial.clear && fiducial.rim.mean_radius_px() < 0.5 * median;
  });
}

/// Correlation with the bar at an angle between the tabulated ones.
double BarMatchAt(const DetectedFiducial& fiducial, double angle_rad) {
  const double at = angle_rad / kPi * kBarAngles;
  const double floor = std::floor(at);
  const auto index = [](double i) {
    const int wrapped = static_cast<int>(i) % kBarAngles;
    return static_cast<std::size_t>(wrapped < 0 ? wrapped + kBarAngles : wrapped);
  };
  const double share = at - floor;
  return (1.0 - share) * fiducial.bar_match[index(floor)] +
         share * fiducial.bar_match[index(floor + 1.0)];
}

/// Direction of the plumb line's image at a pixel, upwards, unit.
std::optional<Eigen::Vector2d> UpInImage(const Camera& camera, const Eigen::Vector3d& up_C,
                                         const Eigen::Vector2d& pixel) {
  const LensRay ray = camera.Ray(pixel);
  const auto above = camera.Project(ray.origin + ray.direction + 1e-3 * up_C);
  if (!above || (*above - pixel).norm() < 1e-6) return std::nullopt;
  return (*above - pixel).normalized();
}

}  // namespace

int RotationClass(double rotation_rad) {
  const long quarter = std::lround(rotation_rad / (kPi / 4.0));
  return static_cast<int>(((quarter % 4) + 4) % 4);
}

std::vector<DetectedFiducial> DetectFiducials(const GrayImage& image, const FiducialBoard& board) {
  return DetectFiducials(image, BuildLevels(image), board);
}

std::vector<DetectedFiducial> DetectFiducials(const GrayImage& image,
                                              const std::vector<BlobLevel>& levels,
                                              const FiducialBoard& board) {
  std::vector<DetectedFiducial> found;
  for (const BlobLevel& level : levels) {
    std::vector<Blob> blobs = FindBlobs(level);
    if (blobs.size() > kMostBlobs) blobs.resize(kMostBlobs);
    const std::size_t before = found.size();
    for (const Blob& blob : blobs) {
      if (found.size() - before >= kMostFound) break;
      if (IsKnown(found, level.ToImage(blob.moments.centre_px))) continue;
      const auto fiducial = Verify(image, level, blob, board);
      if (fiducial) found.push_back(*fiducial);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.match > b.match; });
  std::vector<DetectedFiducial> distinct;  // several outlines may have led to one disc
  for (const DetectedFiducial& fiducial : found) {
    if (distinct.size() == kMostFound) break;  // the best come first
    if (!IsKnown(distinct, fiducial.rim.centre_px)) distinct.push_back(fiducial);
  }
  DropStones(distinct);
  for (DetectedFiducial& fiducial : distinct) SettleCentre(image, board, &fiducial);
  return distinct;
}

void SettleCentre(const GrayImage& image, const FiducialBoard& board, DetectedFiducial* fiducial) {
  const auto best = std::max_element(fiducial->bar_match.begin(), fiducial->bar_match.end());
  const double bar_rad = kPi / kBarAngles * static_cast<double>(best - fiducial->bar_match.begin());
  const auto fit = FitDisc(image, fiducial->rim, bar_rad, board);
  if (!fit) {
    fiducial->sigma_px = kRimSigma;
    return;
  }
  const double pattern = kPatternSigma + kPatternSigmaRadius / fiducial->rim.mean_radius_px();
  fiducial->rim.centre_px = fit->centre_px;
  fiducial->sigma_px = std::hypot(kGreyNoise * fit->sigma_px, pattern);
}

void AssignRotations(std::vector<DetectedFiducial>& fiducials, const Camera& camera,
                     const Eigen::Vector3d& up_C) {
  for (DetectedFiducial& fiducial : fiducials) {
    const Ellipse& rim = fiducial.rim;
    const Eigen::Vector2d up =
        UpInImage(camera, up_C, rim.centre_px).value_or(Eigen::Vector2d(0.0, -1.0));
    const Eigen::Vector2d up_disc = rim.shape_px.inverse() * up;
    const double lean = std::atan2(-up_disc.y(), up_disc.x()) - kPi / 2.0;
    std::array<double, 4> scores;
    for (int c = 0; c < 4; ++c) {
      scores[static_cast<std::size_t>(c)] = BarMatchAt(fiducial, c * kPi / 4.0 + lean);
    }
    const auto best = std::max_element(scores.begin(), scores.end());
    fiducial.rotation_class = static_cast<int>(best - scores.begin());
    const double top = *best;
    *best = -2.0;
    fiducial.rotation_margin = top - *std::max_element(scores.begin(), scores.end());
  }
}

}  // namespace dockyard
