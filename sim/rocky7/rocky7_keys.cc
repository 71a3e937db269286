#include "sim/rocky7/rocky7_keys.h"

namespace dockyard::rocky7 {
namespace {

void VisitNesnas(Keys& keys, NesnasTracking& nesnas) {
  keys.Choice({"front_end", "", "of nesnas2000: how it matches image pairs"}, nesnas.front_end,
              {"blocks7", "sand_and_stones"});
  keys.Number({"window_m", "m", "the same: half the side of its search window"}, nesnas.window_m,
              Between(0.01, 0.5));
  keys.Number({"image_share", "", "the same: of what is left to drive, before it takes images"},
              nesnas.image_share, Between(0.01, 1.0));
  keys.Number({"least_step_m", "m", "the same: what is left is driven at once when it is shorter"},
              nesnas.least_step_m, Between(0.001, 1.0));
}

}  // namespace

void VisitRocky7Keys(Keys& keys, Rocky7Keys& values) {
  keys.Choice(
      {"task", "", "bring the point to the target, grasp it, or place the instrument on it"},
      values.task, {"reach", "grasp", "place"});
  keys.Number({"diameter_m", "m", "of the target stone, the mean of its length and width"},
              values.diameter_m, Between(0.01, 0.3));
  keys.Number(
      {"height_m", "m", "of the target stone over the ground; one to be grasped has its own"},
      values.height_m, Between(0.005, 0.2));
  keys.Number({"buried", "", "share of its height that is in the ground"}, values.buried,
              Between(0.0, 0.5));
  keys.Degrees({"turn_deg", "deg", "of the target stone about the vertical"}, values.turn_rad,
               Between(-180.0, 180.0));
  keys.Choice({"lies", "", "the stone to be grasped: on its flat side, or in any attitude of rest"},
              values.lies, {"flat", "any"});
  keys.Number({"loose_below_m", "m", "smaller stones of the field are loose ..."},
              values.loose_below_m, Between(0.0, 0.3));
  keys.Number({"loose_within_m", "m", "... this near to the target"}, values.loose_within_m,
              Between(0.0, 2.0));
  keys.Number({"gravel_m", "m", "least stones that cameras see as shapes, below rocks.least_m"},
              values.gravel_m, Between(0.003, 0.02));
  keys.Number({"gravel_within_m", "m", "the same: this near to the target"}, values.gravel_within_m,
              Between(0.0, 2.0));
  keys.Degrees(
      {"off_target_deg", "deg",
       "the rover's start heading off the target, in place of start.heading_deg", Presence::kUnset},
      values.off_target_rad, Between(-60.0, 60.0));
  keys.Choice({"boulder", "", "to place on: with flat faces, or a rounded rock"}, values.boulder,
              {"faced", "rounded"});
  keys.Allow("rim_m", values.boulder == BoulderKind::kFaced,
             "no such key with boulder: rounded, which has no edge");
  keys.Allow("placeable", values.boulder == BoulderKind::kRounded,
             "no such key without boulder: rounded");
  keys.Number({"boulder_m", "m", "to place on: the boulder's width"}, values.boulder_m,
              Between(0.3, 1.5));
  keys.Number({"target_up_m", "m",
               "the same: height of the target over the ground: its face's middle, or a point"},
              values.target_up_m, Between(0.1, 0.7));
  keys.Degrees(
      {"face_up_deg", "deg",
       "the same: outward normal there, over the horizontal; 90 is a rounded rock's summit"},
      values.face_up_rad,
      keys.Limits(Between(0.0, values.boulder == BoulderKind::kFaced ? 80.0 : 90.0),
                  Between(0.0, 90.0)));
  keys.Degrees({"face_turn_deg", "deg", "the same: that normal in plan, from the x axis of D"},
               values.face_turn_rad, Between(-180.0, 180.0));
  keys.Number(
      {"rim_m", "m", "the same: from the face's middle to its upper edge; a top's is small"},
      values.rim_m, Between(0.005, 0.3));
  keys.Number({"roughness_m", "m", "the same: root mean square over 12 to 100 mm"},
              values.roughness_m, Between(0.0, 0.01));
  keys.Bool({"placeable", "",
             "a rounded rock is drawn again until the instrument can rest on the target and the "
             "mast reaches the normal there"},
            values.placeable);
  keys.Degrees({"tilt_deg", "deg", "how near to the surface's normal the instrument must stand"},
               values.tilt_rad, Between(0.5, 45.0));
  keys.Number({"most_n", "N", "what the instrument may press with"}, values.most_n,
              Between(1.0, 1000.0));
  keys.Number({"reach_m", "m", "how near the point must come to the target's middle"},
              values.reach_m, Between(0.002, 0.1));
  keys.Number({"click_px", "px", "error of the user's click along each side, 1 sigma"},
              values.click_px, Between(0.0, 50.0));
  keys.Number({"stone_albedo", "", "of all stones, over the soil's"}, values.stone_albedo,
              Between(0.1, 2.0));
  keys.Number({"stone_stains", "", "of their albedo over its mean, 1 sigma"}, values.stone_stains,
              Between(0.0, 0.5));
  keys.Number({"compute_s", "s", "that the controller's processor takes for an image pair"},
              values.compute_s, Between(0.0, 600.0));
  keys.Mapping(Optional("nesnas"), [&](Keys& in) { VisitNesnas(in, values.nesnas); });
}

Rocky7Keys ReadRocky7Keys(const Scenario& scenario) {
  Rocky7Keys values;
  ReadKeys(scenario.of_system, "rocky7", [&](Keys& keys) { VisitRocky7Keys(keys, values); });
  return values;
}

}  // namespace dockyard::rocky7
