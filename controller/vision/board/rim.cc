#include "controller/vision/board/rim.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/median.h"
#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

constexpr double kSampleStep = 0.5;  // [px]
constexpr double kReach = 1.5;       // [px] half the base of a difference: two sigmas of the blur
constexpr double kDarkOffset = 6.0;  // [DN] keeps ratios from amplifying noise in the dark
constexpr double kMinInlierShare = 0.5;

/// Bilinear; outside the image the border pixel.
double Sample(const GrayImage& image, const Eigen::Vector2d& at) {
  const double x = std::clamp(at.x(), 0.0, image.width - 1.001);
  const double y = std::clamp(at.y(), 0.0, image.height - 1.001);
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const double fx = x - ix, fy = y - iy;
  const std::uint8_t* top = &image.pixels[static_cast<std::size_t>(iy) * image.width + ix];
  const std::uint8_t* bottom = top + image.width;
  return (1.0 - fy) * ((1.0 - fx) * top[0] + fx * top[1]) +
         fy * ((1.0 - fx) * bottom[0] + fx * bottom[1]);
}

/// The vertex of the parabola through three equally spaced values, in steps from the middle one.
double Vertex(double before, double at, double after) {
  const double bend = before - 2.0 * at + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

/// The dark-to-bright step along one ray. Chosen by the steepest relative rise, in which a shadow's
/// edge on white is weaker than a mark's edge in shadow; placed by the steepest rise of the grey
/// itself, which blur does not shift.
std::optional<Eigen::Vector2d> FindEdge(const GrayImage& image, const Eigen::Vector2d& from,
                                        const Eigen::Vector2d& to, std::vector<double>& grays) {
  const double length = (to - from).norm();
  const int reach = static_cast<int>(kReach / kSampleStep);
  const int count = static_cast<int>(length / kSampleStep) + 1;
  if (count < 2 * reach + 3) return std::nullopt;
  const Eigen::Vector2d step = (to - from) * (kSampleStep / length);
  grays.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    grays[static_cast<std::size_t>(i)] = Sample(image, from + i * step);
  const auto rise = [&](int i) {
    return grays[static_cast<std::size_t>(i + reach)] - grays[static_cast<std::size_t>(i - reach)];
  };
  int steepest = -1;
  double best = 1.16;  // the light must grow by 16 % at least
  for (int i = reach; i < count - reach; ++i) {
    const double growth = (grays[static_cast<std::size_t>(i + reach)] + kDarkOffset) /
                          (grays[static_cast<std::size_t>(i - reach)] + kDarkOffset);
    if (growth > best) {
      best = growth;
      steepest = i;
    }
  }
  if (steepest < 0) return std::nullopt;
  int at = steepest;
  while (at + 1 < count - reach && rise(at + 1) > rise(at)) ++at;
  while (at - 1 >= reach && rise(at - 1) > rise(at)) --at;
  double shift = 0.0;
  if (at > reach && at + 1 < count - reach) shift = Vertex(rise(at - 1), rise(at), rise(at + 1));
  return Eigen::Vector2d(from + (at + shift) * step);
}

std::vector<Eigen::Vector2d> FindEdges(const GrayImage& image, const Ellipse& about, double inner,
                                       double outer, int rays) {
  std::vector<Eigen::Vector2d> edges;
  std::vector<double> grays;
  for (int i = 0; i < rays; ++i) {
    const double angle = 2.0 * kPi * i / rays;
    const Eigen::Vector2d out = about.shape_px * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    // At least 2 px on either side, or a small disc's blurred edge does not fit in.
    const double least = 2.2 / out.norm();
    const double begin = std::max(std::min(inner, 1.0 - least), 0.25);
    const double end = std::max(outer, 1.0 + least);
    const auto edge =
        FindEdge(image, about.centre_px + begin * out, about.centre_px + end * out, grays);
    if (edge) edges.push_back(*edge);
  }
  return edges;
}

/// Distances of points from the rim, to first order [px].
std::vector<double> RimDistances(const Ellipse& ellipse,
                                 const std::vector<Eigen::Vector2d>& points) {
  const Eigen::Matrix2d inverse = ellipse.shape_px.inverse();
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d n = inverse * (p - ellipse.centre_px);
    const double length = std::max(n.norm(), 1e-9);
    distances.push_back(std::abs(length - 1.0) / (inverse * n / length).norm());
  }
  return distances;
}

/// Fitzgibbon's fit; points beyond 2.5 robust sigmas are left out until none is, three times at
/// most.
std::optional<RimFit> FitRobust(const std::vector<Eigen::Vector2d>& all, int rays) {
  std::optional<Ellipse> ellipse = FitEllipse(all);
  std::size_t used = all.size();
  double rms = 0.0;
  for (int round = 0; round < 3 && ellipse; ++round) {
    const std::vector<double> distances = RimDistances(*ellipse, all);
    const double limit = std::max(0.3, 2.5 * 1.4826 * Median(distances));
    std::vector<Eigen::Vector2d> near;
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (distances[i] > limit) continue;
      near.push_back(all[i]);
      sum += distances[i] * distances[i];
    }
    rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(near.size(), 1)));
    used = near.size();
    if (round == 0 && used == all.size()) break;  // nothing left out
    ellipse = FitEllipse(near);
  }
  if (!ellipse) return std::nullopt;
  return RimFit{
      .ellipse = *ellipse, .inlier_share = static_cast<double>(used) / rays, .rms_px = rms};
}

}  // namespace

std::optional<RimFit> RefineRim(const GrayImage& image, const Ellipse& start) {
  if (image.width < 3 || image.height < 3) return std::nullopt;
  const int rays = std::clamp(static_cast<int>(4.0 * start.mean_radius_px()), 24, 64);
  std::optional<RimFit> fit = FitRobust(FindEdges(image, start, 0.6, 1.45, rays), rays);
  if (!fit) return std::nullopt;
  const double growth = fit->ellipse.mean_radius_px() / start.mean_radius_px();
  if (!(growth > 0.6 && growth < 1.6)) return std::nullopt;
  fit = FitRobust(FindEdges(image, fit->ellipse, 0.75, 1.25, rays), rays);
  if (!fit || fit->inlier_share < kMinInlierShare) return std::nullopt;
  const double radius = fit->ellipse.mean_radius_px();
  if (fit->rms_px > std::max(0.5, 0.05 * radius)) return std::nullopt;
  return fit;
}

}  // namespace dockyard
