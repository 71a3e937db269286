#include "sim/page/near_part.h"

#include <vector>

#include "sim/spectator/near_view.h"

namespace dockyard {
namespace {

constexpr double kFov_rad = 38.0 * kPi / 180.0;  // of sim/page/web/src/replay/view3d.js
constexpr double kQuantum_m = 1e-4;

}  // namespace

Json NearPart(const LoggedRun& run, const StageShapes& shapes, Payload& payload) {
  if (run.times_s.empty()) return nullptr;
  const Aim target{"target", std::nullopt};
  const NearView view = FindNearView(run, shapes, target, 0, run.times_s.size() - 1, kFov_rad);
  const Pose3 X_GW = Inverse(run.X_WG.front());
  std::vector<double> at_G[3];
  for (std::size_t sample = 0; sample < run.times_s.size(); ++sample) {
    const Eigen::Vector3d p_G = X_GW * AimPlace(target, run, shapes, sample);
    for (int axis = 0; axis < 3; ++axis) at_G[axis].push_back(p_G(axis));
  }
  Json channels = Json::array();
  for (const auto& values : at_G) channels.push_back(payload.AddChannel(values, kQuantum_m));
  const Eigen::Vector3d out = X_GW.R * (view.from_W - view.at_W);
  return {{"at", channels}, {"out", Json::array({out.x(), out.y(), out.z()})}};
}

}  // namespace dockyard
