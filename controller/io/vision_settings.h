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
