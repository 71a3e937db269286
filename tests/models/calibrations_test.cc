// Calibrations of ROS, Kalibr and OpenCV, and the forms in which a file places a camera.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/persistence.hpp>

#include "controller/base/number_text.h"
#include "models/read/load_cameras.h"
#include "support/bad_files.h"

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

const cv::Matx33d kK(620.5, 0, 322.1, 0, 621.3, 241.7, 0, 0, 1);

Eigen::Vector2d ByOpenCv(const std::vector<double>& d, const Eigen::Vector3d& p) {
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(), cv::Vec3d(), kK,
                    d, pixels);
  return {pixels[0].x, pixels[0].y};
}

class Calibration : public testing::Test {
 protected:
  PlacedCamera Load(const std::string& text, const std::string& name = {}) const {
    return LoadCamera(folder_.Write("c.yaml", text), name);
  }
  std::string Message(const std::string& text) const {
    const std::string file = folder_.Write("c.yaml", text);
    return MessageOf([&] { LoadCamera(file); }, folder_);
  }
  std::string RigMessage(const std::string& text) const {
    const std::string file = folder_.Write("r.yaml", text);
    return MessageOf([&] { LoadRig(file); }, folder_);
  }
  StereoRig Rig(const std::string& text) const { return LoadRig(folder_.Write("r.yaml", text)); }

  ScratchFolder folder_;
  const Eigen::Vector3d p_{0.3, -0.2, 1.0};
};

/// Where the right camera stands in the left one.
Pose3 RightInLeft(const StereoRig& rig) { return Inverse(rig.X_RL) * rig.X_RQ; }

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
  EXPECT_THAT(Message(Replaced(kKalibr, "[1.0, 0.0, 0.0, -0.11]", "[-1.0, 0.0, 0.0, -0.11]")),
              HasSubstr("cam1.T_cn_cnm1: expected a rotation, found a mirrored one"));
  EXPECT_THAT(Message(Replaced(kKalibr, "[1.0, 0.0, 0.0, -0.11]", "[1.1, 0.0, 0.0, -0.11]")),
              HasSubstr("cam1.T_cn_cnm1: expected a rotation: columns of length 1"));
  EXPECT_THAT(Message(Replaced(kKalibr, "T_cn_cnm1", "T_c")), HasSubstr("missing key 'T_cn_cnm1'"));
}

using OpenCvStorage = Calibration;

/// Written by OpenCV itself.
std::string ByFileStorage(const char* name, bool pair) {
  cv::FileStorage out(name, cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  const cv::Mat d = (cv::Mat_<double>(1, 5) << -0.171, 0.094, 0.0012, -0.0007, 0.01);
  out << "calibration_time"
      << "Thu 05 Mar 2026 10:41:13";
  if (!pair) {
    out << "image_width" << 640 << "image_height" << 480 << "flags" << 4;
    out << "camera_matrix" << cv::Mat(kK) << "distortion_coefficients" << d;
  } else {
    cv::Mat R;
    cv::Rodrigues(cv::Vec3d(0.01, 0.02, -0.03), R);
    out << "imageSize" << cv::Size(640, 480);
    out << "M1" << cv::Mat(kK) << "D1" << d << "M2" << cv::Mat(kK) << "D2" << d;
    out << "R" << R << "T" << (cv::Mat_<double>(3, 1) << -0.12, 0.001, 0.002);
  }
  return out.releaseAndGetString();
}

TEST_F(OpenCvStorage, ReadsBackWhatOpenCvWrites) {
  const Eigen::Vector2d wanted = ByOpenCv({-0.171, 0.094, 0.0012, -0.0007, 0.01}, p_);
  for (const char* name : {"x.yml", "x.xml", "x.json"}) {
    const std::string file = folder_.Write(name, ByFileStorage(name, false));
    EXPECT_LT((*LoadCamera(file).camera.Project(p_) - wanted).norm(), 1e-9) << name;
    const StereoRig rig = LoadRig(folder_.Write(name, ByFileStorage(name, true)));
    const Pose3 X_QL = Inverse(RightInLeft(rig));
    cv::Matx33d R;
    cv::Rodrigues(cv::Vec3d(0.01, 0.02, -0.03), R);
    EXPECT_NEAR(X_QL.R(0, 1), R(0, 1), 1e-12);
    EXPECT_NEAR(X_QL.R(2, 0), R(2, 0), 1e-12);
    EXPECT_LT((X_QL.p - Eigen::Vector3d(-0.12, 0.001, 0.002)).norm(), 1e-12);
  }
}

TEST_F(OpenCvStorage, IntrinsicsAndExtrinsicsMayBeTwoFiles) {
  const std::string whole = ByFileStorage("x.yml", true);
  const std::size_t at = whole.find("\nR: ") + 1;
  const std::string intrinsics = folder_.Write("intrinsics.yml", whole.substr(0, at)),
                    extrinsics =
                        folder_.Write("extrinsics.yml", "%YAML:1.0\n---\n" + whole.substr(at));
  EXPECT_NEAR(LoadRig(intrinsics + "," + extrinsics).baseline_m(), std::hypot(0.12, 0.001, 0.002),
              1e-12);
  EXPECT_THAT(MessageOf([&] { LoadRig(intrinsics); }, folder_), HasSubstr("missing key 'R'"));
}

TEST_F(OpenCvStorage, TwoFilesWithoutAPlaceArePlacedByARig) {
  const std::string text = ByFileStorage("x.yml", false);
  const std::string left = folder_.Write("a.yml", text), right = folder_.Write("b.yml", text);
  EXPECT_THAT(MessageOf([&] { LoadRig(left + "," + right); }, folder_),
              HasSubstr("b.yml: expected where the right camera stands"));
  const StereoRig rig =
      Rig("left: {file: a.yml}\nright: {file: b.yml, position_m: [0.1, 0, 0], "
          "rotation_wxyz: [1, 0, 0, 0]}\n");
  EXPECT_EQ(RightInLeft(rig).p, Eigen::Vector3d(0.1, 0, 0));
}

TEST_F(OpenCvStorage, BadXmlIsNamedByPlace) {
  const std::string good = ByFileStorage("x.xml", false);
  const auto message = [&](const std::string& from, const std::string& to) {
    const std::string file = folder_.Write("c.xml", Replaced(good, from, to));
    return MessageOf([&] { LoadCamera(file); }, folder_);
  };
  EXPECT_THAT(message("<image_width>640", "<image_width>6x0"),
              HasSubstr("c.xml:4:14: image_width: expected a whole number"));
  EXPECT_THAT(message("</image_width>", "</image_with>"), HasSubstr("expected </image_width>"));
  EXPECT_THAT(message("<rows>3</rows>", "<rows>2</rows>"),
              HasSubstr("camera_matrix.data: expected"));
  EXPECT_EQ(message(good, "<robot><a>1</a></robot>"),
            "c.xml:1:1: expected OpenCV's <opencv_storage>, found <robot>");
}

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
              HasSubstr("right.yaw_deg: expected no angle beside rotation_wxyz"));
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
