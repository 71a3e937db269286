// Calibrations of OpenCV's FileStorage, YAML and XML.
#include <opencv2/core/persistence.hpp>

#include "models/calibration_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

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
              HasSubstr("b.yml: expected the place of the right camera"));
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

}  // namespace
}  // namespace dockyard
