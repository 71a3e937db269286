#include "controller/vision/board/fix_fit.h"

#include <algorithm>

namespace dockyard {

long CountIn(const std::vector<MarkPixel>& marks, int view) {
  return std::count_if(marks.begin(), marks.end(), [&](const auto& m) { return m.view == view; });
}

Fix Refit(const FitInputs& inputs, const Fix& fix, const std::vector<MarkPixel>& marks,
          bool with_covariance) {
  RefineOptions options = inputs.refine;
  options.with_covariance = with_covariance;
  if (fix.method == "stereo") {
    return {RefinePose(marks, inputs.views, inputs.board, fix.fit.X_RB, options), marks, "stereo"};
  }
  const std::size_t view = fix.method == "left" ? 0 : 1;
  std::vector<MarkPixel> alone = marks;
  for (MarkPixel& mark : alone) mark.view = 0;
  return {RefinePose(alone, {inputs.views[view]}, inputs.board, fix.fit.X_RB, options), marks,
          fix.method};
}

Fix WithoutStrays(const FitInputs& inputs, const Fix& fix) {
  Fix at = Refit(inputs, fix, fix.marks, true);
  const std::size_t least = std::max<std::size_t>(kMinTogether, (2 * fix.marks.size() + 2) / 3);
  while (at.marks.size() > least) {
    const auto worst = std::max_element(at.fit.mark_sigmas.begin(), at.fit.mark_sigmas.end());
    if (*worst < kStraySigmas) break;
    std::vector<MarkPixel> rest = at.marks;
    rest.erase(rest.begin() + (worst - at.fit.mark_sigmas.begin()));
    if (at.method == "stereo" && std::min(CountIn(rest, 0), CountIn(rest, 1)) < kMinSecondCamera)
      break;
    at = Refit(inputs, at, rest, true);
  }
  return at;
}

}  // namespace dockyard
