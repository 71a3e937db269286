#include "sim/app/point_doubts.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace dockyard {
namespace {

using Points = std::vector<PointPixel>;

/// Chi-square over its freedom.
double Share(const PointPose& pose) { return pose.fit.misfit / std::max(1, pose.fit.freedom); }

struct Mistake {
  Points mended;
  std::string text;  // part of a sentence
};

Mistake Exchanged(Points points) {
  for (PointPixel& point : points) point.view = 1 - point.view;
  return {std::move(points), "with left and right exchanged the points agree"};
}

/// A body in one plane, mirrored, is the same body viewed from behind.
Mistake MirroredBody(Points points) {
  for (PointPixel& point : points) point.p_B.x() = -point.p_B.x();
  return {std::move(points),
          "with x turned round (mirrored) the points agree: are the body's axes left-handed?"};
}

/// The pixels of an image that is smaller by this factor; none when some would leave the image.
std::optional<Mistake> Scaled(Points points, const StereoRig& rig, double factor) {
  for (PointPixel& point : points) {
    const Camera& camera = point.view == 0 ? rig.left : rig.right;
    point.pixel = factor * (point.pixel.array() + 0.5).matrix();
    point.pixel.array() -= 0.5;
    if (!camera.Sees(point.pixel)) return std::nullopt;
  }
  const Camera& camera = points[0].view == 0 ? rig.left : rig.right;
  char text[200];
  std::snprintf(text, sizeof text,
                "as pixels of an image of another size, %.0f x %.0f, the points agree; the cameras "
                "are those of %d x %d (--width, --height)",
                camera.width / factor, camera.height / factor, camera.width, camera.height);
  return Mistake{std::move(points), text};
}

std::vector<Mistake> Mistakes(const Points& points, const StereoRig& rig) {
  std::vector<Mistake> mistakes;
  const auto in_right = [](const PointPixel& point) { return point.view == 1; };
  const auto right = std::count_if(points.begin(), points.end(), in_right);
  const bool both = right > 0 && right < static_cast<long>(points.size());
  if (both) mistakes.push_back(Exchanged(points));
  mistakes.push_back(MirroredBody(points));
  for (const double factor : {2.0, 0.5, 1.5, 2.0 / 3.0, 4.0, 0.25, 3.0, 1.0 / 3.0}) {
    if (auto scaled = Scaled(points, rig, factor)) mistakes.push_back(std::move(*scaled));
  }
  return mistakes;
}

}  // namespace

FrameAnswer AnswerFor(const PointFrame& frame, const StereoRig& rig, const VisionSettings& settings,
                      const PointOptions& options) {
  constexpr double kMuchLess = 0.1;  // assumed, 0.03-0.3
  FrameAnswer answer{.pose = PoseFromPoints(frame.points, rig, settings, options),
                     .survey_m = options.survey_m,
                     .pipeline = PipelineName(settings.pipeline)};
  if (settings.pipeline != VisionPipeline::kDockyard) return answer;
  if (answer.pose ? Share(*answer.pose) <= kBeyondReason
                  : answer.pose.error() == PoseFailure::kTooFewFiducials) {
    return answer;
  }
  // The best of those that agree: a mirrored body, say, also agrees a little with a wrong scale.
  double least = answer.pose ? kMuchLess * Share(*answer.pose) : kBeyondReason;
  least = std::min(least, kBeyondReason);
  for (Mistake& mistake : Mistakes(frame.points, rig)) {
    const auto mended = PoseFromPoints(mistake.mended, rig, settings, options);
    if (!mended || Share(*mended) > least) continue;
    least = Share(*mended);
    answer.agree_when = std::move(mistake.text);
  }
  if (!answer.agree_when.empty()) {
    if (!answer.pose) return answer;
    answer.chi_square = answer.pose->fit.misfit;
    answer.freedom = answer.pose->fit.freedom;
    answer.pose = PoseFailure::kPoorFit;
    return answer;
  }
  if (!answer.pose) return answer;
  char text[300];
  std::snprintf(
      text, sizeof text,
      "chi-square %.0f of %d: the points agree only if their pixels err by %.2f px; check "
      "the images' size, the calibration and the points",
      answer.pose->fit.misfit, answer.pose->fit.freedom, answer.pose->sigma_px);
  answer.warnings.push_back(text);
  return answer;
}

}  // namespace dockyard
