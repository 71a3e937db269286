// Internal to the vision room. The white bar in a disc: how well it fits at each rotation.
#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <optional>

#include "controller/geometry/board.h"
#include "controller/vision/ellipse.h"

namespace dockyard {

inline constexpr int kBarAngles = 16;  // over half a turn

struct BarMatch {
  // Correlation inside the disc with the printed pattern, its bar turned by pi i / kBarAngles
  // counter-clockwise as the viewer sees it, in the plane where the rim is a unit circle.
  std::array<float, kBarAngles> inner{};
  double whole = 0.0;     // correlation of disc and surround with the best of them
  double contrast = 0.0;  // share of the surrounding white that the black lacks
  // For a plain disc (FiducialBoard without bars) `inner` is zero.
};

/// flat: image with the light divided out, 8 bit. blur_px: 1 sigma of its blur. None when part of
/// the disc with its surround lies outside the image.
std::optional<BarMatch> MatchBar(const cv::Mat& flat, const Ellipse& rim,
                                 const FiducialBoard& board, double blur_px, double white_level);

}  // namespace dockyard
