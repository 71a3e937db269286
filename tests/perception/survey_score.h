// The score of one image pair against the truth, and sums over many, by range.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "perception/homography_sums.h"
#include "perception/yard_views.h"

namespace dockyard::axel {

struct SampleScore {
  int index = 0;
  DockingCoords at;
  bool in_view = false;   // five fiducials whole and unhidden in one image
  bool found = false;     // five rightly named detections, both images together
  bool accepted = false;  // a pose came out
  bool wrong = false;     // it is off by more than 0.3 m or 10 deg
  bool stereo = false;
  std::string reason{};  // why no pose came out
  int detections = 0, wrong_marks = 0;
  int left_marks = 0, right_marks = 0;
  double range_error_m = 0.0, heading_error_rad = 0.0;  // of the rover in the dock
  // Distances of detected, rightly named fiducials from the truth, squared; unshaded or wholly
  // shaded ones, and those that a shadow's edge cuts.
  double plain_px2 = 0.0, cut_px2 = 0.0;
  int plain = 0, cut = 0;
  double nees = 0.0;  // pose error squared over the covariance given, 6 degrees of freedom
  std::array<HomographySum, 2> homography{};  // left, right
};

SampleScore Score(const YardSample& sample, const LocateOutput& out);

/// Sums over image pairs of one kind.
struct SurveyTally {
  int pairs = 0, in_view = 0, found = 0, accepted = 0, wrong = 0, stereo = 0, wrong_marks = 0;
  int plain = 0, cut = 0;
  double range_m2 = 0.0, heading_rad2 = 0.0, plain_px2 = 0.0, cut_px2 = 0.0, nees = 0.0;
  // Over the accepted whose marks are all right, at least six in each image ("typically 6-7", Tsai
  // et al., V-D): the errors that calibration and noise leave when detection and naming succeed.
  int named = 0;
  double named_range_m2 = 0.0, named_heading_rad2 = 0.0;

  void Add(const SampleScore& score);
  double range_rms_m() const;
  double heading_rms_rad() const;
  double named_range_rms_m() const;
  double named_heading_rms_rad() const;
  double plain_rms_px() const;
  double cut_rms_px() const;
};

/// Image pairs with r in (low, high].
SurveyTally TallyOf(const std::vector<SampleScore>& scores, double r_low_m, double r_high_m);

}  // namespace dockyard::axel
