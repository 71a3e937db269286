// Squares on the board are drawn as truly as the renderer draws discs: comparisons are fair.
#include "render/printed_board.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/measure.h"

namespace dockyard {
namespace {

/// The fiducials as squares of half a millimetre.
std::vector<PrintedImage> FineFiducials(const FiducialBoard& board) {
  constexpr int kModules = 200;
  std::vector<PrintedImage> prints;
  for (const Fiducial& fiducial : board.fiducials) {
    PrintedImage print{.p_BM = fiducial.p_BF,
                       .module_m = board.disc_diameter_m / kModules,
                       .modules = kModules,
                       .black = {}};
    const Eigen::Vector2d along(std::cos(fiducial.rotation), -std::sin(fiducial.rotation));
    for (int row = 0; row < kModules; ++row) {
      for (int column = 0; column < kModules; ++column) {
        const Eigen::Vector2d p = print.module_m * Eigen::Vector2d(column - 99.5, row - 99.5);
        const double a = std::abs(p.dot(along)),
                     b = std::abs(p.x() * along.y() - p.y() * along.x());
        const bool bar = a < 0.5 * board.bar_length_m && b < 0.5 * board.bar_width_m;
        print.black.push_back(p.norm() < 0.5 * board.disc_diameter_m && !bar);
      }
    }
    prints.push_back(print);
  }
  return prints;
}

TEST(PrintedBoard, InkIsTheSharedArea) {
  // Two by two modules of 1 m, black top left and bottom right, about (1, 1): they span 0 to 2.
  const PrintedImage print{
      .p_BM = {1, 1}, .module_m = 1.0, .modules = 2, .black = {true, false, false, true}};
  const auto square = [](double x, double y, double side) {
    return std::array<Eigen::Vector2d, 4>{
        Eigen::Vector2d(x, y), {x + side, y}, {x + side, y + side}, {x, y + side}};
  };
  EXPECT_DOUBLE_EQ(InkShare(print, square(0.2, 0.2, 0.5)), 1.0);
  EXPECT_DOUBLE_EQ(InkShare(print, square(1.2, 0.2, 0.5)), 0.0);
  EXPECT_DOUBLE_EQ(InkShare(print, square(0.5, 0.5, 1.0)), 0.5);
  EXPECT_DOUBLE_EQ(InkShare(print, square(-0.5, -0.5, 1.0)), 0.25);
  EXPECT_DOUBLE_EQ(InkShare(print, square(5.0, 0.0, 1.0)), 0.0);
  // A diamond about (0.5, 0.5) with half diagonals of 1 holds the first module whole, an area of 2.
  const std::array<Eigen::Vector2d, 4> diamond{
      Eigen::Vector2d(0.5, -0.5), {1.5, 0.5}, {0.5, 1.5}, {-0.5, 0.5}};
  EXPECT_DOUBLE_EQ(InkShare(print, diamond), 0.5);
}

// The same discs drawn by the renderer and by squares, under a canopy's hard shadow.
TEST(PrintedBoard, DiscsOfFineSquaresLookLikeTheRenderers) {
  for (const double range_m : {2.0, 4.0}) {
    const auto yard = SampleYard(range_m, SunAt(0.5, 0.7));
    AddCanopy(*yard);
    StereoRenderer renderer;
    const StereoRig rig = SampleRig(640, 480);
    const auto drawn = renderer.RenderRadiance(yard->scene, rig, yard->X_WR);
    const auto printed = RenderPrinted(renderer, yard->scene, rig, yard->X_WR,
                                       FineFiducials(yard->scene.boards[0].board));
    const double white =
        UnshadedRadiance(yard->scene.light, -yard->scene.boards[0].X_WB.R.col(2), 0.85);
    double worst = 0.0, squares = 0.0;
    int count = 0;
    for (int view = 0; view < 2; ++view) {
      for (std::size_t i = 0; i < drawn[view].values.size(); ++i) {
        const double off = (drawn[view].values[i] - printed[view].values[i]) / white;
        if (off == 0.0) continue;
        worst = std::max(worst, std::abs(off));
        squares += off * off;
        ++count;
      }
    }
    ASSERT_GT(count, 500);
    std::printf("range %.0f m: %d pixels unlike, rms %.4f, worst %.4f of white\n", range_m, count,
                std::sqrt(squares / count), worst);
    EXPECT_LT(std::sqrt(squares / count), 0.01);
    EXPECT_LT(worst, 0.05);
  }
}

// The measurement of a detector of squares: centroids of black squares as large as a tag.
TEST(PrintedBoard, CentroidsOfSquaresLieWhereTheyProject) {
  for (const double range_m : {1.5, 3.0, 5.0}) {
    Scene scene = BoardOnly();
    scene.boards[0].board.width_m = 1.3;
    scene.boards[0].board.height_m = 0.9;
    scene.boards[0].X_WB.R = RotZ(0.5) * scene.boards[0].X_WB.R;
    const Camera camera = EquidistantCamera(1024, 768, kPi / 2);
    const StereoRig rig = RigAt(camera, LookAt({range_m, 0.05, 0.62}, {0.0, -0.03, 0.75}));
    std::vector<PrintedImage> prints;
    for (const Fiducial& fiducial : scene.boards[0].board.fiducials) {
      prints.push_back({fiducial.p_BF, 0.1, 1, {true}});
    }
    StereoRenderer renderer;
    const auto pair = RenderPrinted(renderer, scene, rig, {}, prints);
    const double white = UnshadedRadiance(scene.light, -scene.boards[0].X_WB.R.col(2), 0.85);
    const Pose3 X_CB = Inverse(rig.X_RL) * scene.boards[0].X_WB;
    double squares = 0.0;
    for (const PrintedImage& print : prints) {
      // Its area in the image and the area's centroid, cell by cell.
      constexpr int kCells = 60;
      const auto project = [&](int i, int j) {
        const Eigen::Vector2d p = print.p_BM + 0.1 * Eigen::Vector2d(i - 30, j - 30) / kCells;
        return *camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0));
      };
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      double total = 0.0;
      for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
          const Eigen::Vector2d a = project(i, j), c = project(i + 1, j + 1);
          const Eigen::Vector2d b = project(i + 1, j), d = project(i, j + 1);
          const double area = (c - a).x() * (d - b).y() - (c - a).y() * (d - b).x();
          sum += area * 0.25 * (a + b + c + d);
          total += area;
        }
      }
      const Eigen::Vector2d exact = sum / total;
      const double window = 0.07 * camera.focal_px().x() / range_m + 2.0;
      squares += (CentroidOfDark(pair[0], exact, window, white) - exact).squaredNorm();
    }
    const double rms_px = std::sqrt(squares / static_cast<double>(prints.size()));
    std::printf("range %.1f m: rms %.4f px\n", range_m, rms_px);
    EXPECT_LT(rms_px, 0.01);
  }
}

}  // namespace
}  // namespace dockyard
