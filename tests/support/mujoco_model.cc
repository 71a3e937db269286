#include "support/mujoco_model.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "controller/geometry/decompositions.h"

namespace dockyard {

MujocoModel LoadMujoco(const std::string& mjcf) {
  const char* name = "model.xml";
  auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
  mj_makeEmptyFileVFS(vfs.get(), name, static_cast<int>(mjcf.size()));
  // The file has a size; it needs no null. NOLINTNEXTLINE(bugprone-not-null-terminated-result)
  std::memcpy(vfs->filedata[mj_findFileVFS(vfs.get(), name)], mjcf.data(), mjcf.size());
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML(name, vfs.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(vfs.get());
  if (model == nullptr) throw std::runtime_error(std::string("MuJoCo: ") + error.data());
  return model;
}

std::string MjcfNumbers(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out.precision(17);
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

std::string MjcfInertial(const LinkModel& link) {
  const SymmetricEigen3 eigen = EigenOfSymmetric(link.I_LCom_L);
  Eigen::Matrix3d R = eigen.vectors;
  if (R.determinant() < 0.0) R.col(2) *= -1.0;
  const Eigen::Quaterniond turn(R);
  std::ostringstream out;
  out.precision(17);
  out << "<inertial pos=\"" << MjcfNumbers(link.p_LoCom_L) << "\" mass=\"" << link.mass_kg
      << "\" quat=\"" << turn.w() << ' ' << MjcfNumbers(turn.vec()) << "\" diaginertia=\""
      << MjcfNumbers(eigen.values) << "\"/>\n";
  return out.str();
}

}  // namespace dockyard
