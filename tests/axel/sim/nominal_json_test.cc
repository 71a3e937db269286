#include "sim/axel/nominal_json.h"

#include <gtest/gtest.h>

#include "models/read/config_error.h"
#include "sim/base/random.h"

namespace dockyard::axel {
namespace {

Nominal SomeNominal() {
  RandomStream draw(5);
  Nominal nominal;
  nominal.rig.left = EquidistantCamera(640, 480, Radians(90.0));
  nominal.rig.right = nominal.rig.left;
  std::get<KannalaBrandt>(nominal.rig.right.lens).k = {draw.Normal(), 1e-300, -0.0, 1.0 / 3.0};
  nominal.rig.X_RL.R = RotZ(draw.Normal()) * RotX(draw.Normal());
  nominal.rig.X_RL.p = Eigen::Vector3d(0.1, 0.2, draw.Normal());
  nominal.board.width_m = 0.9;
  nominal.board.fiducials = {{Eigen::Vector2d(0.1, -0.2), kPi / 4},
                             {Eigen::Vector2d(0.3, 0.1), 0.0}};
  for (NominalMotor& motor : nominal.motors) motor.rad_per_count = draw.Uniform();
  nominal.track_m = 0.85;
  return nominal;
}

std::string ErrorOf(const Json& json) {
  try {
    NominalFromJson(json);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(NominalJson, ReadsBackEveryNumberBitForBit) {
  const Nominal nominal = SomeNominal(), read = NominalFromJson(ToJson(nominal));
  EXPECT_EQ(ToJson(read).dump(), ToJson(nominal).dump());
  EXPECT_EQ(read.rig.X_RL.R, nominal.rig.X_RL.R);
  EXPECT_EQ(read.rig.right, nominal.rig.right);
  EXPECT_EQ(read.motors, nominal.motors);
}

TEST(NominalJson, ReadsBackEachLensModelAndPipeline) {
  Nominal nominal = SomeNominal();
  nominal.vision = {VisionPipeline::kTsai2013, 5};
  nominal.vision.bracket_stops = 1.5;
  nominal.vision.while_driving = true;
  nominal.shutter_s = 0.0123;
  for (const Lens& lens : {Lens(KannalaBrandt{.fx = 1.0}), Lens(BrownPinhole{.k3 = 2.0}),
                           Lens(Cahvore{.linearity = 0.5}),
                           Lens(RationalPinhole{.fy = 1.5, .k = {1, 2, 3, 4, 5, 6}, .p2 = 0.1}),
                           Lens(DoubleSphere{.cx = 3.0, .xi = -0.2, .alpha = 0.6}),
                           Lens(Eucm{.cy = 4.0, .alpha = 0.6, .beta = 1.1}),
                           Lens(Omni{.xi = 1.5, .k1 = 0.1, .k2 = 0.2, .p1 = 0.3, .p2 = 0.4}),
                           Lens(FovPinhole{.fx = 2.0, .w_rad = 0.9})}) {
    nominal.rig.left.lens = lens;
    const Nominal read = NominalFromJson(ToJson(nominal));
    EXPECT_EQ(read.rig.left, nominal.rig.left);
    EXPECT_EQ(read.vision, nominal.vision);
    EXPECT_EQ(read.shutter_s, nominal.shutter_s);
  }
}

TEST(NominalJson, RefusesALensModelOrPipelineThatItDoesNotKnow) {
  const auto error_of = [](const char* part, const char* key, const char* name) {
    Json json = ToJson(SomeNominal());
    json[part][key] = name;
    return ErrorOf(json);
  };
  EXPECT_EQ(
      error_of("left_camera", "model", "mei"),
      "lens model: expected kannala_brandt, brown, cahvore, rational, double_sphere, eucm, omni "
      "or fov, found 'mei'");
  EXPECT_EQ(error_of("vision", "pipeline", "tsai2014"),
            "vision pipeline: expected dockyard or tsai2013, found 'tsai2014'");
  EXPECT_EQ(error_of("vision", "pipeline", "dockyard"), "no error");
}

TEST(NominalJson, RefusesABoardUprightInWhatItDoesNotKnow) {
  Json json = ToJson(SomeNominal());
  json["board"]["upright_within_rad"] = 0.1;
  json["board"]["upright_in"] = "picture";  // the former name of image
  EXPECT_EQ(ErrorOf(json), "upright_in: expected gravity or image, found 'picture'");
  json["board"]["upright_in"] = "image";
  EXPECT_EQ(ErrorOf(json), "no error");
}

TEST(NominalJson, ReadsBackWhatThePaperLeavesOpen) {
  Nominal nominal = SomeNominal();
  double number = 0.1;
  Tsai2013Options& o = nominal.tsai2013;
  for (double* value :
       {&o.align_r_m, &o.mate_r_m, &o.mate_gap_m, &o.recover_r_m, &o.heading_rad, &o.tip_offset_m,
        &o.contact_depth_m, &o.contact_within_m, &o.reel_in_m, &o.turn_cost_m, &o.least_radius_m,
        &o.most_turn_rad, &o.drive_m_s, &o.mate_m_s, &o.reel_m_s, &o.wheel_accel_rad_s2, &o.taut_n,
        &o.tighten_m_s, &o.look_pitch_rad}) {
    *value = number += 0.1;
  }
  o.blind_looks = 7;
  nominal.vision.tsai2013 = {0.11, 0.12, 13.0, 0.14, 6,    Tsai2013First::kLeftmost,
                             21.0, 0.06, 0.46, 3,    0.26, 0.05,
                             0.46, 0.81, 0.79};
  const Nominal read = NominalFromJson(ToJson(nominal));
  EXPECT_EQ(read.tsai2013, nominal.tsai2013);
  EXPECT_EQ(read.vision, nominal.vision);
  Json json = ToJson(nominal);
  json["tsai2013"]["first"] = "rightmost";
  EXPECT_EQ(ErrorOf(json),
            "tsai2013 first: expected lowest, topmost, leftmost or largest, found 'rightmost'");
  json["tsai2013"]["first"] = "lowest";
  json["tsai2013"].erase("least_area_px");  // a log from before the filters' members
  const Tsai2013Vision before = NominalFromJson(json).vision.tsai2013;
  EXPECT_EQ(before.black_below_mean, 0.11);
  EXPECT_EQ(before.most_holes, Tsai2013Vision{}.most_holes);
  EXPECT_EQ(before.pattern_within, Tsai2013Vision{}.pattern_within);
  json.erase("tsai2013");  // a log from before
  EXPECT_EQ(NominalFromJson(json).tsai2013, Tsai2013Options{});
}

TEST(NominalJson, ReadsBackAMapOfRocksAndWritesNoneWithout) {
  Nominal nominal = SomeNominal();
  EXPECT_FALSE(ToJson(nominal).contains("rock_map"));
  nominal.rock_map = {{{1.0 / 3.0, -0.2, 0.15, 0.1}, {2.0, 0.5, 0.2, 0.3}}, 0.03};
  EXPECT_EQ(NominalFromJson(ToJson(nominal)).rock_map, nominal.rock_map);
}

TEST(NominalJson, RefusesTheParametersOfAnotherSystem) {
  EXPECT_NE(ErrorOf({{"distance_m", 2.0}}), "no error");
}

}  // namespace
}  // namespace dockyard::axel
