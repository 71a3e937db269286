// How much faster than the clock the charger's robot drives on hard floor: its physics alone. The
// hash of its state tells whether two builds give the same bits.
#include <cinttypes>
#include <cstdio>
#include <ctime>

#include "custom/charger_rig.h"
#include "sim/custom/world.h"

namespace dockyard::custom {
namespace {

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace
}  // namespace dockyard::custom

int main() {
  using namespace dockyard::custom;
  const WorldSetup setup = ChargerWorld();
  World world(setup);
  constexpr double kEach_s = 4.0;
  const double began_s = CpuSeconds();
  for (const double left_m_s : {0.3, 0.25, 0.2}) {  // to the right, ahead, to the left
    RunFor(world, kEach_s, DriveAt(setup, left_m_s, 0.25));
  }
  std::printf("%.1f simulated s per CPU s; state %016" PRIx64 "\n",
              3.0 * kEach_s / (CpuSeconds() - began_s), world.StateHash(0));
  return 0;
}
