#include "controller/raposa/marks.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::raposa {
namespace {

/// What the distance of the ellipse predicts for the blue square.
struct Predicted {
  double height_px = 0.0;
  double most_c_px = 0.0;    // at the turning point of (7)
  double area_ratio = 0.0;   // square over ellipse, face on
  double least_share = 0.0;  // of that ratio, at the largest angle
};

Predicted Predict(const MarkPair& pair, const Nominal& nominal) {
  const Marks& marks = nominal.marks;
  const double half_m = 0.5 * marks.edge_m, alpha = pair.angle.alpha_rad;
  // Depth of the square's nearer edge, behind the guide at the ellipse's distance.
  const double depth_m =
      std::max(pair.orange.distance_m + marks.behind_m * std::cos(alpha) - half_m * std::sin(alpha),
               0.5 * pair.orange.distance_m);
  Predicted predicted;
  predicted.height_px = nominal.camera.focal_px().x() * marks.edge_m / depth_m;
  predicted.most_c_px = predicted.height_px * std::hypot(marks.behind_m, half_m) / marks.edge_m;
  predicted.area_ratio = predicted.height_px * predicted.height_px / pair.orange.area_px2;
  // At that angle the paint on one side of the square alone is visible.
  predicted.least_share = marks.strip_m / marks.edge_m * std::sin(kVisibleTo_rad);
  return predicted;
}

/// The pair's deviations, each 0 where the pyramid's dimensions allow it.
struct Deviations {
  double height = 0.0, offset = 0.0, width = 0.0, reach = 0.0;
  double area = 1.0;  // factor, >= 1

  double most() const { return std::max({height, offset, width, reach}); }
};

Deviations DeviationsOf(const MarkPair& pair, const Nominal& nominal) {
  const Predicted predicted = Predict(pair, nominal);
  const double ratio = pair.blue.area_px2() / pair.orange.area_px2 / predicted.area_ratio;
  Deviations d;
  d.height = std::abs(pair.g_px / predicted.height_px - 1.0);
  d.offset =
      std::abs(pair.blue.centre_px().y() - pair.orange.ellipse.centre_px.y()) / predicted.height_px;
  d.width = std::max(pair.blue.width_px() / predicted.height_px - 1.0, 0.0);
  d.reach = std::max(pair.c_px / predicted.most_c_px - 1.0, 0.0);
  d.area = std::max({ratio, predicted.least_share / ratio, 1.0});
  return d;
}

bool InBall(const OrangeMark& mark, const std::optional<Eigen::Vector2d>& previous_px,
            double ball_px) {
  return !previous_px || (mark.ellipse.centre_px - *previous_px).norm() <= ball_px;
}

const MarkPair* Best(const std::vector<MarkPair>& pairs, const Nominal& nominal) {
  const MarkPair* best = nullptr;
  double least = 0.0;
  for (const MarkPair& pair : pairs) {
    const double misfit = Misfit(pair, nominal);
    if (best && misfit >= least) continue;
    best = &pair;
    least = misfit;
  }
  return best;
}

std::optional<MarkPair> ChoosePair(const std::vector<MarkPair>& possible, const Nominal& nominal,
                                   const FerreiraVision& vision) {
  if (possible.empty()) return std::nullopt;
  if (possible.size() == 1) return possible.front();
  std::vector<MarkPair> tight;
  for (const MarkPair& pair : possible) {
    if (Possible(pair, nominal, TightLimits(vision))) tight.push_back(pair);
  }
  return *Best(tight.empty() ? possible : tight, nominal);
}

}  // namespace

std::vector<OrangeMark> OrangeMarks(const ColourSearch& image, const Nominal& nominal,
                                    const FerreiraVision& vision) {
  const double focal_px = nominal.camera.focal_px().x();
  const double radius_px = 0.5 * nominal.marks.guide_diameter_m * focal_px;  // at 1 m
  const double area_at_one_m_px2 =
      vision.area_at_one_m_px2 > 0.0 ? vision.area_at_one_m_px2 : kPi * radius_px * radius_px;
  std::vector<OrangeMark> marks;
  for (const ColourBlob& blob : image.Blobs(vision.orange, vision.least_area_px2)) {
    const Eigen::Vector2d axes = blob.ellipse.semi_axes_px();
    if (axes(0) < vision.least_axis_ratio * axes(1)) continue;
    const double area_px2 = kPi * axes(0) * axes(1);
    marks.push_back({.ellipse = blob.ellipse,
                     .area_px2 = area_px2,
                     .distance_m = std::sqrt(area_at_one_m_px2 / area_px2)});
  }
  return marks;
}

std::vector<BlobBounds> BlueMarks(const ColourSearch& image, const FerreiraVision& vision) {
  std::vector<BlobBounds> marks;
  for (const ColourBlob& blob : image.Blobs(vision.blue, vision.least_area_px2)) {
    marks.push_back(blob.bounds);
  }
  return marks;
}

MarkPair PairOf(const OrangeMark& orange, const BlobBounds& blue, const Nominal& nominal) {
  const double guide_px = orange.ellipse.centre_px.x();
  const bool right = blue.centre_px().x() >= guide_px;
  MarkPair pair{.orange = orange,
                .blue = blue,
                .c_px = right ? blue.right_px - guide_px : guide_px - blue.left_px,
                .g_px = blue.height_px(),
                .angle = {}};
  pair.angle = AngleOfMarks(pair.c_px, pair.g_px, nominal.marks.edge_m, nominal.marks.behind_m,
                            nominal.camera.focal_px().x());
  pair.alpha_rad = right ? pair.angle.alpha_rad : -pair.angle.alpha_rad;
  return pair;
}

double Misfit(const MarkPair& pair, const Nominal& nominal) {
  const Deviations d = DeviationsOf(pair, nominal);
  return d.height + d.offset + d.width + d.reach + std::log(d.area);
}

bool Possible(const MarkPair& pair, const Nominal& nominal, const PairLimits& limits) {
  const Deviations d = DeviationsOf(pair, nominal);
  return d.most() <= limits.deviation && d.area <= limits.area_factor;
}

MarksSeen FindMarks(const ColourSearch& image, const Nominal& nominal, const FerreiraVision& vision,
                    const std::optional<Eigen::Vector2d>& previous_px) {
  std::vector<OrangeMark> oranges = OrangeMarks(image, nominal, vision);
  std::erase_if(oranges,
                [&](const OrangeMark& mark) { return !InBall(mark, previous_px, vision.ball_px); });
  const std::vector<BlobBounds> blues = BlueMarks(image, vision);
  std::vector<MarkPair> possible;
  for (const OrangeMark& orange : oranges) {
    for (const BlobBounds& blue : blues) {
      const MarkPair pair = PairOf(orange, blue, nominal);
      if (Possible(pair, nominal, LooseLimits(vision))) possible.push_back(pair);
    }
  }
  MarksSeen seen;
  seen.oranges = static_cast<int>(oranges.size());
  seen.blues = static_cast<int>(blues.size());
  seen.pairs = static_cast<int>(possible.size());
  seen.pair = ChoosePair(possible, nominal, vision);
  if (seen.pair) {
    seen.orange = seen.pair->orange;
    seen.blue = seen.pair->blue;
  } else {
    const auto by_area = [](const auto& a, const auto& b) { return a.area_px2 < b.area_px2; };
    if (!oranges.empty()) seen.orange = *std::ranges::max_element(oranges, by_area);
    const auto by_bounds = [](const BlobBounds& a, const BlobBounds& b) {
      return a.area_px2() < b.area_px2();
    };
    if (!blues.empty()) seen.blue = *std::ranges::max_element(blues, by_bounds);
  }
  const Eigen::Vector2d middle_px(0.5 * (image.width() - 1), 0.5 * (image.height() - 1));
  if (seen.orange) seen.deviation_px = seen.orange->ellipse.centre_px - middle_px;
  return seen;
}

MarksSeen MarkTracker::Find(const RgbImage& image, const FerreiraVision& vision, bool opens) {
  MarksSeen seen = FindMarks(ColourSearch(image), nominal_, vision, previous_px_);
  if (seen.orange) {
    previous_px_ = seen.orange->ellipse.centre_px;
    lost_ = 0;
  } else if (++lost_ >= vision.lost_frames && opens) {
    previous_px_.reset();
  }
  return seen;
}

}  // namespace dockyard::raposa
