// What `dockyard check` says about pairs of cameras.
#include "sim/app/check_cameras.h"

#include <gmock/gmock.h>

#include <string>

#include "models/read/config_error.h"
#include "sim/app/pixel_rays.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kPinhole =
    "{model: pinhole, pixel_zero: centre, width_px: 640, height_px: 480, fx_px: 500, fy_px: 500, "
    "cx_px: 319.5, cy_px: 239.5";

FileCheck CheckAt(const std::string& position_m) {
  const ScratchFolder folder;
  return CheckRig(folder.Write("r.yaml", "left: " + kPinhole + "}\nright: " + kPinhole +
                                             ", position_m: [" + position_m +
                                             "], rotation_wxyz: [1, 0, 0, 0]}\n"));
}

TEST(CheckRig, SaysOnWhichSideTheRightCameraIs) {
  EXPECT_EQ(CheckAt("0.12, 0.01, -0.01").summary,
            "640 x 480 px, baseline 0.1208 m, right camera to the right");
  EXPECT_THAT(CheckAt("0.12, 0.01, -0.01").warnings, IsEmpty());
  EXPECT_THAT(CheckAt("-0.12, 0, 0").warnings,
              ElementsAre(HasSubstr("the right camera is to the left of the left one, at (-0.12, "
                                    "0, 0) m right, down and ahead of it: is the sign of T")));
  EXPECT_THAT(CheckAt("0.01, -0.12, 0").warnings, ElementsAre(HasSubstr("is above the left")));
  EXPECT_THAT(CheckAt("0.01, 0.12, 0").warnings, ElementsAre(HasSubstr("is below the left")));
  EXPECT_THAT(CheckAt("0, 0, -0.12").warnings, ElementsAre(HasSubstr("is behind the left")));
  EXPECT_THAT(CheckAt("0, 0, 0.12").warnings, ElementsAre(HasSubstr("is ahead of the left")));
}

TEST(CheckRig, TakesALongBaselineForMillimetres) {
  EXPECT_THAT(CheckAt("60, 0, 0").warnings,
              ElementsAre("the cameras are 60 m apart: is T given in millimetres?"));
}

TEST(CheckRig, StatesTheShareOfPixelsWithoutARay) {
  const ScratchFolder folder;
  // The polynomial turns back 351 px off the axis: r / f is at most 0.7027 there. Corners lie
  // beyond.
  const std::string bent =
      "{model: brown, pixel_zero: centre, width_px: 640, height_px: 480, fx_px: 500, fy_px: 500, "
      "cy_px: 239.5, k1: -0.3, k2: 0, cx_px: ";
  const FileCheck check = CheckRig(
      folder.Write("r.yaml", "left: " + bent + "319.5}\nright: " + bent +
                                 "230, position_m: [0.12, 0, 0], rotation_wxyz: [1, 0, 0, 0]}\n"));
  ASSERT_EQ(check.warnings.size(), 2u);
  EXPECT_THAT(check.warnings[0], HasSubstr("left: "));
  EXPECT_THAT(check.warnings[0], HasSubstr(" % of the pixels have no ray ("));
  EXPECT_THAT(check.warnings[1], HasSubstr("of 307200; none at "));
}

TEST(PixelRays, APointAtAMaskedPixelIsRefusedByItsRow) {
  StereoRig rig;
  rig.left = rig.right = {640, 480,
                          BrownPinhole{.fx = 500, .fy = 500, .cx = 319.5, .cy = 239.5, .k1 = -0.3}};
  PointPixel point;
  point.pixel = {300.0, 200.0};
  PointFrame frame{.name = "", .points = {point}, .rows = {1}};
  EXPECT_NO_THROW(RequirePixelRays({frame}, rig, "p.csv"));
  point.view = 1;
  point.pixel = {2.0, 1.0};
  frame.points.push_back(point);
  frame.rows.push_back(2);
  try {
    RequirePixelRays({frame}, rig, "p.csv");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("p.csv: row 2: expected a pixel to which the right camera's "
                          "lens gives a ray, found '2 1'"));
  }
}

}  // namespace
}  // namespace dockyard
