#include "sim/run/record.h"

#include <array>
#include <utility>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr std::array<std::pair<Outcome, const char*>, 13> kNames{{
    {Outcome::kDocked, "docked"},
    {Outcome::kNoDetection, "no_detection"},
    {Outcome::kWrongCorrespondence, "wrong_correspondence"},
    {Outcome::kPoseRejected, "pose_rejected"},
    {Outcome::kMissedCone, "missed_cone"},
    {Outcome::kFaceCatch, "face_catch"},
    {Outcome::kJammed, "jammed"},
    {Outcome::kRecoveryLimit, "recovery_limit"},
    {Outcome::kTetherOverload, "tether_overload"},
    {Outcome::kTippedOver, "tipped_over"},
    {Outcome::kFalseDocked, "false_docked"},
    {Outcome::kTimeout, "timeout"},
    {Outcome::kCrashed, "crashed"},
}};

}  // namespace

const char* Name(Outcome outcome) {
  for (const auto& [value, name] : kNames) {
    if (value == outcome) return name;
  }
  DOCKYARD_CHECK(false);
  return "";
}

std::optional<Outcome> OutcomeFromName(const std::string& name) {
  for (const auto& [value, known] : kNames) {
    if (name == known) return value;
  }
  return std::nullopt;
}

}  // namespace dockyard
