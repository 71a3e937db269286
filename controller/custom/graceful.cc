#include "controller/custom/graceful.h"

#include "controller/custom/pilot.h"

namespace dockyard::custom {
namespace {

using MadeController = Result<std::unique_ptr<Controller>, Refusal>;

/// Options that no docking can have.
std::string FaultOf(const DockingOptions& options) {
  if (!(options.k_phi > 0.0) || !(options.k_delta > 0.0))
    return "docking: expected gains k_phi and k_delta above zero";
  if (!(options.least_m_s > 0.0) || !(options.most_m_s >= options.least_m_s))
    return "docking: expected speeds above zero, the largest not below the least";
  if (!(options.press_m_s > 0.0) || !(options.most_rad_s > 0.0) || !(options.search_rad_s > 0.0))
    return "docking: expected speed of pressing and turning rates above zero";
  if (!(options.accel_m_s2 > 0.0) || !(options.accel_rad_s2 > 0.0))
    return "docking: expected accelerations above zero";
  if (!(options.slowdown_m > 0.0) || !(options.staging_m > 0.0))
    return "docking: expected slowdown radius and staging distance above zero";
  return {};
}

}  // namespace

MadeController MakeGracefulController(const Nominal& nominal) {
  if (nominal.boards.empty()) return Refusal{"dock: expected a board of marks"};
  auto perceive = PerceiveMarks(nominal);
  if (!perceive) return perceive.error();
  return MakeGracefulController(nominal, *perceive);
}

MadeController MakeGracefulController(const Nominal& nominal, Perceive perceive) {
  if (const std::string fault = FaultOf(nominal.docking); !fault.empty()) return Refusal{fault};
  const auto drive = FindDrive(nominal);
  if (!drive) return drive.error();
  const auto plan = PlanDocking(nominal, *drive);
  if (!plan) return plan.error();
  const auto contact = Contact::Of(nominal);
  if (!contact) return contact.error();
  std::unique_ptr<Controller> pilot =
      std::make_unique<Pilot>(PilotParts{nominal, *drive, *plan, *contact, std::move(perceive)});
  return pilot;
}

}  // namespace dockyard::custom
