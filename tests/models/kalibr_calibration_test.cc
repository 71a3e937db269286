// Calibrations of Kalibr: chains of cameras.
#include "models/calibration_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const std::string kKalibr = R"(cam0:
  cam_overlaps: [1]
  camera_model: pinhole
  distortion_coeffs: [-0.171, 0.094, 0.0012, -0.0007]
  distortion_model: radtan
  intrinsics: [620.5, 621.3, 322.1, 241.7]
  resolution: [640, 480]
  rostopic: /cam0/image_raw
cam1:
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, -0.11]
  - [0.0, 1.0, 0.0, 0.001]
  - [0.0, 0.0, 1.0, 0.002]
  - [0.0, 0.0, 0.0, 1.0]
  cam_overlaps: [0]
  camera_model: pinhole
  distortion_coeffs: [-0.01, 0.02, -0.005, 0.001]
  distortion_model: equidistant
  intrinsics: [620.5, 621.3, 322.1, 241.7]
  resolution: [640, 480]
  rostopic: /cam1/image_raw
  timeshift_cam_imu: 0.0
)";

using KalibrChain = Calibration;

TEST_F(KalibrChain, IsAPairByTheTransformFromTheFirstToTheSecond) {
  const StereoRig rig = Rig(kKalibr);
  EXPECT_LT((*rig.left.Project(p_) - ByOpenCv({-0.171, 0.094, 0.0012, -0.0007}, p_)).norm(), 1e-9);
  EXPECT_TRUE(std::holds_alternative<KannalaBrandt>(rig.right.lens));
  EXPECT_LT((RightInLeft(rig).p - Eigen::Vector3d(0.11, -0.001, -0.002)).norm(), 1e-15);
}

TEST_F(KalibrChain, OfThreeCamerasMultipliesItsTransforms) {
  const Eigen::Matrix3d R = RotY(0.1);
  std::string rows;
  for (int i = 0; i < 3; ++i) {
    rows += "  - [" + NumberText(R(i, 0)) + ", " + NumberText(R(i, 1)) + ", " +
            NumberText(R(i, 2)) + ", -0.2]\n";
  }
  const std::string third =
      "cam2:\n  camera_model: pinhole\n  intrinsics: [600, 600, 320, 240]\n"
      "  distortion_model: none\n  distortion_coeffs: []\n"
      "  resolution: [640, 480]\n  T_cn_cnm1:\n" +
      rows + "  - [0, 0, 0, 1]\n";
  const PlacedCamera placed = Load(kKalibr + third, "cam2");
  const Pose3 X_10{Eigen::Matrix3d::Identity(), {-0.11, 0.001, 0.002}}, X_21{R, {-0.2, -0.2, -0.2}};
  const Pose3 X_02 = Inverse(X_21 * X_10);
  EXPECT_LT((placed.X_FC.R - X_02.R).norm() + (placed.X_FC.p - X_02.p).norm(), 1e-14);
  EXPECT_THAT(RigMessage(kKalibr + third),
              HasSubstr("found a chain of Kalibr with the cameras cam0, "
                        "cam1, cam2"));
  folder_.Write("chain.yaml", kKalibr + third);
  const StereoRig chosen =
      Rig("left: {file: chain.yaml, name: cam0}\n"
          "right: {file: chain.yaml, name: cam2}\n");
  EXPECT_LT((RightInLeft(chosen).p - X_02.p).norm(), 1e-14);
}

TEST_F(KalibrChain, GoesByTheInertialUnitWhereNoCameraLeadsToTheNext) {
  const std::string to_imu0 =
      "  T_cam_imu:\n  - [1, 0, 0, 0.5]\n  - [0, 1, 0, 0]\n"
      "  - [0, 0, 1, 0]\n  - [0, 0, 0, 1]\ncam1:\n  T_cam_imu:\n";
  const StereoRig rig =
      Rig(Replaced(Replaced(kKalibr, "cam1:\n  T_cn_cnm1:\n", to_imu0), "-0.11]", "0.39]"));
  EXPECT_LT((RightInLeft(rig).p - Eigen::Vector3d(0.11, -0.001, -0.002)).norm(), 1e-12);
}

TEST_F(KalibrChain, EachOfItsModelsIsALens) {
  const auto lens = [&](const std::string& model, const std::string& numbers,
                        const std::string& distortion, const std::string& coefficients) {
    return Load("cam0:\n  camera_model: " + model + "\n  intrinsics: [" + numbers +
                "]\n  distortion_model: " + distortion + "\n  distortion_coeffs: [" + coefficients +
                "]\n  resolution: [640, 480]\n")
        .camera.lens;
  };
  EXPECT_EQ(
      lens("ds", "-0.2, 0.6, 300, 301, 320, 240", "none", ""),
      Lens(DoubleSphere{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .xi = -0.2, .alpha = 0.6}));
  EXPECT_EQ(lens("eucm", "0.6, 1.1, 300, 301, 320, 240", "none", ""),
            Lens(Eucm{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .alpha = 0.6, .beta = 1.1}));
  EXPECT_EQ(lens("omni", "1.4, 300, 301, 320, 240", "radtan", "-0.1, 0.01, 0.001, 0.002"),
            Lens(Omni{.fx = 300,
                      .fy = 301,
                      .cx = 320,
                      .cy = 240,
                      .xi = 1.4,
                      .k1 = -0.1,
                      .k2 = 0.01,
                      .p1 = 0.001,
                      .p2 = 0.002}));
  EXPECT_EQ(lens("pinhole", "300, 301, 320, 240", "fov", "0.93"),
            Lens(FovPinhole{.fx = 300, .fy = 301, .cx = 320, .cy = 240, .w_rad = 0.93}));
}

TEST_F(KalibrChain, BadOnesAreNamedByPlaceAndPath) {
  EXPECT_EQ(Message(Replaced(kKalibr, "camera_model: pinhole\n  distortion_coeffs: [-0.171",
                             "camera_model: mei\n  distortion_coeffs: [-0.171")),
            "c.yaml:3:17: cam0.camera_model: expected one of pinhole, omni, ds, eucm, found 'mei'");
  EXPECT_THAT(Message(Replaced(kKalibr, "radtan", "radtan8")),
              HasSubstr("c.yaml:5:21: cam0.distortion_model: expected one of radtan"));
  for (const char* model : {"  distortion_model: none\n", ""}) {
    EXPECT_THAT(Message(Replaced(kKalibr, "  distortion_model: radtan\n", model)),
                HasSubstr("cam0.distortion_coeffs: expected zeros without a distortion_model"));
  }
  EXPECT_THAT(Message(Replaced(kKalibr, "[1.0, 0.0, 0.0, -0.11]", "[-1.0, 0.0, 0.0, -0.11]")),
              HasSubstr("cam1.T_cn_cnm1: expected a rotation, found a mirrored one"));
  EXPECT_THAT(Message(Replaced(kKalibr, "[1.0, 0.0, 0.0, -0.11]", "[1.1, 0.0, 0.0, -0.11]")),
              HasSubstr("cam1.T_cn_cnm1: expected a rotation: columns of length 1"));
  EXPECT_THAT(Message(Replaced(kKalibr, "T_cn_cnm1", "T_c")), HasSubstr("missing key 'T_cn_cnm1'"));
}

}  // namespace
}  // namespace dockyard
