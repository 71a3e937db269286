// The built cameras: the nominal ones with the workshop's errors, whatever their lenses.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "axel/sim/scenarios.h"
#include "models/axel/make_nominal.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/plant/built_cameras.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

const std::string kSource = SourceDir();
constexpr int kSeeds = 2000;

/// Root mean square of what `of` measures on the rigs of many runs.
template <typename F>
double Rms(const StereoModel& stereo, F of) {
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const double value = of(BuiltRig(stereo, static_cast<std::uint64_t>(seed)));
    sum += value * value;
  }
  return std::sqrt(sum / kSeeds);
}

class BuiltRigs : public testing::TestWithParam<std::string> {
 protected:
  BuiltRigs() {
    Scenario scenario = TypicalScenario();
    if (!GetParam().empty()) {
      scenario = TypicalScenario({"camera.file=" + kSource + "/models/cameras/" + GetParam()});
    }
    stereo_ = LoadModels(scenario).built.rover.stereo;
  }
  StereoModel stereo_;
};

// 2 000 draws tell a sigma within 1.6 % (1 sigma); four of them.
constexpr double kShare = 0.065;

TEST(Start, InsideTheStationIsRefusedAndBesideItIsNot) {
  const auto check = [](const std::string& start) {
    const BuiltRun run = Build(TypicalScenario({"start=" + start}));
    CheckStart(run, World(run.world).truth());
  };
  EXPECT_NO_THROW(check("{r_m: 1.2, alpha_deg: 0, heading_deg: 0}"));
  EXPECT_NO_THROW(check("{r_m: 1.0, alpha_deg: 0, heading_deg: 0}"));  // the tip in the mouth
  try {
    check("{r_m: 0.65, alpha_deg: 0, heading_deg: 0}");
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what())
                  .rfind("--set start={r_m: 0.65, alpha_deg: 0, heading_deg: "
                         "0}: start: expected a rover clear of the station",
                         0),
              0u)
        << error.what();
  }
}

TEST(Start, RoverThatRollsOffAPaddleFarFromTheStationIsNotRefused) {
  const BuiltRun run = Build(TypicalScenario({"start={r_m: 3, alpha_deg: 0, heading_deg: 0}"}));
  Truth settled;
  settled.X_DR = FromGround(run.world.X_DR_start, 0.0);
  settled.X_DR.p.x() += 0.07;
  EXPECT_NO_THROW(CheckStart(run, settled));
}

TEST(Start, ImagesWiderThanCanBeDrawnAreRefused) {
  try {
    Build(TypicalScenario({"camera={width_px: 1200, height_px: 1400}"}));
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find(": camera: expected all pixels within 65 deg"),
              std::string::npos)
        << error.what();
  }
}

TEST_P(BuiltRigs, TurnAgainstEachOtherAsTheModelSays) {
  const StereoRig& nominal = stereo_.nominal;
  const double yaw = Rms(stereo_, [&](const StereoRig& built) {
    // Yaw of the built right camera in the built left one, less the nominal.
    const auto relative = [](const StereoRig& rig) {
      const Eigen::Vector3d z = (rig.X_RL.R.transpose() * rig.X_RQ.R).col(2);
      return std::atan2(z.x(), z.z());
    };
    return relative(built) - relative(nominal);
  });
  EXPECT_NEAR(yaw / stereo_.relative_yaw_sigma_rad, 1.0, kShare);
}

TEST_P(BuiltRigs, HaveOtherFocalLengthsAndCentres) {
  const Camera& nominal = stereo_.nominal.right;
  const double focal = Rms(stereo_, [&](const StereoRig& built) {
    return built.right.focal_px().x() / nominal.focal_px().x() - 1.0;
  });
  EXPECT_NEAR(focal / stereo_.lens.focal_sigma, 1.0, kShare);
  const double centre = Rms(stereo_, [&](const StereoRig& built) {
    return built.right.centre_px().x() - nominal.centre_px().x();
  });
  EXPECT_NEAR(centre / stereo_.lens.centre_sigma_px, 1.0, kShare);
}

TEST_P(BuiltRigs, BendTheLensByTheirRadialTerm) {
  StereoModel only = stereo_;
  only.lens.focal_sigma = only.lens.centre_sigma_px = 0.0;
  const Camera& nominal = stereo_.nominal.left;
  const Eigen::Vector2d edge = nominal.centre_px() - Eigen::Vector2d(0.5 * nominal.width, 0.0);
  const LensRay ray = nominal.Ray(edge);
  const double bend = Rms(only, [&](const StereoRig& built) {
    return (*built.left.Project(ray.origin + 5.0 * ray.direction) - edge).x();
  });
  // CAHVORE's own measure of angle makes it up to a tenth less.
  EXPECT_NEAR(bend / stereo_.lens.radial_sigma_px, 1.0, kShare + 0.1);
}

INSTANTIATE_TEST_SUITE_P(, BuiltRigs, testing::Values("", "navcam.yaml"), [](const auto& info) {
  return info.param.empty() ? std::string("axel") : std::string("navcam");
});

TEST(BuiltRig, IsNotToldToTheController) {
  const BuiltRun built = Build(TypicalScenario());
  const Nominal nominal = MakeNominal(built.world.rover, built.world.station);
  EXPECT_EQ(nominal.rig.left, built.world.rover.stereo.nominal.left);
  EXPECT_FALSE(nominal.rig.left == built.built_rig.left);
  EXPECT_NE(nominal.rig.X_RQ.R, built.built_rig.X_RQ.R);
}

}  // namespace
}  // namespace dockyard::axel
