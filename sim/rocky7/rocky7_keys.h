// The keys of a scenario under `rocky7`.
#pragma once

#include <limits>

#include "controller/rocky7/nominal/nominal.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::rocky7 {

/// Of a boulder: a block with flat faces, or a rock with rounded edges.
enum class BoulderKind { kFaced, kRounded };
/// How a stone to be grasped lies: on its flat side, or in the attitude in which it came to rest.
enum class TargetLies { kFlat, kAny };

struct Rocky7Keys {
  Task task = Task::kReach;
  // The target: a stone at the origin of D; to be grasped it lies loose on the ground. 3-5 cm
  // (Nesnas, Maimone and Das 2000).
  double diameter_m = 0.04;
  double height_m = 0.02;  // over the ground; of its diameter one half (assumed, 0.3-0.7)
  double buried = 0.1;     // share of its height in the ground; assumed, 0-0.3
  double turn_rad = 0.0;   // about the vertical
  TargetLies lies = TargetLies::kFlat;
  // The field's stones that wheels and scoops move: those that are smaller, this near to the
  // target. All others lie in the ground and sink under a wheel. Assumed, 4-12 cm and 0.3-1 m.
  double loose_below_m = 0.08, loose_within_m = 0.5;
  // Gravel from this size on lies this near to the target, for cameras alone. Smaller pebbles are
  // in the ground's texture. Assumed, 3-10 mm and 0.5-2 m.
  double gravel_m = 0.005, gravel_within_m = 0.8;
  // The rover's start heading off the target; NaN: start.heading counts.
  double off_target_rad = std::numeric_limits<double>::quiet_NaN();
  double reach_m = 0.01;  // how near the point P must come: "to within 1 cm"
  // A boulder to place the instrument on; the target on it lies over the origin of D.
  BoulderKind boulder = BoulderKind::kFaced;
  double boulder_m = 0.6;              // across; assumed, 0.4-0.8: "boulder" has no size there
  double target_up_m = 0.3;            // of the face's middle over the ground; assumed, 0.15-0.45
  double face_up_rad = Radians(30.0);  // of its outward normal over the horizontal
  double face_turn_rad = 0.0;          // of that normal in plan
  double rim_m = 0.1;                  // from its middle to its upper edge; assumed, 0.02-0.15
  double roughness_m = 1e-3;           // assumed, 0.5-3 mm
  bool placeable = false;              // of a rounded rock: drawn again until it is
  double tilt_rad = Radians(5.0);      // the instrument must stand so near to the normal: 5 deg
  double most_n = 10.0;                // and must not press more
  double click_px = 1.5;  // of the user's click, 1 sigma along each side; assumed, 0.5-4
  // Albedo of stones against that of the soil: freshly broken faces are darker than dust. Assumed,
  // 0.4-1. Its stains over its mean: assumed, 0.1-0.2.
  double stone_albedo = 0.65, stone_stains = 0.15;
  // The controller's processor takes this time for an image pair. The paper's, a 68060 of 60 MHz,
  // has no published figure: assumed, 3-60 s. Blocks over 640 x 480 pixels and 64 differences,
  // twice, are 4e8 to 8e8 instructions, 7-27 s at one in one or two cycles; 320 x 240 are an eighth
  // of that.
  double compute_s = 0.0;
  NesnasTracking nesnas{};
};

/// Names every key: for reading, and for docs/rocky7.md.
void VisitRocky7Keys(Keys& keys, Rocky7Keys& values);
/// Reads and checks them. Throws ConfigError.
Rocky7Keys ReadRocky7Keys(const Scenario& scenario);

}  // namespace dockyard::rocky7
