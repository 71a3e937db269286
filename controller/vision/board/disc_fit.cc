#include "controller/vision/board/disc_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

constexpr double kBlur_px = 0.7;  // lens and pixel, 1 sigma; assumed, 0.5-1.0
// Beyond the rim and inside it [px]: three sigmas of blur, and levels to compare. A wider ring
// would take in other changes of the light.
constexpr double kRing_px = 2.0, kInside_px = 4.0;
// In a disc smaller than this [px] the bar's blur reaches the rim, and both are fitted. In a larger
// one the bar is left out: its middle is the disc's printed centre, which is not the centre of the
// disc's image.
constexpr double kWithBar_px = 6.5;
constexpr double kFarthest_px = 1.0;  // no rim's centre is off by more
// Largest misfit over contrast in even light (99 % of rendered discs): without and with the bar. A
// shadow's edge across the disc leaves more, and pulls the centre.
constexpr double kMostMisfit = 0.07, kMostMisfitWithBar = 0.12;
constexpr int kIterations = 3;   // each leaves a hundredth of the shift
constexpr double kNoBar = -1e3;  // half a bar's length in rim radii, beyond any blur

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;

/// A step blurred, with its slope: a cubic with the Gaussian's slope in the middle.
struct Step {
  double value = 0.0, slope = 0.0;
  explicit Step(double distance_px) {
    const double t = std::clamp(0.5 + distance_px / (3.75 * kBlur_px), 0.0, 1.0);
    value = t * t * (3.0 - 2.0 * t);
    slope = 6.0 * t * (1.0 - t) / (3.75 * kBlur_px);
  }
};

/// The print about its centre: white is one; and its derivative by the place.
class Print {
 public:
  Print(const Ellipse& rim, double bar_rad, const FiducialBoard& board)
      : inverse_(rim.shape_px.inverse()),
        along_(std::cos(bar_rad), -std::sin(bar_rad)),
        across_(std::sin(bar_rad), std::cos(bar_rad)),
        half_length_(board.HasBars() ? board.bar_length_m / board.disc_diameter_m : kNoBar),
        half_width_(board.bar_width_m / board.disc_diameter_m) {
    to_along_ = inverse_ * along_;
    to_across_ = inverse_ * across_;
    along_slope_ = to_along_.norm();
    across_slope_ = to_across_.norm();
  }

  struct Sample {
    double value = 0.0;
    Eigen::Vector2d gradient;  // by the place, per px
    double by_size = 0.0;      // by the disc's radius, per radius
    bool bar = false;          // whether the bar's blur reaches the place
  };
  Sample At(const Eigen::Vector2d& from_centre_px, double size) const {
    const Eigen::Vector2d disc = inverse_ * from_centre_px;
    const double length = std::max(disc.norm(), 1e-6);
    const Eigen::Vector2d outwards = inverse_ * (disc / length);
    const double slope = outwards.norm();
    const Step ground((length - size) / slope);
    const double u = disc.dot(along_), v = disc.dot(across_);
    const Step end((half_length_ - std::abs(u)) / along_slope_);
    const Step side((half_width_ - std::abs(v)) / across_slope_);
    return {.value = ground.value + end.value * side.value,
            .gradient = ground.slope / slope * outwards -
                        std::copysign(end.slope * side.value / along_slope_, u) * to_along_ -
                        std::copysign(end.value * side.slope / across_slope_, v) * to_across_,
            .by_size = -ground.slope / slope,
            .bar = end.value * side.value > 0.0};
  }

 private:
  Eigen::Matrix2d inverse_;
  Eigen::Vector2d along_, across_, to_along_, to_across_;
  double half_length_, half_width_, along_slope_ = 1.0, across_slope_ = 1.0;
};

/// The pixels that take part, the same in every round.
struct Window {
  explicit Window(const Ellipse& rim)
      : centre_px(rim.centre_px),
        inverse(rim.shape_px.inverse()),
        with_bar(rim.mean_radius_px() < kWithBar_px),
        ring(1.0 + kRing_px / rim.mean_radius_px()),
        inside(with_bar ? 0.0 : std::max(1.0 - kInside_px / rim.mean_radius_px(), 0.0)),
        reach_x(ring * rim.shape_px.row(0).norm()),
        reach_y(ring * rim.shape_px.row(1).norm()),
        x0(static_cast<int>(std::ceil(rim.centre_px.x() - reach_x))),
        x1(static_cast<int>(std::floor(rim.centre_px.x() + reach_x))),
        y0(static_cast<int>(std::ceil(rim.centre_px.y() - reach_y))),
        y1(static_cast<int>(std::floor(rim.centre_px.y() + reach_y))) {}

  bool FitsInto(const GrayImage& image) const {
    return x0 >= 0 && y0 >= 0 && x1 < image.width && y1 < image.height;
  }
  bool Holds(double x, double y) const {
    const double out = (inverse * (Eigen::Vector2d(x, y) - centre_px)).squaredNorm();
    return !(out > ring * ring || out < inside * inside);
  }

  Eigen::Vector2d centre_px;
  Eigen::Matrix2d inverse;
  bool with_bar;
  double ring, inside;      // in radii of the rim
  double reach_x, reach_y;  // [px]
  int x0, x1, y0, y1;
};

/// Start values of a round.
struct Guess {
  Eigen::Vector2d centre_px;
  double size = 1.0;         // of the disc, in radii of the rim
  double black_share = 0.1;  // black over white, in the gradient alone
  double step_dn = 100.0;    // white less black; only scales the shift's columns
};

/// Least squares: A x = b. Unknowns: white, the light's gradient, black, the disc's size, shift of
/// the centre.
struct Sums {
  Matrix7 A = Matrix7::Zero();
  Vector7 b = Vector7::Zero();
  double squares = 0.0;
  int samples = 0;
};

Sums SumOver(const GrayImage& image, const Print& print, const Window& window, const Guess& guess) {
  Sums sums;
  for (int y = window.y0; y <= window.y1; ++y) {
    const std::uint8_t* row = &image.pixels[static_cast<std::size_t>(y) * image.width];
    for (int x = window.x0; x <= window.x1; ++x) {
      if (!window.Holds(x, y)) continue;
      const Eigen::Vector2d at = Eigen::Vector2d(x, y) - guess.centre_px;
      const Print::Sample seen = print.At(at, guess.size);
      if (seen.bar && !window.with_bar) continue;
      const double white = seen.value;
      Vector7 line;
      const double lit = white + guess.black_share * (1.0 - white);
      line << white, lit * at.x() / window.reach_x, lit * at.y() / window.reach_y, 1.0 - white,
          guess.step_dn * seen.by_size, -guess.step_dn * seen.gradient;
      sums.A.selfadjointView<Eigen::Lower>().rankUpdate(line);
      sums.b += row[x] * line;
      sums.squares += row[x] * row[x];
      ++sums.samples;
    }
  }
  sums.A.triangularView<Eigen::StrictlyUpper>() = sums.A.transpose();
  return sums;
}

}  // namespace

std::optional<DiscFit> FitDisc(const GrayImage& image, const Ellipse& rim, double bar_rad,
                               const FiducialBoard& board) {
  const Print print(rim, bar_rad, board);
  const Window window(rim);
  if (!window.FitsInto(image)) return std::nullopt;
  DiscFit fit{.centre_px = rim.centre_px};
  Guess guess{.centre_px = rim.centre_px};
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Sums sums = SumOver(image, print, window, guess);
    const Eigen::LLT<Matrix7> solver(sums.A);
    if (sums.samples < 20 || solver.info() != Eigen::Success) return std::nullopt;
    const Vector7 solution = solver.solve(sums.b);
    fit.contrast_dn = solution(0) - solution(3);
    const Matrix7 P = solver.solve(Matrix7::Identity());
    fit.sigma_px = std::sqrt(0.5 * (P(5, 5) + P(6, 6)));
    fit.misfit_dn =
        std::sqrt(std::max(sums.squares - sums.b.dot(solution), 0.0) / (sums.samples - 7));
    guess.centre_px += solution.tail<2>();
    guess.size += solution(4);
    fit.centre_px = guess.centre_px;
    if (!fit.centre_px.allFinite() || fit.contrast_dn < 5.0 ||
        (fit.centre_px - rim.centre_px).norm() > kFarthest_px) {
      return std::nullopt;
    }
    // The shift was found with the columns of the step before: scale it at the next round.
    if (iteration + 1 == kIterations) break;
    guess.step_dn = fit.contrast_dn;
    guess.black_share = std::clamp(solution(3) / solution(0), 0.0, 1.0);
  }
  const double most = window.with_bar ? kMostMisfitWithBar : kMostMisfit;
  if (fit.misfit_dn > most * fit.contrast_dn) return std::nullopt;
  return fit;
}

}  // namespace dockyard
