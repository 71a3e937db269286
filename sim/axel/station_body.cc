#include "sim/axel/station_body.h"

#include "sim/axel/cone_shapes.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::axel {
namespace {

// Share of critical damping in the feet (assumed, range 0.1-0.5: soil under a pad).
constexpr double kFootDampingRatio = 0.3;

// Whether the cone's axis, from the throat to the socket's end, passes through a module's shape.
bool CrossesAxis(const Collision& collision, const Pose3& X_GL_axis, double from_m, double to_m) {
  const auto* box = std::get_if<BoxShape>(&collision.shape);
  if (box == nullptr) return false;
  for (int i = 0; i <= 10; ++i) {
    const double depth = from_m + (to_m - from_m) * i / 10.0;
    const Eigen::Vector3d p = X_GL_axis * Eigen::Vector3d(-depth, 0.0, 0.0);
    if ((p.cwiseAbs() - 0.5 * box->size_m).maxCoeff() < 0.0) return true;
  }
  return false;
}

}  // namespace

SinkingPlate SoleOf(const StationModel& station, const SoilModel& soil) {
  return station.sole_diameter_m > 0.0 ? RoundPlate(soil, station.sole_diameter_m) : SinkingPlate{};
}

StationBody::StationBody(const StationModel& station, const Pose3& X_GS, const SinkingPlate& sole)
    : station_(station), X_SM_(MouthInStation(station)) {
  // The module's own frame stands level; it is tipped about the mouth's centre.
  const Pose3 X_SL = X_SM_ * Pose3::Translation(0.0, 0.0, -station.mouth_height_m);
  inertia_ = FindPrincipalInertia(station.module);
  inertia_.X_LP = X_SL * inertia_.X_LP;
  AddShapes();

  btRigidBody::btRigidBodyConstructionInfo info(station.module.mass_kg, nullptr, shape_.compound(),
                                                ToBullet(inertia_.moments));
  info.m_startWorldTransform = ToBullet(X_GS * inertia_.X_LP);
  info.m_linearDamping = 0.0;
  info.m_angularDamping = 0.0;
  body_ = std::make_unique<btRigidBody>(info);
  body_->setActivationState(DISABLE_DEACTIVATION);

  DOCKYARD_CHECK(!station.feet.empty());
  feet_.resize(station.feet.size());
  AddSole(sole);
  Refresh();
}

GroundMaterial StationBody::MaterialOf(const SinkingPlate& sole) const {
  const double share_kg = station_.module.mass_kg / static_cast<double>(station_.feet.size());
  const bool sinks = sole.force_n_per_m_n > 0.0;
  const double stiffness = sinks ? sole.rebound_n_per_m : station_.foot_stiffness_n_per_m;
  return {stiffness, 2.0 * kFootDampingRatio * std::sqrt(stiffness * share_kg),
          station_.foot_friction, sole};
}

void StationBody::AddShapes() {
  const Pose3 X_PS = Inverse(inertia_.X_LP);
  shape_.Add(ConeBlock(station_.cone), X_PS * X_SM_);
  meets_arm_.push_back(false);
  const Pose3 X_SL = X_SM_ * Pose3::Translation(0.0, 0.0, -station_.mouth_height_m);
  for (const Collision& collision : station_.module.collisions) {
    shape_.Add(collision, X_PS * X_SL);
    const Pose3 X_GM = Inverse(X_SL * collision.X_LG) * X_SM_;
    meets_arm_.push_back(!CrossesAxis(collision, X_GM, 0.0, station_.cone.socket_end_m));
  }
  AddFaces();
  btVector3 low, high;
  shape_.compound()->getAabb(btTransform::getIdentity(), low, high);
  reach_m_ = std::max(low.length(), high.length()) + (X_SM_.p - inertia_.X_LP.p).norm();
}

// Each piece's box in the shape's axes.
void StationBody::AddFaces() {
  for (int piece = 0; piece < shape_.pieces(); ++piece) {
    std::vector<StationFace>& faces = faces_.emplace_back();
    btCompoundShape* all = shape_.compound();
    btVector3 low, high;
    all->getChildShape(piece)->getAabb(all->getChildTransform(piece), low, high);
    for (int axis = 0; axis < 3; ++axis) {
      btVector3 normal(0, 0, 0);
      normal[axis] = 1.0;
      faces.push_back({normal, high[axis]});
      faces.push_back({-normal, -low[axis]});
    }
  }
}

void StationBody::AddForce(const Eigen::Vector3d& force_G, const Eigen::Vector3d& p_G) {
  body_->applyForce(ToBullet(force_G), ToBullet(Eigen::Vector3d(p_G - CentreOfMass())));
}

void StationBody::AddTorque(const Eigen::Vector3d& torque_G) {
  body_->applyTorque(ToBullet(torque_G));
}

void StationBody::AddFeetForces(const HeightGrid& ground, double dt_s) {
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector3d p_G = motion_.X_GL * station_.feet[i].p_SF;
    const Eigen::Vector3d force_G = GroundForce(ground, soles_.at(ground.SoilAt(p_G)), p_G,
                                                motion_.VelocityAt(p_G), dt_s, feet_[i]);
    if (!force_G.isZero(0.0)) AddForce(force_G, p_G);
  }
}

void StationBody::TakeLoads(const Eigen::Vector3d& gravity_G, double step_s) {
  btRigidBody& body = *body_;
  const btVector3 fall = ToBullet(Eigen::Vector3d(gravity_G * step_s));
  body.setLinearVelocity(body.getLinearVelocity() + fall +
                         body.getTotalForce() * (body.getInvMass() * step_s));
  body.setAngularVelocity(body.getAngularVelocity() +
                          body.getInvInertiaTensorWorld() * body.getTotalTorque() * step_s +
                          body.computeGyroscopicImpulseImplicit_Body(step_s));
  body.clearForces();
}

void StationBody::AddImpulse(const Eigen::Vector3d& impulse_G, const Eigen::Vector3d& p_G) {
  body_->applyImpulse(ToBullet(impulse_G), ToBullet(Eigen::Vector3d(p_G - CentreOfMass())));
}

void StationBody::Move(double step_s) {
  btTransform next;
  body_->predictIntegratedTransform(step_s, next);
  body_->proceedToTransform(next);
}

Eigen::Matrix3d StationBody::InverseInertia() const {
  return FromBullet(body_->getInvInertiaTensorWorld());
}

void StationBody::Refresh() {
  const Pose3 X_GP = FromBullet(body_->getWorldTransform());
  motion_.X_GL = X_GP * Inverse(inertia_.X_LP);
  motion_.w_GL_G = FromBullet(body_->getAngularVelocity());
  motion_.v_GL_G =
      FromBullet(body_->getLinearVelocity()) + motion_.w_GL_G.cross(motion_.X_GL.p - X_GP.p);
}

double StationBody::sunk_m() const {
  double deepest = 0.0;
  for (const GroundPoint& foot : feet_) deepest = std::max(deepest, foot.sunk_m);
  return deepest;
}

std::uint64_t StationBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  const btTransform& X = body_->getWorldTransform();
  const btVector3 v = body_->getLinearVelocity(), w = body_->getAngularVelocity();
  for (int i = 0; i < 3; ++i) {
    for (double value : {X.getOrigin()[i], v[i], w[i]}) hash = HashDouble(hash, value);
    for (int j = 0; j < 3; ++j) hash = HashDouble(hash, X.getBasis()[i][j]);
  }
  for (const GroundPoint& foot : feet_) hash = HashPoint(hash, foot);
  return hash;
}

}  // namespace dockyard::axel
