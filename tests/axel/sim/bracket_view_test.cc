// Rendered pictures of a board half in sun and half in deep shade: the cameras' own exposure does
// not hold it, the merged ones do. And which scenarios may ask for a bracket.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "controller/axel/nominal/motors.h"
#include "controller/vision/board/exposure_merge.h"
#include "controller/vision/board/locate.h"
#include "models/read/config_error.h"
#include "sim/axel/axel_plant.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/axel/load_models.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/renderer.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

Scenario TypicalScenario(const std::vector<std::string>& sets) {
  static const std::vector<KnownSystem> known{{.name = "axel",
                                               .controllers = {"dockyard", "tsai2013", "reel_only"},
                                               .file_keys = {"station"}}};
  return LoadScenario(SourceFile("scenarios/axel_typical.yaml"), sets, known);
}

BuiltRun Build(const Scenario& scenario) { return BuildRun(scenario, LoadModels(scenario)); }

/// Sun on the one half of the board; the other half has that share of its light.
struct HalfShade {
  BuiltRun run = Build(TypicalScenario({"start.r_m=2.5", "start.alpha_deg=0", "seed=3"}));
  Truth truth = World(run.world).truth();
  Scene scene;
  StereoRig rig = run.built_rig;
  std::array<RadianceImage, 2> light;
  Pose3 X_RB;

  explicit HalfShade(double share) {
    run.lighting = {};
    SunAndSky& sun = run.lighting.sun_and_sky;
    // From ahead of the board and above, so that the board's white has 0.65 of the sun's light.
    sun.to_sun_W = Eigen::Vector3d(std::cos(0.7), 0.0, std::sin(0.7));
    sun.sun_irradiance = 1.0;
    const World world(run.world);
    SceneBuilder builder(run.world.rover, run.world.station, run.world.soil, run.lighting,
                         SiteInWorld(run.world.X_WG, run.world.slope), 3);
    scene = builder.Make(truth, world.ground());
    X_RB = Inverse(truth.X_WR) * scene.boards[0].X_WB;
    const auto renderer = MakeRenderer();
    light = renderer->RenderRadiance(scene, rig, truth.X_WR);
    Shade(share);
  }
  /// A shadow's edge falls along the board's upright middle; all on its left lies in shade.
  void Shade(double share) {
    for (std::size_t view = 0; view < 2; ++view) {
      const Camera& camera = view == 0 ? rig.left : rig.right;
      const Pose3 X_CB = Inverse(view == 0 ? rig.X_RL : rig.X_RQ) * X_RB;
      const double edge = camera.Project(X_CB.p).value().x();
      for (int y = 0; y < light[view].height; ++y) {
        for (int x = 0; x < light[view].width; ++x) {
          // Half a penumbra wide: two pixels.
          const double lit = std::clamp(0.5 + 0.5 * (x - edge), 0.0, 1.0);
          light[view].values[static_cast<std::size_t>(y * light[view].width + x)] *=
              static_cast<float>(share + (1.0 - share) * lit);
        }
      }
    }
  }
  StereoImages Exposed(double stops, int index) const {
    SensorOptions sensor = CameraSensor(run.world.rover.stereo, 3, index);
    sensor.exposure_stops += stops;
    return ExposeStereo(light, rig, sensor);
  }
  LocateOutput Locate(StereoImages images, bool both) const {
    if (!both) images.right.pixels.assign(images.right.pixels.size(), 0);
    LocateHints hints;
    hints.up_R = truth.X_WR.R.transpose() * Eigen::Vector3d::UnitZ();
    return LocateBoard(images, run.nominal.rig, run.nominal.board, hints, run.nominal.vision);
  }
  StereoImages Merged(double stops) const {
    const StereoImages a = Exposed(0.0, 0), b = Exposed(-stops, 1), c = Exposed(stops, 2);
    return {MergeExposures({{a.left, 0.0}, {b.left, -stops}, {c.left, stops}}),
            MergeExposures({{a.right, 0.0}, {b.right, -stops}, {c.right, stops}})};
  }
};

// By one camera, which needs five marks; four lie in the sun. A longer exposure alone shows all
// eight too: the merge does so without the knowledge which one is right.
TEST(BracketView, MergeHoldsABoardForOneCameraThatItsOwnExposureDoesNot) {
  const HalfShade half(1.0 / 300.0);
  for (const double stops : {0.0, -2.0}) {
    const LocateOutput seen = half.Locate(half.Exposed(stops, 1), false);
    EXPECT_FALSE(seen.sighting) << stops;
    EXPECT_EQ(seen.report.DetectedBy(0), 4) << stops;
  }
  const LocateOutput seen = half.Locate(half.Merged(2.0), false);
  ASSERT_TRUE(seen.sighting) << seen.report.reason;
  EXPECT_EQ(seen.report.DetectedBy(0), 8);
  EXPECT_LT((seen.sighting->X_RB.p - half.X_RB.p).norm(), 0.03);
}

TEST(BracketView, MergedPairIsMeasuredAsWellAsAPairInEvenLight) {
  const HalfShade half(1.0 / 60.0), even(1.0);
  const LocateOutput merged = half.Locate(half.Merged(2.0), true);
  const LocateOutput plain = even.Locate(even.Exposed(0.0, 0), true);
  ASSERT_TRUE(merged.sighting && merged.sighting->stereo);
  ASSERT_TRUE(plain.sighting && plain.sighting->stereo);
  EXPECT_GE(merged.report.DetectedBy(0) + merged.report.DetectedBy(1), 14);
  EXPECT_LT((merged.sighting->X_RB.p - half.X_RB.p).norm(),
            (plain.sighting->X_RB.p - half.X_RB.p).norm() + 0.02);
}

TEST(BracketView, StopsAskedForScaleTheLight) {
  const Scenario scenario = TypicalScenario({"start.r_m=2.5", "light=even"});
  const auto mean = [&](double stops) {
    AxelPlant plant(scenario, Build(scenario), std::make_shared<KeptRenderer>());
    const std::vector<CameraImage> images = plant.TakeImages({kLeftCamera}, stops);
    const GrayImage& image = std::get<GrayImage>(images.at(0).pixels);
    double sum = 0.0;
    for (const std::uint8_t pixel : image.pixels) sum += pixel;
    return sum / static_cast<double>(image.pixels.size());
  };
  const double own = mean(0.0);
  EXPECT_NEAR(mean(-2.0), 0.25 * own, 0.02 * own);
  EXPECT_NEAR(mean(-1.0), 0.5 * own, 0.02 * own);
  EXPECT_GT(mean(1.0), 1.6 * own);  // its brightest saturate
}

TEST(BracketKeys, ABracketThatCannotBeOfUseIsRefusedByPlace) {
  const auto error = [](const std::vector<std::string>& keys) {
    try {
      Build(TypicalScenario(keys));
    } catch (const ConfigError& refused) {
      return std::string(refused.what());
    }
    return std::string("accepted");
  };
  const std::string bracket = "axel.vision.bracket_stops=2";
  EXPECT_EQ(error({bracket}), "accepted");
  EXPECT_NE(error({bracket, "axel.vision.pipeline=tsai2013"}).find("expected 0 beside"),
            std::string::npos);
  EXPECT_NE(error({bracket, "controller=tsai2013"}).find("expected 0 beside controller tsai2013"),
            std::string::npos);
  EXPECT_NE(error({bracket, "as_built.robot.cameras.sensor.exposure={rule: bracketed}"})
                .find("expected 0 beside the robot's cameras.sensor.exposure.rule bracketed"),
            std::string::npos);
  EXPECT_EQ(error({"axel.vision.bracket_stops=0", "axel.vision.pipeline=tsai2013"}), "accepted");
}

TEST(BracketKeys, NoneIsTakenWhereItCannotBeOfUse) {
  const auto stops = [](const std::vector<std::string>& keys) {
    return Build(TypicalScenario(keys)).nominal.vision.bracket_stops;
  };
  EXPECT_EQ(stops({}), 2.0);
  EXPECT_EQ(stops({"axel.vision.bracket_stops=3"}), 3.0);
  EXPECT_EQ(stops({"axel.vision.bracket_stops=0"}), 0.0);
  EXPECT_EQ(stops({"axel.vision.pipeline=tsai2013"}), 0.0);
  EXPECT_EQ(stops({"controller=tsai2013"}), 0.0);
  EXPECT_EQ(stops({"changes.robot.cameras.sensor.exposure={rule: bracketed}"}), 0.0);
}

}  // namespace
}  // namespace dockyard::axel
