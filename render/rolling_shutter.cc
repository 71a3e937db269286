#include "render/rolling_shutter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr double kRowsPart_px = 1.0;  // a row is moved by half of it at most
constexpr double kMostRowParts = 16;

// A third of the error of a match; assumed, 0.05-0.2 px, as for interlaced video.
constexpr double kSameRows_px = 0.1;

void CopyRows(const RadianceImage& from, int first, int end, RadianceImage& to) {
  const auto copy = [&](const std::vector<float>& source, std::vector<float>& target) {
    DOCKYARD_CHECK(source.size() == target.size());
    const std::ptrdiff_t width = from.width;
    std::copy(source.begin() + first * width, source.begin() + end * width,
              target.begin() + first * width);
  };
  copy(from.values, to.values);
  copy(from.inverse_depth, to.inverse_depth);
}

/// Of cameras at X_BC on a body that moves so.
template <std::size_t kCount, typename View>
std::array<RadianceImage, kCount> RowByRow(double motion_px,
                                           const std::array<const Camera*, kCount>& cameras,
                                           const std::array<Pose3, kCount>& X_BC,
                                           const ExposureMotion& body, const View& view) {
  if (!RowsDiffer(motion_px)) return view(0.0);
  const int parts = static_cast<int>(std::min(std::ceil(motion_px / kRowsPart_px), kMostRowParts));
  std::array<RadianceImage, kCount> rows;
  for (int i = 0; i < parts; ++i) {
    const double middle = (i + 0.5) / parts - 0.5;
    std::array<RadianceImage, kCount> part = view(middle);
    for (std::size_t k = 0; k < kCount; ++k) {
      const int height = part[k].height;
      const RowRange range{i * height / parts, (i + 1) * height / parts};
      MoveRows(*cameras[k], MotionOfCamera(body, X_BC[k]), range, middle, part[k]);
      if (i == 0) {
        rows[k] = std::move(part[k]);
      } else {
        CopyRows(part[k], range.first, range.end, rows[k]);
      }
    }
  }
  return rows;
}

}  // namespace

bool RowsDiffer(double motion_px) {
  DOCKYARD_CHECK(std::isfinite(motion_px) && motion_px >= 0.0);
  return motion_px >= kSameRows_px;
}

StereoRadiance OverReadout(double motion_px, const StereoRig& rig, const ExposureMotion& motion,
                           const PairInReadout& view) {
  return RowByRow<2>(motion_px, {&rig.left, &rig.right}, {rig.X_RL, rig.X_RQ}, motion, view);
}

RadianceImage OverReadout(double motion_px, const Camera& camera, const ExposureMotion& motion,
                          const OneInReadout& view) {
  return std::move(
      RowByRow<1>(motion_px, {&camera}, {Pose3{}}, motion,
                  [&](double share) -> std::array<RadianceImage, 1> { return {view(share)}; })[0]);
}

}  // namespace dockyard
