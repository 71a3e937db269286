// What the back camera shows, frame by frame, with the bands of the moment.
#pragma once

#include "controller/raposa/align_plan.h"
#include "controller/raposa/marks.h"

namespace dockyard::raposa {

class Sight {
 public:
  explicit Sight(const Nominal& nominal);

  /// Searches the frame's picture of the back camera, if it has one. Bands that are due by its tick
  /// hold from then on.
  /// @param opens  as of MarkTracker::Find
  void Look(const SensorFrame& sensed, bool opens = true);
  /// Whether the last frame had a picture; seen() is of the last picture.
  bool fresh() const { return without_ == 0; }
  /// No picture for long.
  bool silent() const { return without_ > kMostWithout; }
  const MarksSeen& seen() const { return seen_; }
  /// Pictures in a row without an ellipse.
  int lost() const { return tracker_.lost(); }
  void Forget() { tracker_.Forget(); }
  /// Changes of the bands so far.
  int band_changes() const { return static_cast<int>(next_change_); }

  /// Of the ellipse, to the right of the camera's axis.
  double Bearing() const;
  /// At which the ellipse would leave the view.
  double EdgeOfView() const;
  /// Of the pair.
  GuidePlace Guide() const;
  Eigen::Vector2d middle_px() const;  // of the image
  double half_view_px() const;

 private:
  static constexpr int kMostWithout = 3;  // control periods; assumed, 2-10

  Nominal nominal_;
  FerreiraVision vision_;
  MarkTracker tracker_;
  MarksSeen seen_;
  int without_ = kMostWithout + 1;
  std::size_t next_change_ = 0;
};

}  // namespace dockyard::raposa
