#include "sim/axel/contact_shapes.h"

#include <algorithm>
#include <cmath>

#include "sim/axel/cone_shapes.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::axel {
namespace {

// Whether the cone's axis, from the mouth to the socket's end, passes through a module's shape.
bool CrossesAxis(const Collision& collision, const Pose3& X_PM, double to_m) {
  const auto* box = std::get_if<BoxShape>(&collision.shape);
  if (box == nullptr) return false;
  for (int i = 0; i <= 10; ++i) {
    const Eigen::Vector3d p = X_PM * Eigen::Vector3d(-to_m * i / 10.0, 0.0, 0.0);
    if ((p.cwiseAbs() - 0.5 * box->size_m).maxCoeff() < 0.0) return true;
  }
  return false;
}

// How far each link's origin can be from the body's [m].
std::vector<double> OriginsWithin(const RoverModel& rover) {
  const std::vector<TreeLink> links = TreeOf(rover, false).links;
  std::vector<double> within_m;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const int carrier = links[i].parent;
    const double carrier_m = carrier < 0 ? 0.0 : within_m[static_cast<std::size_t>(carrier)];
    within_m.push_back(carrier_m + links[i].p_PL.norm());
    if (i < kOwnLinkCount) continue;
    const JointedLink& each = rover.further.links[i - kOwnLinkCount];
    if (each.slides) within_m.back() += std::max(std::abs(each.low_rad), std::abs(each.high_rad));
  }
  return within_m;
}

}  // namespace

const btConvexShape& ShapedObject::piece(int i) const {
  return static_cast<const btConvexShape&>(*shape_.compound()->getChildShape(i));
}

void ShapedObject::MoveTo(const Pose3& X_GB) { object_.setWorldTransform(ToBullet(X_GB)); }

double ShapedObject::reach_m() const {
  if (pieces() == 0) return 0.0;
  btVector3 low, high;
  shape_.compound()->getAabb(btTransform::getIdentity(), low, high);
  btVector3 most = low.absolute();
  most.setMax(high.absolute());
  return most.length();
}

ContactShapes::ContactShapes(const RoverModel& rover, const StationModel& station) {
  for (int i = 0; i < LinkCount(rover); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    ShapedObject& own = links_.emplace_back();
    const std::vector<Collision> parts =
        link == RoverLink::kArm ? ArmCollisions(rover) : LinkOf(rover, link).collisions;
    for (const Collision& part : parts) own.Add(part, {});
  }
  const std::vector<double> origins_m = OriginsWithin(rover);
  for (std::size_t i = 0; i < links_.size(); ++i) {
    reach_m_ = std::max(reach_m_, origins_m[i] + links_[i].reach_m());
  }
  station_.Add(ConeBlock(station.cone), {});
  meets_arm_.push_back(false);
  const Pose3 X_ML = Pose3::Translation(0.0, 0.0, -station.mouth_height_m);
  for (const Collision& part : station.module.collisions) {
    station_.Add(part, X_ML);
    meets_arm_.push_back(!CrossesAxis(part, Inverse(X_ML * part.X_LG), station.cone.socket_end_m));
  }
  AddFaces();
  reach_m_ += station_.reach_m();
}

// Each piece's box in M.
void ContactShapes::AddFaces() {
  for (int i = 0; i < station_.pieces(); ++i) {
    std::vector<StationFace>& faces = faces_.emplace_back();
    btVector3 low, high;
    station_.piece(i).getAabb(station_.X_BP(i), low, high);
    for (int axis = 0; axis < 3; ++axis) {
      btVector3 normal(0, 0, 0);
      normal[axis] = 1.0;
      faces.push_back({normal, high[axis]});
      faces.push_back({-normal, -low[axis]});
    }
  }
}

void ContactShapes::MoveTo(const RoverBody& rover, const StationBody& station) {
  for (int i = 0; i < rover.link_count(); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    links_[Place(link)].MoveTo(rover.motion(link).X_GL);
  }
  station_.MoveTo(station.X_GM());
}

}  // namespace dockyard::axel
