// The pyramid's two marks in one image, as Ferreira and Ventura find them (F, C.3): segmentation by
// colour, landmarks by shape, and the pair by what the pyramid's dimensions allow.
#pragma once

#include <optional>
#include <vector>

#include "controller/raposa/mark_angle.h"
#include "controller/raposa/nominal/nominal.h"
#include "controller/vision/colour_blobs.h"

namespace dockyard::raposa {

/// An orange blob that may be the guide.
struct OrangeMark {
  Ellipse ellipse;
  double area_px2 = 0.0;    // of the ellipse
  double distance_m = 0.0;  // at which the guide's ellipse has that area (F, D)
};

/// An ellipse and a blue rectangle that may be the pyramid.
struct MarkPair {
  OrangeMark orange;
  BlobBounds blue;
  double c_px = 0.0, g_px = 0.0;  // of eqs. (2) and (7)
  MarkAngle angle;                // without a side
  double alpha_rad = 0.0;         // > 0: the blue lies right of the guide
};

struct MarksSeen {
  std::optional<MarkPair> pair;
  std::optional<OrangeMark> orange;        // the pair's, else the best one alone
  std::optional<BlobBounds> blue;          // the pair's, else the largest one alone
  int oranges = 0, blues = 0, pairs = 0;   // that passed the filters
  Eigen::Vector2d deviation_px{0.0, 0.0};  // of the orange one from the image's middle:
                                           // to the right, down
};

/// Limits of the pair criteria.
struct PairLimits {
  double deviation = 0.0;    // of height and width, as a share of what the distance predicts
  double area_factor = 0.0;  // of the ratio of rectangle and ellipse
};
inline PairLimits LooseLimits(const FerreiraVision& v) {
  return {v.most_deviation, v.most_area_factor};
}
inline PairLimits TightLimits(const FerreiraVision& v) {
  return {v.tight_deviation, v.tight_area_factor};
}

/// Ellipses of the orange blobs, filtered by area, then by the ratio of their axes.
std::vector<OrangeMark> OrangeMarks(const ColourSearch& image, const Nominal& nominal,
                                    const FerreiraVision& vision);
/// Bounding regions of the blue blobs, filtered by area.
std::vector<BlobBounds> BlueMarks(const ColourSearch& image, const FerreiraVision& vision);

/// The two as a pair: c to the rectangle's farther end, on the side of its middle.
MarkPair PairOf(const OrangeMark& orange, const BlobBounds& blue, const Nominal& nominal);
/// By how much a pair is not the pyramid's: 0 as its dimensions have it, the sum of its deviations.
double Misfit(const MarkPair& pair, const Nominal& nominal);
/// Whether the pyramid can look like this. From the ellipse's distance follow the square's height
/// and its largest width; a square turned aside is narrower.
bool Possible(const MarkPair& pair, const Nominal& nominal, const PairLimits& limits);

/// The marks in an image. Several possible pairs face the tighter limits; if none passes these, all
/// of them stay. The one of least misfit is the pair. A single possible pair is never lost.
/// @param vision       bands and limits, in place of the nominal ones
/// @param previous_px  where the last ellipse was: ellipses outside the ball are ignored
MarksSeen FindMarks(const ColourSearch& image, const Nominal& nominal, const FerreiraVision& vision,
                    const std::optional<Eigen::Vector2d>& previous_px);

/// FindMarks frame by frame.
class MarkTracker {
 public:
  explicit MarkTracker(const Nominal& nominal) : nominal_(nominal) {}
  /// @param opens  whether the ball opens after the lost frames
  MarksSeen Find(const RgbImage& image, const FerreiraVision& vision, bool opens = true);
  /// Frames in a row without an ellipse.
  int lost() const { return lost_; }
  /// The view has changed by more than a frame's motion.
  void Forget() { previous_px_.reset(); }

 private:
  Nominal nominal_;
  std::optional<Eigen::Vector2d> previous_px_;
  int lost_ = 0;
};

}  // namespace dockyard::raposa
