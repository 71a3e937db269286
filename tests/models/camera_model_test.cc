// A single camera's mapping: its lens, its place on the link, its sensor.
#include <gmock/gmock.h>

#include <cmath>

#include "models/read/load_camera_model.h"
#include "models/read/load_cameras.h"
#include "models/read/yaml_tree.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const std::string kStart = "{name: front, link: head, ";
const std::string kPinhole = "field_of_view_deg: 70, width_px: 640, height_px: 480";

CameraModel ModelOf(const std::string& keys) {
  const YamlNode root = ParseYaml("camera: " + kStart + keys + "}", "r.yaml");
  CameraFile file;
  ReadKeys(*root.Find("camera"), "camera", [&](Keys& in) { VisitCamera(in, file); });
  return CameraOf(file);
}

TEST(CameraModel, PinholeSpreadsItsFieldOverTheWidth) {
  const Camera camera = ModelOf(kPinhole).nominal;
  const double half = std::tan(Radians(35.0));
  for (const double side : {-1.0, 1.0}) {
    const auto pixel = camera.Project({side * half, 0.2, 1.0});
    EXPECT_NEAR(pixel->x(), 319.5 + side * 320.0, 1e-9);
    EXPECT_NEAR(pixel->y(), 239.5 + 0.2 / half * 320.0, 1e-9);
  }
}

TEST(CameraModel, WiderFieldBelongsToTheEquidistantLens) {
  const Camera camera = ModelOf("field_of_view_deg: 120, width_px: 640, height_px: 240").nominal;
  for (const double off_deg : {10.0, 30.0, 60.0}) {
    const double off = Radians(off_deg);
    EXPECT_NEAR(camera.Project({std::sin(off), 0.0, std::cos(off)})->x(),
                319.5 + 640.0 * off_deg / 120.0, 1e-9);
  }
}

TEST(CameraModel, FacesAlongTheLinksXAxisOrAlongItsZAxisIfTheLinkIsOptical) {
  const std::string place = ", x_m: 0.1, y_m: 0.2, z_m: 0.3";
  const Pose3 ahead = ModelOf(kPinhole + place).X_LC;
  EXPECT_EQ(ahead.p, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(ahead.R * Eigen::Vector3d::UnitZ(), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(ahead.R * Eigen::Vector3d::UnitX(), Eigen::Vector3d(0, -1, 0));
  EXPECT_TRUE(ModelOf(kPinhole + ", link_axes: optical").X_LC.R.isIdentity(0.0));
  // Nose-down is positive; counter-clockwise from above.
  const Pose3 down = ModelOf(kPinhole + ", pitch_deg: 90").X_LC;
  EXPECT_TRUE((down.R * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d(0, 0, -1), 1e-12));
  const Pose3 left = ModelOf(kPinhole + ", yaw_deg: 90").X_LC;
  EXPECT_TRUE((left.R * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d(0, 1, 0), 1e-12));
}

TEST(CameraModel, TakesTheLensOfAnyCalibrationAtAnySizeOfItsShape) {
  const ScratchFolder folder;
  const std::string file =
      folder.Write("lens.yaml",
                   "image_width: 640\nimage_height: 480\ncamera_name: front\n"
                   "camera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 501, 240, 0, 0, 1]}\n"
                   "distortion_model: plumb_bob\n"
                   "distortion_coefficients: {rows: 1, cols: 5, data: [-0.2, 0.05, 0, 0, 0]}\n"
                   "rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}\n"
                   "projection_matrix: {rows: 3, cols: 4, data: [500, 0, 320, 0, 0, 501, 240, 0, "
                   "0, 0, 1, 0]}\n");
  const Camera whole = ModelOf("file: " + file).nominal;
  EXPECT_EQ(whole, LoadCamera(file).camera);
  const Camera half = ModelOf("file: " + file + ", width_px: 320, height_px: 240").nominal;
  EXPECT_EQ(half, Resized(whole, 320, 240));
  const std::string pair = SourceFile("models/cameras/axel_640.yaml");
  EXPECT_EQ(ModelOf("file: " + pair + ", file_camera: right").nominal,
            LoadCamera(pair, "right").camera);
}

TEST(CameraModel, HasASensorOfItsOwnUnlessTheFileStatesOne) {
  const CameraModel plain = ModelOf(kPinhole);
  EXPECT_GT(plain.sensor.full_well_e, 0.0);
  EXPECT_GT(plain.errors.rotation_sigma_rad, 0.0);
  EXPECT_EQ(plain.period_s, 0.1);
  const CameraModel stated = ModelOf(
      kPinhole +
      ", rate_hz: 25, latency_s: 0.03, sensor: {read_noise_e: 4, exposure: {rule: fixed, fixed_e: "
      "9000}}, as_built: {rotation_deg: 0, place_m: 0.002, centre_px: 3}");
  EXPECT_EQ(stated.sensor.read_noise_e, 4.0);
  EXPECT_EQ(stated.sensor.full_well_e, plain.sensor.full_well_e);
  EXPECT_EQ(stated.sensor.exposure.fixed_e, 9000.0);
  EXPECT_EQ(stated.errors.rotation_sigma_rad, 0.0);
  EXPECT_EQ(stated.errors.place_sigma_m, 0.002);
  EXPECT_EQ(stated.errors.lens.centre_sigma_px, 3.0);
  EXPECT_EQ(stated.errors.lens.focal_sigma, plain.errors.lens.focal_sigma);
  EXPECT_EQ(stated.period_s, 0.04);
  EXPECT_EQ(stated.latency_s, 0.03);
}

TEST(CameraModel, HasNoFrameGrabberUnlessTheFileStatesOne) {
  const VideoModel none = ModelOf(kPinhole).sensor.video;
  EXPECT_EQ(none.noise_share, 0.0);
  EXPECT_EQ(none.line_jitter_px, 0.0);
  EXPECT_EQ(none.fields, VideoFields::kProgressive);
  const VideoModel video = ModelOf(kPinhole +
                                   ", sensor: {video: {noise_share: 0.007, line_jitter_px: 0.2, "
                                   "fields: interlaced}}")
                               .sensor.video;
  EXPECT_EQ(video.noise_share, 0.007);
  EXPECT_EQ(video.line_jitter_px, 0.2);
  EXPECT_EQ(video.fields, VideoFields::kInterlaced);
}

TEST(CameraModel, BadKeysAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const std::string pair = SourceFile("models/cameras/axel_640.yaml");
  const struct {
    std::string keys, message;
  } cases[] = {
      {"width_px: 640, height_px: 480", "missing key 'field_of_view_deg'"},
      {"field_of_view_deg: 70, height_px: 480", "missing key 'width_px'"},
      {"file: " + pair + ", field_of_view_deg: 70", "no such key next to file"},
      {"file: " + pair, "expected the name of one of its cameras"},
      {"file: " + pair + ", file_camera: left, width_px: 640, height_px: 640", "shape"},
      {kPinhole + ", file_camera: left", "a file next to it"},
      {kPinhole + ", rate_hz: 0", "rate_hz"},
      {kPinhole + ", link_axes: sideways", "expected one of forward, optical"},
      {kPinhole + ", colour: true, sensor: {bits: 12}", "no such key of a colour camera"},
      {kPinhole + ", colour: true, sensor: {blur_sigma_px: 2}", "at most 1.5"},
      {kPinhole + ", sensor: {exposure: {rule: fixed}}", "missing key 'fixed_e'"},
      {kPinhole + ", sensor: {gain: 2}", "gain"},
      {kPinhole + ", colour: true, sensor: {video: {noise_share: 0.01}}",
       "no such key of a colour camera"},
      {kPinhole + ", sensor: {video: {noise_share: 0.3}}", ">= 0 and <= 0.2"},
      {kPinhole + ", sensor: {video: {line_jitter_px: 6}}", ">= 0 and <= 5"},
      {kPinhole + ", sensor: {video: {fields: odd}}", "expected one of progressive, interlaced"},
      {kPinhole + ", sensor: {shutter_s: 0.02, video: {fields: interlaced}}",
       "a shutter_s up to 1/60"},
  };
  for (const auto& each : cases) {
    EXPECT_THAT(MessageOf([&] { ModelOf(each.keys); }, folder), HasSubstr(each.message))
        << each.keys;
  }
}

}  // namespace
}  // namespace dockyard
