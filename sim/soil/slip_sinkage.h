// How slip lets a wheel sink: the soil under it is carried away in the direction of sliding.
//
// Two effects, both driven by displacements, so that nothing happens at rest:
// * the sinkage exponent grows with the distance slipped per distance moved (Pavlov and Johnson
//   2019; Zhou et al. 2023): n + n_slip (skid and side slip in full measure, drive slip little);
// * under each patch the depth that carries it shrinks with its own sliding since it entered,
//   counted in contact lengths. Drive slip thus moves the pressure towards the front, as Wong and
//   Reece (1967) measured.
// The shares were fitted to the single-wheel data of Pavlov and Johnson, see tests/soil.
#pragma once

namespace dockyard {

/// Distance slipped per distance moved, remembered over about one contact length.
struct SlipTrack {
  double ahead = 0.0;  // > 0: the wheel turns more than it moves (drive); < 0: skid
  double aside = 0.0;  // towards the wheel's left
};

/// Follows one step in which the rim rolled and its centre moved ahead and to the left [m].
void FollowSlip(SlipTrack& slip, double rolled_m, double ahead_m, double left_m, double memory_m);

/// What the slip of a wheel as a whole does to the soil under all of its patches.
struct SlipSinkage {
  double exponent = 1.0;  // of the pressure-sinkage curve
  double loss_t = 0.0;    // share of carrying depth lost per contact length slid along the turn
  double loss_any = 0.0;  // and in any direction
};
SlipSinkage MakeSlipSinkage(const SlipTrack& slip, double n, double n_slip);

/// Share of a patch's depth below the undisturbed soil that still carries, 0.1..1.
double CarryingShare(const SlipSinkage& sinkage, double slid_t_m, double slid_a_m,
                     double contact_length_m);

}  // namespace dockyard
