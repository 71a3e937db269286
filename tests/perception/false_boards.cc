#include "perception/false_boards.h"

#include <vector>

#include "perception/survey_run.h"

namespace dockyard::axel {

FalseBoards LookWithoutBoard(int count, int width, int jobs, int tsai_count) {
  FalseBoards sum;
  const Light lights[] = {Light::kEven, Light::kSpeckled, Light::kHardShadow};
  for (int light = 0; light < 3; ++light) {
    YardOptions options{.light = lights[light], .width = width, .height = width * 3 / 4};
    options.has_board = false;
    options.r_min_m = 0.8;
    options.r_max_m = 9.0;
    options.alpha_rad = Radians(80.0);
    options.h_rad = Radians(180.0);
    options.seed = 41;
    const int turns = (count - light + 2) / 3;
    std::vector<FalseBoards> seen(static_cast<std::size_t>(turns));
    ForEachLook(options, turns, jobs, [&](YardViews& yard, int turn) {
      FalseBoards& here = seen[static_cast<std::size_t>(turn)];
      const YardSample sample = yard.Take(3 * turn + light);
      const LocateOutput out =
          LocateBoard(sample.images, yard.calibration(), yard.board(), sample.hints);
      here.discs = out.report.DetectedBy(0) + out.report.DetectedBy(1);
      here.accepted = out.report.accepted;
      if (sample.index >= tsai_count) return;
      here.tsai2013_views = 1;
      here.tsai2013_accepted = LocateBoard(sample.images, yard.calibration(), yard.board(),
                                           sample.hints, {.pipeline = VisionPipeline::kTsai2013})
                                   .report.accepted;
    });
    for (const FalseBoards& one : seen) {
      ++sum.views;
      sum.discs += one.discs;
      sum.accepted += one.accepted;
      sum.tsai2013_views += one.tsai2013_views;
      sum.tsai2013_accepted += one.tsai2013_accepted;
    }
  }
  return sum;
}

}  // namespace dockyard::axel
