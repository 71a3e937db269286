// Finds a point of a face again in a new image. Its surroundings in an older image are drawn
// as from the new place and moved over the new one. Grey values decide: a face has no shape to find
// it by.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/geometry/image.h"
#include "controller/geometry/pose.h"
#include "controller/stereo/kept_face.h"

namespace dockyard {

struct FacePatchSettings {
  double half_m = 0.05;         // of the face about the point; assumed, 4-6 cm
  int least_half_px = 14;       // whatever that is on the face; assumed, 10-20
  int most_half_px = 40;        // assumed, 25-60
  double least_score = 0.6;     // of normalised correlation; assumed, 0.5-0.8
  double independent = 20.0;    // parts of a patch that look alike by chance; assumed, 10-40
  double least_odds = 3.0;      // log odds of the best place before the next; assumed, 2-5
  double least_contrast = 1.0;  // grey, one sigma over the patch, smoothed; assumed, 0.5-2
};

enum class PatchVerdict : std::uint8_t {
  kFound,
  kUnseen,     // the patch or its window lies off a picture
  kPlain,      // nothing on it to find it by
  kElsewhere,  // nothing in the window looks like it
  kAmbiguous,  // two places do
};

struct PatchFound {
  PatchVerdict verdict = PatchVerdict::kUnseen;
  Eigen::Vector2d pixel{0, 0};  // of the point
  double score = 0.0, second = 0.0;
};

/// The likeliest place: a correlation of c over so many independent parts has the log likelihood
/// -parts/2 log(1 - c^2), and the place itself that of a Gaussian about the prediction.
/// @param image      left and rectified, with the focal length and centre of the patch
/// @param X_NC       the older camera in the new one, as predicted; the point's pixel follows
/// @param sigma_px   of that pixel, along each side
/// @param window_px  how far from there it is looked for, along each side
PatchFound FindPatch(const FacePatch& patch, const GrayImage& image, const Pose3& X_NC,
                     double sigma_px, double window_px, const FacePatchSettings& settings);

}  // namespace dockyard
