#include "sim/rocky7/nominal_json.h"

#include <gtest/gtest.h>

#include "models/read/config_error.h"
#include "models/rocky7/load_robot.h"
#include "models/rocky7/make_nominal.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {
namespace {

Nominal Sample() {
  Nominal nominal = MakeNominal(LoadRobot(SourceFile("models/rocky7/rocky7.yaml")));
  nominal.target_px = {12.5, 99.25};
  nominal.nesnas = {0.05, 0.2, 0.01};
  return nominal;
}

/// Every number of a tree made another one.
void Shift(Json& json) {
  if (json.is_number_float()) json = json.get<double>() + 0.25;
  if (json.is_structured()) {
    for (Json& part : json) Shift(part);
  }
}

TEST(Rocky7NominalJson, ComesBackBitForBit) {
  const Nominal nominal = Sample();
  const Nominal back = NominalFromJson(Json::parse(ToJson(nominal).dump()));
  EXPECT_EQ(ToJson(back), ToJson(nominal));
  EXPECT_EQ(back.nesnas, nominal.nesnas);
  EXPECT_EQ(back.front.left, nominal.front.left);
  EXPECT_EQ(back.motors, nominal.motors);
  EXPECT_EQ(back.mast.watch_rad, nominal.mast.watch_rad);
  EXPECT_EQ(back.mast.pair_K.left, nominal.mast.pair_K.left);
}

TEST(Rocky7NominalJson, ReadsEveryNumberThatItWrites) {
  Json shifted = ToJson(Sample());
  Shift(shifted);
  EXPECT_EQ(ToJson(NominalFromJson(shifted)), shifted);
}

TEST(Rocky7NominalJson, RefusesAnothersParameters) {
  EXPECT_THROW(NominalFromJson(Json{{"belts", 2}}), ConfigError);
}

}  // namespace
}  // namespace dockyard::rocky7
