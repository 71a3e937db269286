// The share of a pixel that is a tag's ink.
#include "render/tag_ink.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/base/split_mix.h"
#include "render/board_ink.h"
#include "render/board_wear.h"
#include "render/scene_samples.h"
#include "vision/tags/tag_views.h"

namespace dockyard {
namespace {

using Footprint = std::array<Eigen::Vector2f, 4>;

/// Whether a point of the board is ink, from the tag's squares alone.
bool IsInk(const SquareTag& tag, const Eigen::Vector2d& p_B) {
  const Eigen::Rotation2Dd turn(tag.rotation);  // clockwise in x right, y down: undoes the tag's
  const Eigen::Vector2d at =
      (turn * (p_B - tag.p_BT)) / tag.cell_m() + Eigen::Vector2d::Constant(0.5 * tag.cells.across);
  if (at.minCoeff() < 0.0 || at.maxCoeff() >= tag.cells.across) return false;
  return tag.cells.IsBlack(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

double Oversampled(const SquareTag& tag, const Footprint& pixel, int a_side) {
  int ink = 0;
  for (int j = 0; j < a_side; ++j) {
    for (int i = 0; i < a_side; ++i) {
      const double u = (i + 0.5) / a_side, v = (j + 0.5) / a_side;
      const Eigen::Vector2d p =
          (1 - v) * ((1 - u) * pixel[0].cast<double>() + u * pixel[1].cast<double>()) +
          v * ((1 - u) * pixel[3].cast<double>() + u * pixel[2].cast<double>());
      ink += IsInk(tag, p);
    }
  }
  return static_cast<double>(ink) / (a_side * a_side);
}

SquareTag TurnedTag() {
  SquareTag tag = OneTag("tag36h11", 7, 0.1).tags[0];
  tag.p_BT = {0.02, -0.03};
  tag.rotation = Radians(17);
  return tag;
}

/// Uniform in [0, 1), one number after the other.
class Numbers {
 public:
  double operator()() { return static_cast<double>(SplitMix(5, next_++) >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t next_ = 0;
};

TEST(TagInk, IsTheSharedAreaOfAnyFootprint) {
  const SquareTag tag = TurnedTag();
  const TagInk ink(tag);
  Numbers uniform;
  double worst = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double side = 0.0004 * std::pow(60.0, uniform());  // to two squares
    const Eigen::Vector2d at = tag.p_BT + 0.16 * Eigen::Vector2d(uniform() - 0.5, uniform() - 0.5);
    // A parallelogram, whose bilinear samples are uniform.
    const double turn = 2.0 * kPi * uniform();
    const Eigen::Vector2d x = side * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    const Eigen::Vector2d y = (0.3 + uniform()) * Eigen::Vector2d(-x.y(), x.x()) + 0.4 * x;
    const Footprint pixel{at.cast<float>(), (at + x).cast<float>(), (at + x + y).cast<float>(),
                          (at + y).cast<float>()};
    const double off = ink.Share(pixel) - Oversampled(tag, pixel, 200);
    worst = std::max(worst, std::abs(off));
  }
  // An edge through 200 x 200 points is wrong by at most about half a row of them.
  EXPECT_LT(worst, 0.004);
}

TEST(TagInk, HasNoSeamsBetweenBlackSquares) {
  SquareTag tag = TurnedTag();
  std::fill(tag.cells.black.begin(), tag.cells.black.end(), 1);
  const TagInk ink(tag);
  Numbers uniform;
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector2f at =
        (tag.p_BT + 0.06 * Eigen::Vector2d(uniform() - 0.5, uniform() - 0.5)).cast<float>();
    const auto side = static_cast<float>(0.0005 + 0.02 * uniform());
    const Footprint pixel{at, at + Eigen::Vector2f(side, 0), at + Eigen::Vector2f(side, side),
                          at + Eigen::Vector2f(0, side)};
    EXPECT_NEAR(ink.Share(pixel), 1.0, 1e-6);
  }
}

// All ink of an image adds up to the black squares' projected area.
TEST(TagInk, OfAllPixelsIsTheBlackArea) {
  const SquareTag tag = TurnedTag();
  const TagInk ink(tag);
  int blacks = 0;
  for (const std::uint8_t black : tag.cells.black) blacks += black;
  const float pixel = 0.0037f;
  double area = 0.0;
  for (int j = -40; j < 40; ++j) {
    for (int i = -40; i < 40; ++i) {
      const Eigen::Vector2f at =
          pixel * Eigen::Vector2f(static_cast<float>(i), static_cast<float>(j));
      area += pixel * pixel *
              ink.Share({at, at + Eigen::Vector2f(pixel, 0), at + Eigen::Vector2f(pixel, pixel),
                         at + Eigen::Vector2f(0, pixel)});
    }
  }
  const double wanted = blacks * tag.cell_m() * tag.cell_m();
  EXPECT_NEAR(area, wanted, 1e-5 * wanted);
}

TEST(BoardWear, TakesItsShareOfTheInkInPatches) {
  BoardView view{.board = OneTag("tag36h11", 7, 0.1), .X_WB = {}, .dusty_spots = {}};
  const auto at = [&](int i, int j, float side) {
    const Eigen::Vector2f p(side * static_cast<float>(i), side * static_cast<float>(j));
    return FlakedShare(view, {p, p + Eigen::Vector2f(side, 0), p + Eigen::Vector2f(side, side),
                              p + Eigen::Vector2f(0, side)});
  };
  EXPECT_EQ(at(3, 4, 0.001f), 0.0f);
  for (const double wear : {0.1, 0.4}) {
    view.wear = wear;
    double sum = 0.0;
    int alike = 0, flaked = 0;
    constexpr int kSide = 400;
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        const bool here = at(i, j, 0.0005f) > 0.5f;
        sum += at(i, j, 0.0005f);
        if (!here) continue;
        ++flaked;
        alike += at(i + 1, j, 0.0005f) > 0.5f;
      }
    }
    // 10 000 patches of 2 mm: 1 sigma is 0.01 sqrt(w (1 - w)) of the area.
    EXPECT_NEAR(sum / (kSide * kSide), wear, 0.02);
    // A point half a millimetre off lies mostly in the same patch.
    EXPECT_GT(static_cast<double>(alike) / flaked, 0.65);
  }
}

TEST(BoardWear, OfNothingChangesNothingAndOneSeedGivesTheSamePatches) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(160, 120, Radians(60));
  BoardView view{.board = OneTag("tag36h11", 7, 0.1), .X_WB = {}, .dusty_spots = {}};
  const GrayImage whole = RenderTags(renderer, view, camera, {.range_m = 0.4}, 1).image;
  view.wear_seed = 9;
  EXPECT_EQ(RenderTags(renderer, view, camera, {.range_m = 0.4}, 1).image, whole);
  view.wear = 0.2;
  const GrayImage worn = RenderTags(renderer, view, camera, {.range_m = 0.4}, 1).image;
  EXPECT_NE(worn, whole);
  EXPECT_EQ(RenderTags(renderer, view, camera, {.range_m = 0.4}, 1).image, worn);
  view.wear_seed = 10;
  EXPECT_NE(RenderTags(renderer, view, camera, {.range_m = 0.4}, 1).image, worn);
}

}  // namespace
}  // namespace dockyard
