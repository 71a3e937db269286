// Keys of the cameras' faults: what good values become and how bad ones are reported.
#include <gmock/gmock.h>

#include "scenario/toy_system.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

class CameraFaultKeys : public testing::Test {
 protected:
  Scenario Loaded(const std::string& lines) const {
    return LoadScenario(folder_.And(lines), {}, systems_);
  }
  std::string Refused(const std::string& lines) const {
    const std::string file = folder_.And(lines);
    return MessageOf([&] { LoadScenario(file, {}, systems_); }, folder_);
  }

  ToyFolder folder_;
  std::vector<KnownSystem> systems_ = ToySystems();
};

TEST_F(CameraFaultKeys, NoneIsTheDefault) {
  const CameraFaults faults = Loaded("").camera_faults;
  EXPECT_EQ(faults.delay_s, 0.0);
  EXPECT_EQ(faults.lost, 0.0);
  EXPECT_FALSE(Spoils(faults.left));
  EXPECT_FALSE(Spoils(faults.right));
}

TEST_F(CameraFaultKeys, EachKeyArrives) {
  const CameraFaults faults =
      Loaded(
          "camera: {delay_s: 0.35, lost: 0.2, pupil_m: 0.001, window_m: 0.03, left: {picture: "
          "dark, cover: 0.5, cover_side_deg: -90}, right: {picture: none, dust: 0.1, "
          "dust_clump_m: 0.0005, dust_scatter: 0.4}}")
          .camera_faults;
  EXPECT_EQ(faults.delay_s, 0.35);
  EXPECT_EQ(faults.lost, 0.2);
  EXPECT_EQ(faults.pupil_m, 0.001);
  EXPECT_EQ(faults.window_m, 0.03);
  EXPECT_EQ(faults.left.picture, EyeFaults::Picture::kDark);
  EXPECT_EQ(faults.left.cover_share, 0.5);
  EXPECT_EQ(faults.left.cover_side_rad, Radians(-90.0));
  EXPECT_EQ(faults.right.picture, EyeFaults::Picture::kNone);
  EXPECT_EQ(faults.right.dust_share, 0.1);
  EXPECT_EQ(faults.right.dust_clump_m, 0.0005);
  EXPECT_EQ(faults.right.dust_scatter, 0.4);
}

TEST_F(CameraFaultKeys, WrittenOnesReadBack) {
  const std::string lines =
      "camera: {delay_s: 0.35, lost: 0.2, left: {cover: 0.5, cover_side_deg: 33}, right: {dust: "
      "0.1, picture: dark}}";
  const std::string written = ResolvedYaml(Loaded(lines));
  const std::string file = folder_.Write("scenarios/written.yaml", written);
  EXPECT_EQ(ResolvedYaml(LoadScenario(file, {}, systems_)), written);
}

TEST_F(CameraFaultKeys, BadOnesAreReportedByPlace) {
  EXPECT_EQ(Refused("camera: {lost: 1.2}"),
            "scenarios/s.yaml:10:16: camera.lost: expected a number >= 0 and <= 1, found '1.2'");
  EXPECT_EQ(Refused("camera: {delay_s: -0.1}"),
            "scenarios/s.yaml:10:19: camera.delay_s: expected a number >= 0, found '-0.1'");
  EXPECT_EQ(Refused("camera: {left: {cover: 1}}"),
            "scenarios/s.yaml:10:24: camera.left.cover: expected a number >= 0 and <= 0.95, found "
            "'1'");
  EXPECT_EQ(Refused("camera: {right: {dust: much}}"),
            "scenarios/s.yaml:10:24: camera.right.dust: expected a number >= 0, found 'much'");
  EXPECT_EQ(Refused("camera: {right: {picture: black}}"),
            "scenarios/s.yaml:10:27: camera.right.picture: expected one of normal, dark, none, "
            "found 'black'");
  EXPECT_EQ(Refused("camera: {left: {dirt: 0.1}}"),
            "scenarios/s.yaml:10:17: camera.left.dirt: unknown key, did you mean 'dust'?");
}

TEST_F(CameraFaultKeys, SystemThatDrawsNoneRefusesThem) {
  systems_.front().spoiled_pictures = false;
  EXPECT_EQ(Refused("camera: {left: {dust: 0.1}}"),
            "scenarios/s.yaml:10:16: camera.left: expected no such faults, as the system toy draws "
            "none, found a mapping");
  EXPECT_EQ(Loaded("camera: {delay_s: 0.1, left: {dust: 0}}").camera_faults.delay_s, 0.1);
}

}  // namespace
}  // namespace dockyard
