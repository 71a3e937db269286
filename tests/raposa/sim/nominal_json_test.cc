#include "sim/raposa/nominal_json.h"

#include <gtest/gtest.h>

#include "models/raposa/make_nominal.h"
#include "models/read/config_error.h"
#include "raposa/sim/raposa_rig.h"

namespace dockyard::raposa {
namespace {

Nominal Sample() {
  const WorldSetup setup = AtStart(1.0);
  Nominal nominal = MakeNominal(setup.robot, setup.pyramid);
  nominal.ferreira_vision.orange = {1, 2, 3, 4, 5, 6};
  nominal.ferreira_vision.band_changes = {{12.5, {7, 8, 9, 10, 11, 12}, {13, 14, 15, 16, 17, 18}}};
  nominal.ferreira_motion.standoff_m = 0.7;
  nominal.ferreira_motion.steer_final = false;
  return nominal;
}

/// Every number of a tree made another one.
void Shift(Json& json) {
  if (json.is_number_float()) json = json.get<double>() + 0.25;
  if (json.is_structured()) {
    for (Json& part : json) Shift(part);
  }
}

TEST(RaposaNominalJson, ComesBackBitForBit) {
  const Nominal nominal = Sample();
  const Nominal back = NominalFromJson(Json::parse(ToJson(nominal).dump()));
  EXPECT_EQ(ToJson(back), ToJson(nominal));
  EXPECT_EQ(back.ferreira_vision, nominal.ferreira_vision);
  EXPECT_EQ(back.ferreira_motion, nominal.ferreira_motion);
  EXPECT_EQ(back.marks, nominal.marks);
  EXPECT_EQ(back.camera, nominal.camera);
}

TEST(RaposaNominalJson, ReadsEveryNumberThatItWrites) {
  Json json = ToJson(Sample());
  Shift(json["ferreira_vision"]);
  Shift(json["ferreira_motion"]);
  Shift(json["marks"]);
  EXPECT_EQ(ToJson(NominalFromJson(json)), json);
}

TEST(RaposaNominalJson, AnotherSystemsParametersAreRefused) {
  EXPECT_THROW(NominalFromJson(Json{{"wheel_radius_m", 0.3}}), ConfigError);
}

}  // namespace
}  // namespace dockyard::raposa
