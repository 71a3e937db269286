// Which images a log keeps.
#include "sim/run/image_thinning.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dockyard {
namespace {

/// The ticks that are kept of frames with images, 100 ms apart.
std::vector<Tick> Kept(double gap_s, const std::vector<std::string>& phases) {
  ImageThinning thinning(gap_s);
  std::vector<Tick> kept;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const Tick tick = 100 * static_cast<Tick>(i);
    if (thinning.Keeps(tick, phases[i])) kept.push_back(tick);
  }
  return kept;
}

TEST(ImageThinning, WithoutAGapKeepsAll) {
  EXPECT_EQ(Kept(0.0, {"a", "a", "a"}), (std::vector<Tick>{0, 100, 200}));
}

TEST(ImageThinning, KeepsOneInTheGap) {
  EXPECT_EQ(Kept(0.3, std::vector<std::string>(8, "a")), (std::vector<Tick>{0, 300, 600}));
}

TEST(ImageThinning, KeepsThoseOfAChangeOfPhaseAndCountsTheGapFromThere) {
  EXPECT_EQ(Kept(0.3, {"a", "b", "b", "b", "b", "a", "a", "a"}),
            (std::vector<Tick>{0, 100, 400, 500}));
}

}  // namespace
}  // namespace dockyard
