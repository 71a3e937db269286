// dockyard pose on files with the usual mistakes: another image's pixels, mirrored axes, gaps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/program.h"
#include "sim/base/random.h"
#include "support/fake_runs.h"

namespace dockyard::axel {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A pair of pinholes of 640 x 480, f 500 px, 0.12 m apart, in the left camera's frame.
class PoseDoubts : public ::testing::Test {
 protected:
  PoseDoubts() {
    const std::string camera =
        "model: pinhole, pixel_zero: centre, width_px: 640, height_px: 480, fx_px: 500, fy_px: "
        "500, cx_px: 319.5, cy_px: 239.5";
    rig_ = (folder_.path() / "rig.yaml").string();
    file_ = (folder_.path() / "points.csv").string();
    WriteText(rig_, "left: {" + camera + "}\nright: {" + camera +
                        ", position_m: [0.12, 0, 0], pitch_deg: -90, roll_deg: 90}\n");
  }
  /// Corners of a box 1.2 m ahead, turned by 0.3 about y, by the pinhole's own formula; pixels as
  /// of an image `scale` times as large, x times `hand`, with noise.
  std::string Rows(double scale, double hand, double noise_px, const std::string& frame = "") {
    std::string csv;
    for (int i = 0; i < 16; ++i) {
      const double x = size_ * (i & 1 ? 0.2 : -0.15), y = size_ * (i & 2 ? 0.15 : -0.2),
                   z = size_ * (i & 4 ? 0.1 : -0.12);
      const double by = i & 8 ? 0.5 : 1.0;
      const double bx = by * x, bz = by * z, c = std::cos(0.3), s = std::sin(0.3);
      const double X = c * bx + s * bz + 0.05, Y = by * y + 0.02, Z = -s * bx + c * bz + 1.2;
      for (const double at : {0.0, 0.12}) {
        const double u = 319.5 + 500 * (X - at) / Z + noise_px * random_.Normal();
        const double v = 239.5 + 500 * Y / Z + noise_px * random_.Normal();
        char row[200];
        std::snprintf(row, sizeof row, "%s%s,%.4f,%.4f,%.4f,%.4f,%.4f\n", frame.c_str(),
                      at > 0.0 ? "right" : "left", scale * (u + 0.5) - 0.5, scale * (v + 0.5) - 0.5,
                      hand * bx, by * y, bz);
        csv += row;
      }
    }
    return csv;
  }
  Ended Pose(const std::string& rows, const std::string& arguments = "") {
    WriteText(file_, "camera,u_px,v_px,x_m,y_m,z_m\n" + rows);
    return Dockyard("pose " + file_ + " --rig " + rig_ + " --json " + arguments);
  }

  RandomStream random_{StreamKey(3, "pose doubts")};
  const TemporaryFolder folder_;
  std::string rig_, file_;
  double size_ = 1.0;
};

TEST_F(PoseDoubts, GoodPointsHaveNoWarning) {
  const Ended ended = Pose(Rows(1.0, 1.0, 0.1));
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json out = json::parse(ended.out);
  EXPECT_TRUE(out["warnings"].empty());
  EXPECT_NEAR(out["body_in_rover"]["p_m"][2].get<double>(), 1.2, 0.006);
  EXPECT_LT(out["chi_square"].get<double>(), 3.0 * out["freedom"].get<double>());
}

TEST_F(PoseDoubts, APixelOutsideTheImageIsRefusedWithItsRow) {
  for (const double scale : {2.0, 1.9}) {
    const Ended ended = Pose(Rows(scale, 1.0, 0.1));
    EXPECT_EQ(ended.code, 3);
    EXPECT_THAT(ended.err, HasSubstr("row "));
    EXPECT_THAT(ended.err, HasSubstr("it lies outside"));
    EXPECT_THAT(ended.err, HasSubstr("640 x 480"));
  }
}

TEST_F(PoseDoubts, PixelsOfASmallerImageAreNamedAsSuch) {
  const Ended ended = Pose(Rows(0.5, 1.0, 0.05));
  EXPECT_EQ(ended.code, 4) << ended.out;
  EXPECT_THAT(ended.out, HasSubstr("image of another size, 320 x 240"));
}

// A small body in a corner of the image: a long, tilted one explains its pixels nearly.
TEST_F(PoseDoubts, ASmallBodyInASmallerImageIsNotBelieved) {
  size_ = 0.5;
  const Ended good = Pose(Rows(1.0, 1.0, 0.05));
  ASSERT_EQ(good.code, 0) << good.out;
  EXPECT_TRUE(json::parse(good.out)["warnings"].empty());
  for (const double scale : {0.25, 1.0 / 3.0, 0.5}) {
    const Ended ended = Pose(Rows(scale, 1.0, 0.05));
    EXPECT_EQ(ended.code, 4) << scale << ended.out;
  }
}

TEST_F(PoseDoubts, AMirroredBodyIsNamedAsSuch) {
  const Ended ended = Pose(Rows(1.0, -1.0, 0.1));
  EXPECT_EQ(ended.code, 4) << ended.out;
  EXPECT_THAT(ended.out, HasSubstr("with x turned round (mirrored) the points agree"));
}

TEST_F(PoseDoubts, NoiseBeyondReasonIsAWarningAndInTheCovariance) {
  const json fine = json::parse(Pose(Rows(1.0, 1.0, 0.15)).out);
  const Ended ended = Pose(Rows(1.0, 1.0, 1.5));
  ASSERT_EQ(ended.code, 0) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr("warning: chi-square"));
  const json coarse = json::parse(ended.out);
  ASSERT_EQ(coarse["warnings"].size(), 1u);
  EXPECT_NEAR(coarse["pixel_sigma_px"].get<double>(), 1.5, 0.4);
  EXPECT_GT(coarse["body_in_rover"]["covariance"][5][5].get<double>(),
            fine["body_in_rover"]["covariance"][5][5].get<double>());
}

TEST_F(PoseDoubts, RowsWithoutAPixelAreLeftOutAndCounted) {
  WriteText(file_, "frame,camera,u_px,v_px,x_m,y_m,z_m\n" + Rows(1.0, 1.0, 0.1, "a,") +
                       "a,left,nan,NaN,0.1,0.1,0.1\nb,left,,,0.1,0.1,0.1\nb,,,,,,\n,,,,,,\n" +
                       Rows(1.0, 1.0, 0.1, "c,"));
  const std::string command = "pose --sequence " + file_ + " --rig " + rig_;
  const Ended ended = Dockyard(command + " --json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("3 frames, 2 poses; 3 rows without a pixel left out"));
  std::istringstream lines(ended.out);
  std::vector<json> frames;
  for (std::string line; std::getline(lines, line);) frames.push_back(json::parse(line));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(frames[0]["not_detected"], 1);
  EXPECT_EQ(frames[0]["points_used"], 32);
  EXPECT_EQ(frames[1]["accepted"], false);
  EXPECT_EQ(frames[1]["not_detected"], 2);
  EXPECT_EQ(frames[2]["accepted"], true);
  for (const json& frame : frames) EXPECT_TRUE(frame["warnings"].is_array());
  // A single frame says so in its warnings.
  const Ended single = Pose(Rows(1.0, 1.0, 0.1) + "left,NaN,NaN,0.1,0.1,0.1\n");
  ASSERT_EQ(single.code, 0) << single.err;
  EXPECT_THAT(single.err, HasSubstr("1 row without a pixel left out"));
}

TEST_F(PoseDoubts, AStatedCalibrationErrorWidensTheStatedNoise) {
  const json before = json::parse(Pose(Rows(1.0, 1.0, 0.5)).out);
  WriteText(rig_, "calibration_error_px: 0.5\n" + Slurp(rig_));
  const json after = json::parse(Pose(Rows(1.0, 1.0, 0.5)).out);
  EXPECT_GT(before["chi_square"].get<double>(), 4.0 * before["freedom"].get<double>());
  EXPECT_LT(after["chi_square"].get<double>(), 2.0 * after["freedom"].get<double>());
}

}  // namespace
}  // namespace dockyard::axel
