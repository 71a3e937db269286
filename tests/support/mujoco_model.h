// Models of MuJoCo made of MJCF text, for tests that compare our bodies with those of another
// engine.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <string>

#include "models/parts/link.h"

namespace dockyard {

struct MujocoDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, MujocoDeleter>;
using MujocoData = std::unique_ptr<mjData, MujocoDeleter>;

/// Throws std::runtime_error with MuJoCo's message where the text is wrong.
MujocoModel LoadMujoco(const std::string& mjcf);

/// Three numbers that read back to the same bits.
std::string MjcfNumbers(const Eigen::Vector3d& v);
/// A body's <inertial>, in the link's frame, by its principal axes: MuJoCo finds those of a full
/// matrix to nine digits alone.
std::string MjcfInertial(const LinkModel& link);

}  // namespace dockyard
