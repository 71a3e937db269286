#include "perception/survey_score.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {
namespace {

// A mark counts as rightly named within this of the truth, more for large discs [px].
double AllowedPx(double disc_px) { return 3.0 + 0.04 * disc_px; }

double Root(double sum, int count) { return count > 0 ? std::sqrt(sum / count) : 0.0; }

}  // namespace

SampleScore Score(const YardSample& sample, const LocateOutput& out) {
  SampleScore score{.index = sample.index, .at = sample.at, .in_view = sample.InView()};
  score.accepted = static_cast<bool>(out.sighting);
  score.reason = out.report.reason;
  const double disc_px =
      0.10 * sample.built_rig.left.focal_px().x() / std::max(sample.X_RB.p.norm(), 0.2);
  int right = 0;
  for (const SightingReport::Mark& mark : out.report.marks) {
    ++score.detections;
    ++(mark.camera == 1 ? score.right_marks : score.left_marks);
    const auto& in_image = sample.marks[mark.camera == 1 ? 1 : 0];
    if (in_image.empty()) continue;
    const YardMark& truth = in_image[static_cast<std::size_t>(mark.id)];
    const auto& centre = truth.truth.centroid;
    const double off = centre ? (*centre - Eigen::Vector2d(mark.u_px, mark.v_px)).norm() : 1e9;
    if (off > AllowedPx(disc_px)) {
      ++score.wrong_marks;
      continue;
    }
    ++right;
    if (!truth.InView()) continue;
    (truth.CutByShadow() ? score.cut_px2 : score.plain_px2) += off * off;
    ++(truth.CutByShadow() ? score.cut : score.plain);
  }
  score.found = right >= 5;
  if (!out.sighting) return score;
  score.stereo = out.sighting->stereo;
  const Pose3 X_DR = sample.X_DB * Inverse(out.sighting->X_RB);
  const DockingCoords seen = ToDockingCoords(ToGround(X_DR));
  score.range_error_m = seen.r - sample.at.r;
  score.heading_error_rad = WrapPi(seen.h - sample.at.h);
  const double shift = (out.sighting->X_RB.p - sample.X_RB.p).norm();
  const Eigen::AngleAxisd turn(sample.X_RB.R * out.sighting->X_RB.R.transpose());
  score.wrong = shift > 0.3 || turn.angle() > Radians(10.0);
  if (out.sighting->covariance.isZero()) return score;
  Eigen::Matrix<double, 6, 1> error;
  error << sample.X_RB.p - out.sighting->X_RB.p, turn.angle() * turn.axis();
  score.nees = error.dot(out.sighting->covariance.ldlt().solve(error));
  return score;
}

void SurveyTally::Add(const SampleScore& score) {
  ++pairs;
  if (!score.in_view) return;
  ++in_view;
  found += score.found;
  plain += score.plain;
  cut += score.cut;
  plain_px2 += score.plain_px2;
  cut_px2 += score.cut_px2;
  wrong_marks += score.wrong_marks;
  if (!score.accepted) return;
  ++accepted;
  stereo += score.stereo;
  wrong += score.wrong;
  nees += score.nees;
  if (score.wrong_marks == 0 && score.left_marks >= 6 && score.right_marks >= 6) {
    ++named;
    named_range_m2 += score.range_error_m * score.range_error_m;
    named_heading_rad2 += score.heading_error_rad * score.heading_error_rad;
  }
  range_m2 += score.range_error_m * score.range_error_m;
  heading_rad2 += score.heading_error_rad * score.heading_error_rad;
}

double SurveyTally::range_rms_m() const { return Root(range_m2, accepted); }
double SurveyTally::heading_rms_rad() const { return Root(heading_rad2, accepted); }
double SurveyTally::named_range_rms_m() const { return Root(named_range_m2, named); }
double SurveyTally::named_heading_rms_rad() const { return Root(named_heading_rad2, named); }
double SurveyTally::plain_rms_px() const { return Root(plain_px2, plain); }
double SurveyTally::cut_rms_px() const { return Root(cut_px2, cut); }

SurveyTally TallyOf(const std::vector<SampleScore>& scores, double r_low_m, double r_high_m) {
  SurveyTally tally;
  for (const SampleScore& score : scores) {
    if (score.at.r > r_low_m && score.at.r <= r_high_m) tally.Add(score);
  }
  return tally;
}

}  // namespace dockyard::axel
