#include "models/axel/mating_fit.h"

#include <gmock/gmock.h>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/axel/make_nominal.h"
#include "models/read/yaml_path.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

const std::string kStation = SourceFile("models/axel/station/station.yaml");

RoverModel Rover(const std::string& file = "axel.yaml") {
  return LoadRover(SourceFile("models/axel/" + file), 640, 480);
}

/// The station that docks this rover, with one key on top.
StationModel StationFor(const RoverModel& rover, const std::string& set = {}) {
  YamlNode told = ParseYaml("{}", "test");
  if (!set.empty()) SetYaml(told, set);
  return LoadStation(kStation, {&told, nullptr}, nullptr, &rover);
}

/// The rover with wheels of this rim.
RoverModel WithRim(double radius_m) {
  RoverModel rover = Rover();
  rover.left_wheel_soil.rim_radius_m = rover.right_wheel_soil.rim_radius_m = radius_m;
  return rover;
}

TEST(MatingFit, SeatedArmStandsStraightAtTheFittingHeight) {
  const RoverModel rover = Rover();
  StationModel station = StationFor(rover);
  for (double axle_m : {0.24, 0.27, 0.33}) {
    station.mouth_height_m = FittingMouthHeight(rover, axle_m, station.cone, station.tip_angle_rad);
    EXPECT_NEAR(SeatedElevation(rover, axle_m, station), 0.0, 1e-12);
    // A centimetre of axle is a hundredth of the arm of 1 m.
    EXPECT_NEAR(SeatedElevation(rover, axle_m + 0.01, station), -0.01, 1e-4);
  }
}

TEST(MatingFit, PlayTakesBothSoilsAPaddleAndADegreeOfYaw) {
  const RoverModel rover = Rover();
  const StationModel station = StationFor(rover);
  // Axle heights as it is reeled in: docs/reference/physics.md#how-the-arm-mates
  const double vertical_rad = std::max(std::abs(SeatedElevation(rover, 0.257, station)),
                                       std::abs(SeatedElevation(rover, 0.290, station)));
  EXPECT_LT(std::hypot(vertical_rad, Radians(1.0)), SeatedPlay(rover, station.cone));
}

TEST(MatingFit, FormerPartsHaveHalfThePlayAndTheirFloorIsFartherThanWhatIsReeledIn) {
  const RoverModel former = Rover("axel_former_mating.yaml");
  const StationModel station =
      LoadStation(SourceFile("models/axel/station/station_former_mating.yaml"));
  EXPECT_LT(SeatedPlay(former, station.cone), 0.55 * SeatedPlay(Rover(), StationFor(former).cone));
  EXPECT_GT(SeatDepth(station.cone), 0.25);
  EXPECT_LE(SeatDepth(StationFor(former).cone), 0.25 - 0.015);
}

// The controller's numbers are for the rover of Nominal's defaults (options_for.h).
TEST(MakeNominal, AxelIsTheRoverOfTheDefaults) {
  const Nominal axel = MakeNominal(Rover(), StationFor(Rover())), defaults;
  EXPECT_EQ(axel.rover_mass_kg, defaults.rover_mass_kg);
  EXPECT_DOUBLE_EQ(axel.wheel_radius_m, defaults.wheel_radius_m);
  // A level arm of 4 kg, 0.5 m long to its middle, and a body of 24 kg, 0.04 m behind the axle.
  EXPECT_NEAR(axel.arm_down_nm, 9.81 * (4.0 * 0.5 - 24.0 * 0.04), 1e-9);
  EXPECT_NEAR(axel.arm_down_nm, defaults.arm_down_nm, 0.005);
  EXPECT_NEAR(axel.seated_play_rad, defaults.seated_play_rad, 1e-5);
}

TEST(MatingFit, MouthFollowsTheAxle) {
  const double usual_m = StationFor(Rover()).mouth_height_m;
  EXPECT_NEAR(StationFor(WithRim(0.285)).mouth_height_m, usual_m + 0.02, 1e-9);
  EXPECT_NEAR(StationFor(Rover(), "tip_angle_deg=0").mouth_height_m, MeanAxleHeight(Rover()), 1e-4);
}

TEST(MatingFit, ANumberForTheMouthStandsWhateverTheRover) {
  EXPECT_EQ(StationFor(WithRim(0.285), "mouth_height_m=0.36").mouth_height_m, 0.36);
}

TEST(MatingFit, AWordForTheMouthThatIsNoneIsRefused) {
  const ScratchFolder folder;
  EXPECT_THAT(MessageOf([] { StationFor(Rover(), "mouth_height_m=high"); }, folder),
              HasSubstr("mouth_height_m: expected a number > 0"));
}

}  // namespace
}  // namespace dockyard::axel
