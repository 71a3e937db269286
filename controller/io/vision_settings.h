// Which perception pipeline the robot runs. Part of its nominal parameters, so that a log replays
// with it.
#pragma once

namespace dockyard {

enum class VisionPipeline {
  kDockyard,  // ours: docs/reference/perception.md
  kTsai2013,  // as Tsai et al. (2013), III, describe theirs
};
inline const char* PipelineName(VisionPipeline pipeline) {
  return pipeline == VisionPipeline::kTsai2013 ? "tsai2013" : "dockyard";
}

/// Which of several detections of one rotation tsai2013 gives to the homography first. Tsai et al.
/// (V-D) do not say which four of the six or seven they took.
enum class Tsai2013First { kLowest, kTopmost, kLeftmost, kLargest };

/// What Tsai et al. (2013), III, leave open of their perception. Held fixed in all light (V-D);
/// docs/reference/axel2013.md says how each was chosen.
struct Tsai2013Vision {
  // Adaptive threshold: a pixel is black this share below the Gaussian mean about it, whose
  // standard deviation is this share of the image's width. The window is the toolbox's; the level
  // the middle of those that find the most fiducials in even light. Assumed, ranges 0.20-0.55 and
  // 0.03-0.1.
  double black_below_mean = 0.40, window_share = 0.05;
  // "Closeness threshold" (III-A.3): this and so many radii of the disc. Assumed, ranges 3-10 px
  // and 0-2.
  double closeness_px = 6.0, closeness_radii = 1.2;
  // Detections that must lie close to the re-projected model, those of the homography included.
  // Assumed, 4-6.
  int agreeing_points = 5;
  Tsai2013First first = Tsai2013First::kLowest;

  // The blob filter: "size, eccentricity, Euler number, and coincident centroids of black and white
  // blobs", whose thresholds "had wide ranges" (III-A.2), and the "B/W ratio" (Fig. 5). The paper
  // has no value of any.
  double least_area_px = 20.0;     // of a region, a disc 5 px across; assumed, 10-60
  double most_area_share = 0.05;   // of the image, a disc at half a metre; assumed, 0.02-0.1
  double least_axis_ratio = 0.45;  // 63 deg from the front; assumed, 0.3-0.6
  int most_holes = 2;              // an Euler number of -1 or more; assumed, 1-4
  double coincidence = 0.25;       // of the centroids, in mean radii; assumed, 0.15-0.4
  double least_white = 0.04;       // of the disc, where the printed bar has 0.18; assumed, 0.02-0.1
  double most_white = 0.45;        // the same; assumed, 0.3-0.6
  // The paper does not name these two.
  double fullness = 0.8;        // outline's area over its ellipse's; assumed, 0-0.9 (0: none)
  double pattern_within = 0.8;  // of the radius: the white is measured within it; assumed, 0.6-0.95

  bool operator==(const Tsai2013Vision&) const = default;
};

struct VisionSettings {
  VisionPipeline pipeline = VisionPipeline::kDockyard;
  // tsai2013 only: detections given to the homography. Four as flown, which cannot vote a false one
  // out; five as its authors advise (Tsai et al., V-D).
  int min_points = 4;
  // Stops to either side of the bracket that the docking controller takes where one exposure does
  // not hold the board; 0: none. Two keep a surface in a sixteenth of the sun's light (a clear
  // sky's share of it is a fourth to a ninth) where the first exposure had the sun's. Assumed, 1-3.
  double bracket_stops = 2.0;
  Tsai2013Vision tsai2013{};
  bool while_driving = false;  // pictures are taken under way, too

  bool operator==(const VisionSettings&) const = default;
};

}  // namespace dockyard
