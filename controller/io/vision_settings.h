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

struct VisionSettings {
  VisionPipeline pipeline = VisionPipeline::kDockyard;
  // tsai2013 only: detections given to the homography. Four as flown, which cannot vote a false one
  // out; five as its authors advise (Tsai et al., V-D).
  int min_points = 4;

  bool operator==(const VisionSettings&) const = default;
};

}  // namespace dockyard
