#include "eyes/false_boards.h"

#include <memory>
#include <vector>

#include "eyes/yard_views.h"

namespace dockyard {

FalseBoards LookWithoutBoard(int first, int count, int width, const VisionSettings& settings) {
  std::vector<std::unique_ptr<YardViews>> views;
  for (const Light light : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    YardOptions options{.light = light, .width = width, .height = width * 3 / 4};
    options.has_board = false;
    options.r_min_m = 0.8;
    options.r_max_m = 9.0;
    options.alpha_rad = Radians(80.0);
    options.h_rad = Radians(180.0);
    options.seed = 41;
    views.push_back(std::make_unique<YardViews>(options));
  }
  FalseBoards sum;
  for (int i = first; i < first + count; ++i) {
    YardViews& yard = *views[static_cast<std::size_t>(i) % views.size()];
    const YardLook look = yard.Take(i);
    const LocateOutput out =
        LocateBoard(look.images, yard.calibration(), yard.board(), look.hints, settings);
    ++sum.views;
    sum.discs += out.report.detected_left + out.report.detected_right;
    sum.accepted += out.report.accepted;
  }
  return sum;
}

}  // namespace dockyard
