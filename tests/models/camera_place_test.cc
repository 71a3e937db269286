// Our own cameras: the forms in which a file places one, lenses, masked pixels.
#include "models/calibration_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const std::string kTwo = R"(left:
  {model: pinhole, pixel_zero: centre, width_px: 640, height_px: 480, fx_px: 500, fy_px: 500,
   cx_px: 319.5, cy_px: 239.5}
right:
  {model: pinhole, pixel_zero: centre, width_px: 640, height_px: 480, fx_px: 500, fy_px: 500,
   cx_px: 319.5, cy_px: 239.5, position_m: [0.12, 0, 0], PLACE}
)";

using CameraPlace = Calibration;

TEST_F(CameraPlace, MatrixQuaternionAndAnglesSayTheSame) {
  const Eigen::Matrix3d R = RotX(0.1) * RotY(-0.2) * RotZ(0.05);
  const Eigen::Quaterniond q(R);
  std::string rows;
  for (int i = 0; i < 3; ++i) {
    rows += std::string(i ? ", " : "") + "[" + NumberText(R(i, 0)) + ", " + NumberText(R(i, 1)) +
            ", " + NumberText(R(i, 2)) + "]";
  }
  const auto turn = [&](const std::string& place) {
    return RightInLeft(Rig(Replaced(kTwo, "PLACE", place))).R;
  };
  EXPECT_LT((turn("rotation: [" + rows + "]") - R).norm(), 1e-14);
  const std::string wxyz = NumberText(q.w()) + ", " + NumberText(q.x()) + ", " + NumberText(q.y()) +
                           ", " + NumberText(q.z());
  EXPECT_LT((turn("rotation_wxyz: [" + wxyz + "]") - R).norm(), 1e-14);
  // The camera's own axes, as the angles give them at the edge of their range.
  EXPECT_LT((turn("rotation_wxyz: [1, 0, 0, 0]") - turn("pitch_deg: -90, roll_deg: 90")).norm(),
            1e-15);
}

TEST_F(CameraPlace, FewDigitsAreBroughtToTheNextRotation) {
  const Eigen::Matrix3d R =
      RightInLeft(Rig(Replaced(kTwo, "PLACE",
                               "rotation: [[0.995, -0.0998, 0], [0.0998, 0.995, 0], [0, 0, 1]]")))
          .R;
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_LT((R - RotZ(0.1)).norm(), 1e-4);
  const Eigen::Matrix3d of_q =
      RightInLeft(Rig(Replaced(kTwo, "PLACE", "rotation_wxyz: [1.001, 0.0, 0.0, 0.0501]"))).R;
  EXPECT_LT((of_q.transpose() * of_q - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST_F(CameraPlace, WhatIsNoRotationIsRefused) {
  const auto message = [&](const std::string& place) {
    return RigMessage(Replaced(kTwo, "PLACE", place));
  };
  EXPECT_THAT(message("rotation: [[1, 0, 0], [0, 1, 0], [0, 0, -1]]"),
              HasSubstr("right.rotation: expected a rotation, found a mirrored one"));
  EXPECT_THAT(message("rotation: [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]"), HasSubstr("right angles"));
  EXPECT_THAT(message("rotation: [1, 0, 0]"), HasSubstr("expected a matrix of 3 x 3"));
  EXPECT_THAT(message("rotation_wxyz: [2, 0, 0, 0]"), HasSubstr("found length 2"));
  EXPECT_THAT(message("rotation_wxyz: [1, 0, 0, 0], yaw_deg: 3"),
              HasSubstr("right.yaw_deg: expected no angle next to rotation_wxyz"));
  EXPECT_THAT(message("rotation_wxyz: [1, 0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1]"),
              HasSubstr("expected one of rotation and rotation_wxyz"));
}

TEST_F(Calibration, EachLensHasItsKeys) {
  const auto lens = [&](const std::string& model) {
    return Load("model: " + model +
                "\npixel_zero: centre\nwidth_px: 640\nheight_px: 480\nfx_px: 300\nfy_px: 301\n"
                "cx_px: 320\ncy_px: 240\n")
        .camera.lens;
  };
  EXPECT_EQ(lens("rational\nk1: 1\nk2: 2\nk3: 3\nk4: 4\nk5: 5\nk6: 6\np1: 0.1\np2: 0.2"),
            Lens(RationalPinhole{.fx = 300,
                                 .fy = 301,
                                 .cx = 320,
                                 .cy = 240,
                                 .k = {1, 2, 3, 4, 5, 6},
                                 .p1 = 0.1,
                                 .p2 = 0.2}));
  EXPECT_EQ(
      lens("double_sphere\nxi: 0.1\nalpha: 0.5"),
      Lens(DoubleSphere{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .xi = 0.1, .alpha = 0.5}));
  EXPECT_EQ(lens("eucm\nalpha: 0.5\nbeta: 1.2"),
            Lens(Eucm{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .alpha = 0.5, .beta = 1.2}));
  EXPECT_EQ(lens("omni\nxi: 1.1"),
            Lens(Omni{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .xi = 1.1}));
  EXPECT_EQ(lens("fov\nw_rad: 0.9"),
            Lens(FovPinhole{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .w_rad = 0.9}));
}

// A usual calibration whose polynomial turns back near one corner.
TEST_F(Calibration, CornersWithoutARayAreCountedAndMaskedWhereNothingIsDrawn) {
  const std::string one =
      "{model: brown, pixel_zero: centre, width_px: 320, height_px: 180, fx_px: 216, "
      "fy_px: 215.8, cx_px: 155, cy_px: 96.4, k1: 0.0885, k2: -0.226";
  const std::string file =
      folder_.Write("r.yaml", "left: " + one + "}\nright: " + one +
                                  ", position_m: [0.1, 0, 0], rotation_wxyz: [1, 0, 0, 0]}\n");
  EXPECT_THAT(MessageOf([&] { LoadRig(file); }, folder_), HasSubstr("gives every pixel a ray"));
  const StereoRig rig = LoadRig(file, 0, 0, Rays::kMasked);
  const RaylessPixels rayless = CountRayless(rig.left);
  EXPECT_TRUE(rayless.at);
  long count = 0;
  const auto whole = [&](double u, double v) {
    return rig.left.HasRay({u - 0.5, v - 0.5}) && rig.left.HasRay({u - 0.5, v + 0.5}) &&
           rig.left.HasRay({u + 0.5, v - 0.5}) && rig.left.HasRay({u + 0.5, v + 0.5});
  };
  for (int v = 0; v < 180; ++v) {
    for (int u = 0; u < 320; ++u) count += !whole(u, v);
  }
  EXPECT_GT(count, 0);
  EXPECT_EQ(rayless.count, count);
}

}  // namespace
}  // namespace dockyard
