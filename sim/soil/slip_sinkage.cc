#include "sim/soil/slip_sinkage.h"

#include <algorithm>
#include <cmath>

#include "sim/soil/soil_laws.h"

namespace dockyard {
namespace {

// Fitted to Pavlov and Johnson's single-wheel means (|slip| <= 0.76, side slip <= 45 deg) with
// n_slip = 0.5. Growth of the exponent: share of n_slip for drive and for side slip; skid: 1.
constexpr double kDriveExponentShare = 0.1;
constexpr double kSideExponentShare = 0.45;
// Loss of carrying depth per contact length slid, per n_slip.
constexpr double kDriveLoss = 2.2;
constexpr double kSkidLoss = 0.4;
constexpr double kSideLoss = 0.2;
constexpr double kLeastShare = 0.1;
// Slip beyond which the losses act in full; below, they set in linearly. Assumed, 0.05-0.2.
constexpr double kFullDriveOrSkid = 0.1;
constexpr double kFullSide = 0.5;

}  // namespace

void FollowSlip(SlipTrack& slip, double rolled_m, double ahead_m, double left_m, double memory_m) {
  const double distance =
      std::max(std::fabs(rolled_m), std::sqrt(ahead_m * ahead_m + left_m * left_m));
  if (distance <= 0.0) return;
  const double keep = Decay(distance / memory_m);
  const double gain = (1.0 - keep) / distance;
  const double forward = rolled_m + ahead_m >= 0.0 ? 1.0 : -1.0;
  slip.ahead = slip.ahead * keep + gain * forward * (rolled_m - ahead_m);
  slip.aside = slip.aside * keep + gain * left_m;
}

SlipSinkage MakeSlipSinkage(const SlipTrack& slip, double n, double n_slip) {
  const double drive = std::max(0.0, slip.ahead), skid = std::max(0.0, -slip.ahead);
  const double side = kSideExponentShare * slip.aside;
  const double growth = kDriveExponentShare * drive + std::sqrt(skid * skid + side * side);
  SlipSinkage sinkage;
  sinkage.exponent = n + n_slip * std::min(1.0, growth);
  sinkage.loss_t = n_slip * kDriveLoss * std::min(1.0, drive / kFullDriveOrSkid);
  sinkage.loss_any = n_slip * (kSkidLoss * std::min(1.0, skid / kFullDriveOrSkid) +
                               kSideLoss * std::min(1.0, std::fabs(slip.aside) / kFullSide));
  return sinkage;
}

double CarryingShare(const SlipSinkage& sinkage, double slid_t_m, double slid_a_m,
                     double contact_length_m) {
  const double slid = std::sqrt(slid_t_m * slid_t_m + slid_a_m * slid_a_m);
  const double loss = sinkage.loss_t * std::fabs(slid_t_m) + sinkage.loss_any * slid;
  return std::max(kLeastShare, 1.0 - loss / contact_length_m);
}

}  // namespace dockyard
