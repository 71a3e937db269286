#include "render/lens_ripple.h"

#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Of the places at which a ripple is measured: 32 across its finest period.
constexpr int kColumns = 128, kRows = 96;

double RmsOf(const LensRipple& ripple, int width, int height) {
  double sum = 0.0;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const double u = (i % kColumns + 0.5) / kColumns, v = (i / kColumns + 0.5) / kRows;
    sum += ripple.At({u * width - 0.5, v * height - 0.5}).squaredNorm();
  }
  return std::sqrt(sum / (kColumns * kRows));
}

}  // namespace

Eigen::Vector2d LensRipple::At(const Eigen::Vector2d& pixel) const {
  if (none()) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d x = (pixel - middle_px) / half_diagonal_px;
  Eigen::Vector2d shift =
      ring_px * std::cos(2.0 * kPi * ring_turns * x.squaredNorm() + ring_phase_rad) * x;
  for (const Wave& wave : waves) {
    shift += std::cos(2.0 * kPi * wave.turns.dot(x) + wave.phase_rad) * wave.shift_px;
  }
  return shift;
}

LensRipple ScaledTo(LensRipple ripple, int width, int height, double rms_px) {
  DOCKYARD_CHECK(width > 0 && height > 0 && rms_px >= 0.0);
  ripple.middle_px = {0.5 * (width - 1), 0.5 * (height - 1)};
  ripple.half_diagonal_px = 0.5 * std::hypot(width, height);
  LensRipple ring = ripple, waves = ripple;
  ring.waves = {};
  waves.ring_px = 0.0;
  const auto scale = [&](double of_ring, double of_waves) {
    ripple.ring_px *= of_ring;
    for (LensRipple::Wave& wave : ripple.waves) wave.shift_px *= of_waves;
  };
  const double ring_rms = RmsOf(ring, width, height), waves_rms = RmsOf(waves, width, height);
  DOCKYARD_CHECK(ring_rms > 0.0 && waves_rms > 0.0);
  scale(1.0 / ring_rms, 1.0 / waves_rms);
  const double all = rms_px / RmsOf(ripple, width, height);
  scale(all, all);
  return ripple;
}

LensRay RayWith(const LensRipple& ripple, const Camera& camera, const Eigen::Vector2d& pixel) {
  return camera.Ray(pixel - ripple.At(pixel));
}

std::optional<Eigen::Vector2d> ProjectWith(const LensRipple& ripple, const Camera& camera,
                                           const Eigen::Vector3d& p_C) {
  const std::optional<Eigen::Vector2d> model = camera.Project(p_C);
  if (!model || ripple.none()) return model;
  constexpr int kMostSteps = 40;
  Eigen::Vector2d pixel = *model;
  for (int i = 0; i < kMostSteps; ++i) {
    const Eigen::Vector2d next = *model + ripple.At(pixel);
    const double step_px = (next - pixel).norm();
    pixel = next;
    if (step_px < 1e-10) break;
  }
  return pixel;
}

}  // namespace dockyard
