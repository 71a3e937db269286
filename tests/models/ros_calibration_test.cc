// Calibrations of ROS: camera_info as a file and as a message.
#include "models/calibration_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const std::string kRos = R"(image_width: 640
image_height: 480
camera_name: front_left
camera_matrix:
  rows: 3
  cols: 3
  data: [620.5, 0., 322.1, 0., 621.3, 241.7, 0., 0., 1.]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.171, 0.094, 0.0012, -0.0007, 0.0]
rectification_matrix:
  rows: 3
  cols: 3
  data: [1., 0., 0., 0., 1., 0., 0., 0., 1.]
projection_matrix:
  rows: 3
  cols: 4
  data: [600., 0., 320., 0., 0., 600., 240., 0., 0., 0., 1., 0.]
)";

using RosCalibration = Calibration;

TEST_F(RosCalibration, ProjectsAsOpenCvDoesWithItsNumbers) {
  const PlacedCamera placed = Load(kRos);
  EXPECT_EQ(placed.name, "front_left");
  EXPECT_EQ(placed.camera.width, 640);
  EXPECT_LT(
      (*placed.camera.Project(p_) - ByOpenCv({-0.171, 0.094, 0.0012, -0.0007, 0.0}, p_)).norm(),
      1e-9);
}

TEST_F(RosCalibration, CountOfCoefficientsSaysWhichTermsThereAre) {
  const std::string five = "cols: 5\n  data: [-0.171, 0.094, 0.0012, -0.0007, 0.0]";
  const auto pixel = [&](const std::string& instead, const std::string& model) {
    const std::string text = Replaced(Replaced(kRos, five, instead), "plumb_bob", model);
    return *Load(text).camera.Project(p_);
  };
  const std::vector<double> eight{5.1, 3.2, 0.0004, -0.0003, 0.17, 5.4, 4.9, 0.96};
  const std::string of_eight = "5.1, 3.2, 0.0004, -0.0003, 0.17, 5.4, 4.9, 0.96";
  EXPECT_LT(
      (pixel("cols: 8\n  data: [" + of_eight + "]", "rational_polynomial") - ByOpenCv(eight, p_))
          .norm(),
      1e-9);
  EXPECT_LT(
      (pixel("cols: 14\n  data: [" + of_eight + ", 0, 0, 0, 0, 0, 0]", "rational_polynomial") -
       ByOpenCv(eight, p_))
          .norm(),
      1e-9);
  EXPECT_LT((pixel("cols: 4\n  data: [-0.1, 0.02, 0, 0.001]", "plumb_bob") -
             ByOpenCv({-0.1, 0.02, 0, 0.001}, p_))
                .norm(),
            1e-9);
  const Eigen::Vector2d plain(322.1 + 620.5 * 0.3, 241.7 - 621.3 * 0.2);
  EXPECT_LT((pixel("cols: 0\n  data: []", "plumb_bob") - plain).norm(), 1e-12);
  EXPECT_LT((pixel("cols: 5\n  data: [0, 0, 0, 0, 0]", "\"\"") - plain).norm(), 1e-12);
}

TEST_F(RosCalibration, EquidistantIsOpenCvsFisheye) {
  const std::string text =
      Replaced(Replaced(kRos, "cols: 5\n  data: [-0.171, 0.094, 0.0012, -0.0007, 0.0]",
                        "cols: 4\n  data: [-0.01, 0.02, -0.005, 0.001]"),
               "plumb_bob", "equidistant");
  std::vector<cv::Point2d> pixels;
  cv::fisheye::projectPoints(std::vector<cv::Point3d>{{0.3, -0.2, 1.0}}, pixels, cv::Vec3d(),
                             cv::Vec3d(), kK, cv::Vec4d(-0.01, 0.02, -0.005, 0.001));
  const Eigen::Vector2d pixel = *Load(text).camera.Project(p_);
  EXPECT_LT((pixel - Eigen::Vector2d(pixels[0].x, pixels[0].y)).norm(), 1e-9);
}

TEST_F(RosCalibration, ReadsFilesOfWindowsAndEchoedMessages) {
  const Eigen::Vector2d pixel = *Load(kRos).camera.Project(p_);
  std::string crlf = "\xEF\xBB\xBF# of a camera\n" + kRos;
  for (std::size_t at = crlf.find('\n'); at != std::string::npos; at = crlf.find('\n', at + 2)) {
    crlf.insert(at, "\r");
  }
  EXPECT_EQ(*Load(crlf).camera.Project(p_), pixel);
  const std::string echoed =
      "header:\n  seq: 3\n  frame_id: 'left'\nheight: 480\nwidth: 640\n"
      "distortion_model: \"plumb_bob\"\nD: [-0.171, 0.094, 0.0012, -0.0007, 0.0]\n"
      "K: [620.5, 0.0, 322.1, 0.0, 621.3, 241.7, 0.0, 0.0, 1.0]\n"
      "R: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]\n"
      "P: [600, 0.0, 320, 0.0, 0.0, 600, 240, 0.0, 0.0, 0.0, 1.0, 0.0]\nbinning_x: 0\n"
      "binning_y: 0\nroi:\n  x_offset: 0\n  y_offset: 0\n  height: 0\n  width: 0\n"
      "  do_rectify: False\n---\n";
  EXPECT_EQ(*Load(echoed).camera.Project(p_), pixel);
}

TEST_F(RosCalibration, PartAndBinningSayWhichImagesCome) {
  const Camera whole = Load(kRos).camera;
  const Camera part =
      Load(kRos + "roi: {x_offset: 100, y_offset: 40, width: 400, height: 300}\n").camera;
  EXPECT_EQ(part.width, 400);
  EXPECT_LT((*part.Project(p_) - *whole.Project(p_) + Eigen::Vector2d(100, 40)).norm(), 1e-12);
  const Camera binned = Load(kRos + "binning_x: 2\nbinning_y: 2\n").camera;
  EXPECT_EQ(binned, Resized(whole, 320, 240));
}

TEST_F(RosCalibration, TwoFilesAreAPairByTheirRectification) {
  // The right camera 0.12 m to the right, both turned against the rectified images.
  const auto with = [&](const Eigen::Matrix3d& R, double tx) {
    std::string rows;
    for (int i = 0; i < 9; ++i) rows += (i ? ", " : "") + NumberText(R(i / 3, i % 3));
    return Replaced(Replaced(kRos, "[1., 0., 0., 0., 1., 0., 0., 0., 1.]", "[" + rows + "]"),
                    "[600., 0., 320., 0., 0.", "[600., 0., 320., " + NumberText(tx) + ", 0.");
  };
  const Eigen::Matrix3d R_PL = RotX(0.02) * RotZ(-0.01), R_PQ = RotY(0.03);
  const std::string left = folder_.Write("left.yaml", with(R_PL, 0.0)),
                    right = folder_.Write("right.yaml", with(R_PQ, -72.0));
  const std::string rig =
      folder_.Write("rig.yaml", "left: {file: left.yaml}\nright: {file: right.yaml}\n");
  for (const std::string& file : {left + "," + right, folder_.path().string(), rig}) {
    const Pose3 X_LQ = RightInLeft(LoadRig(file));
    EXPECT_LT((X_LQ.R - R_PL.transpose() * R_PQ).norm(), 1e-12);
    EXPECT_LT((X_LQ.p - R_PL.transpose() * Eigen::Vector3d(0.12, 0, 0)).norm(), 1e-12);
  }
  const std::string never =
      folder_.Write("never.yaml", with(Eigen::Matrix3d::Zero(), 0.0));  // rectified
  EXPECT_EQ(LoadCamera(never).camera, LoadCamera(left).camera);
  EXPECT_THAT(MessageOf([&] { LoadRig(left + "," + never); }, folder_),
              HasSubstr("never.yaml: expected a projection_matrix"));
  EXPECT_TRUE(NamesTwoFiles(left + "," + right));
  EXPECT_FALSE(NamesTwoFiles(left));
  EXPECT_THAT(MessageOf([&] { LoadRig(left); }, folder_),
              HasSubstr("expected a pair of cameras, found a camera_info of ROS with one camera"));
}

TEST_F(RosCalibration, BadOnesAreNamedByPlaceAndPath) {
  EXPECT_EQ(Message(Replaced(kRos, "plumb_bob", "thin_prism")),
            "c.yaml:8:19: distortion_model: expected one of plumb_bob, rational_polynomial, "
            "equidistant, fisheye, found 'thin_prism'");
  EXPECT_EQ(Message(Replaced(kRos, "620.5, 0.,", "620.5, 0.3,")),
            "c.yaml:7:17: camera_matrix: expected 0: no lens here has skewed pixels, found '0.3'");
  EXPECT_THAT(Message(Replaced(kRos, "[620.5,", "[0.0,")), HasSubstr("c.yaml:7:10: camera_matrix"));
  EXPECT_THAT(
      Message(Replaced(kRos, "-0.0007, 0.0]", "-0.0007]")),
      HasSubstr("c.yaml:12:9: distortion_coefficients.data: expected 1 x 5 numbers, found 4"));
  EXPECT_THAT(
      Message(Replaced(kRos, "cols: 5\n  data: [-0.171, 0.094, 0.0012, -0.0007, 0.0]",
                       "cols: 12\n  data: [1, 0, 0, 0, 0, 0, 0, 0, 0, 0.01, 0, 0]")),
      HasSubstr("c.yaml:12:37: distortion_coefficients: expected 0: no lens here has terms of "
                "a thin prism"));
  EXPECT_THAT(Message(Replaced(kRos, "image_width: 640\n", "")),
              HasSubstr("missing key 'image_width'"));
}

}  // namespace
}  // namespace dockyard
