#include "controller/stereo/ground_motion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace dockyard {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
// A peak at the border of what was tried may be none.
constexpr int kBorder_cells = 1;
constexpr int kRounds = 5;

float Bilinear(const GrayImage& image, double u, double v) {
  if (!(u >= 0.0 && v >= 0.0 && u < image.width - 1.0 && v < image.height - 1.0)) return kUnknown;
  const int u0 = static_cast<int>(u), v0 = static_cast<int>(v);
  const double a = u - u0, b = v - v0;
  return static_cast<float>((1 - b) * ((1 - a) * image.at(u0, v0) + a * image.at(u0 + 1, v0)) +
                            b * ((1 - a) * image.at(u0, v0 + 1) + a * image.at(u0 + 1, v0 + 1)));
}

// CV_32F greys with 0 where nothing is known, and CV_8U with 1 where something is.
struct Known {
  cv::Mat grey, is_known;
};

// `before` as the later grid would show it.
Known Moved(const GroundImage& before, const GroundImage& now, const Pose2& X_NB) {
  const cv::Mat from(before.ny, before.nx, CV_32F, const_cast<float*>(before.grey.data()));
  cv::Mat map_x(now.ny, now.nx, CV_32F), map_y(now.ny, now.nx, CV_32F);
  const Pose2 X_BN = Inverse(X_NB);
  for (int iy = 0; iy < now.ny; ++iy) {
    for (int ix = 0; ix < now.nx; ++ix) {
      const Vector2d p_B = X_BN * Vector2d(now.x0_m + ix * now.cell_m, now.y0_m + iy * now.cell_m);
      map_x.at<float>(iy, ix) = static_cast<float>((p_B.x() - before.x0_m) / before.cell_m);
      map_y.at<float>(iy, ix) = static_cast<float>((p_B.y() - before.y0_m) / before.cell_m);
    }
  }
  cv::Mat moved;
  cv::remap(from, moved, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(kUnknown));
  Known known{moved, moved == moved};
  moved.setTo(0.0F, ~known.is_known);
  known.is_known = known.is_known / 255;
  return known;
}

Known Split(const GroundImage& picture) {
  Known known;
  known.grey =
      cv::Mat(picture.ny, picture.nx, CV_32F, const_cast<float*>(picture.grey.data())).clone();
  known.is_known = known.grey == known.grey;
  known.grey.setTo(0.0F, ~known.is_known);
  known.is_known = known.is_known / 255;
  return known;
}

// A part of the ground: where it should be in the later E, how far it is from there, and how well
// that is known.
struct Part {
  Vector2d p_N{0, 0}, off_m{0, 0};
  Matrix2d information = Matrix2d::Zero();
};

// The peak's place between cells.
double Between(double before, double at, double after) {
  const double bend = before - 2.0 * at + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

Matrix2d InformationAt(const GroundImage& now, const Vector2d& p_N,
                       const GroundMotionSettings& with) {
  const Vector2d away = p_N - now.p_EC.head<2>();
  const double up_m = now.p_EC.z(), r = std::max(away.norm(), 1e-3);
  const Vector2d along = away / r;
  const double px = with.sigma_px / now.focal_px;
  const double a =
      std::hypot(px * (r * r + up_m * up_m) / up_m, with.sigma_up_m * r * r * r / up_m);
  const double b = px * std::hypot(r, up_m);
  // The grid tells a place to a part of its cells.
  const double grid_m2 = now.cell_m * now.cell_m / 36.0;
  return along * along.transpose() / (a * a + grid_m2) +
         (Matrix2d::Identity() - along * along.transpose()) / (b * b + grid_m2);
}

// All of a window's unknown cells count as its middle grey.
cv::Mat Filled(const Known& all, const cv::Rect& where) {
  cv::Mat out = all.grey(where).clone();
  const cv::Mat is_known = all.is_known(where);
  out.setTo(cv::mean(out, is_known), is_known == 0);
  return out;
}

std::optional<Part> FindPart(const Known& before, const Known& now_all, const GroundImage& now,
                             const cv::Point& middle, int half, int search,
                             const GroundMotionSettings& with) {
  const cv::Rect part(middle.x - half, middle.y - half, 2 * half + 1, 2 * half + 1);
  const cv::Rect window(part.x - search, part.y - search, part.width + 2 * search,
                        part.height + 2 * search);
  if ((window & cv::Rect(0, 0, now.nx, now.ny)) != window) return std::nullopt;
  if (cv::mean(before.is_known(part))[0] < with.least_known ||
      cv::mean(now_all.is_known(window))[0] < with.least_known) {
    return std::nullopt;
  }
  const cv::Mat greys = Filled(before, part), about = Filled(now_all, window);
  cv::Scalar mean, sigma;
  cv::meanStdDev(greys, mean, sigma);
  if (sigma[0] < with.least_contrast) return std::nullopt;
  cv::Mat scores;
  cv::matchTemplate(about, greys, scores, cv::TM_CCOEFF_NORMED);
  cv::Point at;
  double score = 0.0;
  cv::minMaxLoc(scores, nullptr, &score, nullptr, &at);
  if (score < with.least_score || at.x < kBorder_cells || at.y < kBorder_cells ||
      at.x >= scores.cols - kBorder_cells || at.y >= scores.rows - kBorder_cells) {
    return std::nullopt;
  }
  const auto score_at = [&](int dx, int dy) {
    return static_cast<double>(scores.at<float>(at.y + dy, at.x + dx));
  };
  Part found;
  found.p_N = {now.x0_m + middle.x * now.cell_m, now.y0_m + middle.y * now.cell_m};
  found.off_m = now.cell_m *
                Vector2d(at.x - search + Between(score_at(-1, 0), score_at(0, 0), score_at(1, 0)),
                         at.y - search + Between(score_at(0, -1), score_at(0, 0), score_at(0, 1)));
  found.information = InformationAt(now, found.p_N, with);
  return found;
}

// A correction of the predicted motion: a shift, then a small turn about E's origin.
struct Correction {
  Vector3d shift_turn = Vector3d::Zero();
  Matrix3d spread = Matrix3d::Zero();
};

Vector2d Expected(const Correction& correction, const Vector2d& p_N) {
  const double turn = correction.shift_turn.z();
  return correction.shift_turn.head<2>() + turn * Vector2d(-p_N.y(), p_N.x());
}

bool Agrees(const Part& part, const Correction& correction, double sigmas) {
  const Vector2d left_m = part.off_m - Expected(correction, part.p_N);
  return left_m.dot(part.information * left_m) < sigmas * sigmas;
}

int CountAgreeing(const std::vector<Part>& parts, const Correction& correction, double sigmas) {
  return static_cast<int>(std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
    return Agrees(part, correction, sigmas);
  }));
}

// Least squares over those that agree, the turn held near odometry's.
Correction Fit(const std::vector<Part>& parts, const Correction& about, double yaw_sigma_rad,
               double sigmas) {
  Matrix3d information = Matrix3d::Zero();
  information(2, 2) = 1.0 / (yaw_sigma_rad * yaw_sigma_rad);
  Vector3d sum = Vector3d::Zero();
  for (const Part& part : parts) {
    if (!Agrees(part, about, sigmas)) continue;
    Eigen::Matrix<double, 2, 3> by;
    by << 1.0, 0.0, -part.p_N.y(), 0.0, 1.0, part.p_N.x();
    information += by.transpose() * part.information * by;
    sum += by.transpose() * part.information * part.off_m;
  }
  const Matrix3d spread = information.inverse();
  return {spread * sum, spread};
}

}  // namespace

GroundImage FromAbove(const RectifiedPair& pair, const GrayImage& left, const ElevationMap& heights,
                      double highest_m) {
  GroundImage out{.x0_m = heights.x0_m,
                  .y0_m = heights.y0_m,
                  .cell_m = heights.cell_m,
                  .nx = heights.nx,
                  .ny = heights.ny,
                  .focal_px = pair.focal_px};
  const Pose3 X_CE = Inverse(pair.X_RC) * heights.X_RE;
  out.p_EC = Inverse(X_CE).p;
  out.grey.assign(heights.height_m.size(), kUnknown);
  for (int iy = 0; iy < out.ny; ++iy) {
    for (int ix = 0; ix < out.nx; ++ix) {
      const auto cell = static_cast<std::size_t>(iy) * static_cast<std::size_t>(out.nx) +
                        static_cast<std::size_t>(ix);
      const double up_m = heights.height_m[cell];
      if (!(std::abs(up_m) < highest_m)) continue;
      const Vector3d p_C =
          X_CE * Vector3d(out.x0_m + ix * out.cell_m, out.y0_m + iy * out.cell_m, up_m);
      if (p_C.z() <= 0.0) continue;
      const Vector2d pixel = pair.centre_px + pair.focal_px * p_C.head<2>() / p_C.z();
      out.grey[cell] = Bilinear(left, pixel.x(), pixel.y());
    }
  }
  return out;
}

GroundMotion MotionBetween(const GroundImage& before, const GroundImage& now, const Pose2& X_NB,
                           double yaw_sigma_rad, const GroundMotionSettings& settings) {
  const Known then = Moved(before, now, X_NB), there = Split(now);
  const auto cells = [&](double length_m) {
    return std::max(1, static_cast<int>(std::lround(length_m / now.cell_m)));
  };
  const int half = cells(settings.half_m), search = cells(settings.most_off_m);
  std::vector<Part> parts;
  for (int y = half; y < now.ny; y += cells(settings.apart_m)) {
    for (int x = half; x < now.nx; x += cells(settings.apart_m)) {
      const auto part = FindPart(then, there, now, {x, y}, half, search, settings);
      if (part) parts.push_back(*part);
    }
  }
  GroundMotion out{.X_NB = X_NB, .parts = static_cast<int>(parts.size())};
  // One part after another is believed; the one that most others agree with is right. From one
  // part the turn is not known: the others may differ by what the heading may be off.
  Correction best;
  for (const Part& part : parts) {
    const Correction one{{part.off_m.x(), part.off_m.y(), 0.0}};
    const int agreeing = CountAgreeing(parts, one, 2.0 * settings.agrees);
    if (agreeing <= out.agreeing) continue;
    out.agreeing = agreeing;
    best = one;
  }
  for (int round = 0; round < kRounds && out.agreeing > 0; ++round) {
    best = Fit(parts, best, yaw_sigma_rad, (round == 0 ? 2.0 : 1.0) * settings.agrees);
  }
  out.agreeing = CountAgreeing(parts, best, settings.agrees);
  out.found = out.agreeing >= settings.least_parts &&
              out.agreeing >= settings.least_share * static_cast<double>(parts.size());
  const Pose2 correction{best.shift_turn.x(), best.shift_turn.y(), best.shift_turn.z()};
  out.X_NB = correction * X_NB;
  out.spread_m2 = best.spread.topLeftCorner<2, 2>() +
                  settings.common_m * settings.common_m * Matrix2d::Identity();
  return out;
}

}  // namespace dockyard
