// Which rows a world's constraints have in a step.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/rigid/rigid_world.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A stop has a row if the joint meets it within this number of steps at its rate.
constexpr double kStepsAhead = 2.0;
// A normal that turned by more than 120 deg in a step is of another contact.
constexpr double kLeastCosine = -0.5;

// Turns vectors at a contact with its normal from one step to the next, and about the normal by an
// angle.
class Carrier {
 public:
  Carrier(const Vector3d& from, const Vector3d& to, double about_rad)
      : same_(from.dot(to) >= kLeastCosine), axis_(from.cross(to)), cosine_(from.dot(to)) {
    if (about_rad != 0.0) about_ = Eigen::AngleAxisd(about_rad, to).toRotationMatrix();
  }

  Vector3d Carried(const Vector3d& v) const {
    if (!same_ || v.isZero(0.0)) return Vector3d::Zero();
    const Vector3d once = axis_.cross(v);
    const Vector3d carried = v + once + axis_.cross(once) / (1.0 + cosine_);
    return about_ ? Vector3d(*about_ * carried) : carried;
  }

 private:
  bool same_;
  Vector3d axis_;
  double cosine_;
  std::optional<Matrix3d> about_;
};

}  // namespace

LinkMotion RigidWorld::MotionOf(const BodyLink& at) const {
  return at.body < 0 ? LinkMotion{} : body(at.body).motion(at.link);
}

// The surfaces' bend turns with the normal, and about it by the mean of both bodies' turning.
void RigidWorld::GoOnFromLastStep(WorldContact& contact, double step_s) const {
  const WorldContact* nearest = nullptr;
  double least_m = contact.same_within_m;
  for (const WorldContact& last : contacts_) {
    if (last.pair != contact.pair || last.a.body != contact.a.body ||
        last.a.link != contact.a.link || last.b.body != contact.b.body ||
        last.b.link != contact.b.link) {
      continue;
    }
    const double apart_m = (last.p_G - contact.p_G).norm();
    if (nearest != nullptr && apart_m >= least_m) continue;
    if (apart_m > contact.same_within_m) continue;
    nearest = &last;
    least_m = apart_m;
  }
  if (nearest == nullptr) return;
  const double about_rad =
      0.5 * step_s *
      (MotionOf(contact.a).w_GL_G + MotionOf(contact.b).w_GL_G).dot(contact.normal_G);
  const Carrier carrier(nearest->normal_G, contact.normal_G, about_rad);
  contact.impulse_G = carrier.Carried(nearest->impulse_G);
  contact.rolling_G = carrier.Carried(nearest->rolling_G);
  contact.bend_G = carrier.Carried(nearest->bend_G);
}

const LinkRows& RigidWorld::RowsOf(const BodyLink& at) {
  for (std::size_t i = 0; i < answers_count_; ++i) {
    if (answers_[i].at.body == at.body && answers_[i].at.link == at.link) return answers_[i].rows;
  }
  if (answers_count_ == answers_.size()) answers_.emplace_back();
  LinkAnswers& found = answers_[answers_count_++];
  found.at = at;
  found.rows.Fill(body(at.body), at.link);
  return found.rows;
}

// Of rows that are the velocity along axes of a's point from b's, or their turning.
void RigidWorld::FillEnds(const BodyLink& a, const BodyLink& b, const Vector3d& p_G,
                          const Matrix3d& axes, bool turning) {
  for (ConstraintEnd& end : ends_) end.Clear();
  const auto AddLink = [&](const BodyLink& at, const Matrix3d& along, ConstraintEnd& end) {
    if (!Moves(at.body)) return;
    const LinkRows& link = RowsOf(at);
    end.Start(first_[Place(at.body)], link.rows.rows());
    if (turning) {
      end.AddTurning(link, along);
    } else {
      end.AddPoint(link, p_G, along);
    }
  };
  AddLink(a, axes, ends_[0]);
  AddLink(b, -axes, ends_[a.body == b.body ? 0 : 1]);
}

void RigidWorld::AddTieRows() {
  for (const Tie& tie : ties_) {
    const PointTie& points = tie.points;
    const Vector3d p_GA = MotionOf(points.a).X_GL * points.p_A;
    const Vector3d p_GB = MotionOf(points.b).X_GL * points.p_B;
    FillEnds(points.a, points.b, 0.5 * (p_GA + p_GB), Matrix3d::Identity(), false);
    system_.AddTie(points.stiffness_n_per_m, points.damping_ns_per_m, p_GA - p_GB, tie.impulse_G,
                   ends_);
  }
}

void RigidWorld::AddJointRows(std::size_t i, double step_s) {
  const Joint& joint = joints_[i];
  if (!Moves(joint.at.body)) return;
  const TreeBody& tree = body(joint.at.body);
  const JointLaw& law = joint.law;
  double angle_rad = tree.angle_rad(joint.at.link), rate = tree.rate_rad_s(joint.at.link);
  if (joint.other_link >= 0) {
    angle_rad -= tree.angle_rad(joint.other_link);
    rate -= tree.rate_rad_s(joint.other_link);
  }
  const double to_low_rad = angle_rad - law.low_rad, to_high_rad = law.high_rad - angle_rad;
  const double reach_rad = kStepsAhead * step_s * std::abs(rate);
  if (law.friction_nm <= 0.0 && std::min(to_low_rad, to_high_rad) > reach_rad) return;

  const Eigen::Index first = first_[Place(joint.at.body)];
  JointRow row{.speed = first + tree.SpeedOf(joint.at.link), .first = first, .owner = i};
  TreeBody::Speeds answer = TreeBody::Speeds::Zero(tree.speeds().size());
  answer[tree.SpeedOf(joint.at.link)] = 1.0;
  if (joint.other_link >= 0) {
    row.other = first + tree.SpeedOf(joint.other_link);
    answer[tree.SpeedOf(joint.other_link)] = -1.0;
  }
  answer = tree.Answer(answer);
  if (law.friction_nm > 0.0) {
    row.high = step_s * law.friction_nm;
    row.low = -row.high;
    row.impulse = joint.rub;
    system_.AddJoint(row, answer);
  }
  row.low = 0.0;
  row.high = std::numeric_limits<double>::infinity();
  const double give = step_s * law.stop_nm_per_rad + law.stop_nms_per_rad;
  row.softness = give > 0.0 ? 1.0 / (step_s * give) : 0.0;
  const auto AddStop = [&](double gap_rad, double sign, double guess) {
    if (gap_rad > reach_rad) return;
    row.sign = sign;
    row.impulse = guess;
    row.bias_rad_s = gap_rad > 0.0 ? gap_rad / step_s : law.stop_nm_per_rad * gap_rad / give;
    system_.AddJoint(row, answer);
  };
  AddStop(to_low_rad, 1.0, joint.from_low);
  AddStop(to_high_rad, -1.0, joint.from_high);
}

void RigidWorld::AddContactRows(double step_s) {
  axes_.clear();
  for (WorldContact& contact : next_contacts_) {
    GoOnFromLastStep(contact, step_s);
    const Matrix3d axes = AxesAlong(contact.normal_G);
    axes_.push_back(axes);
    FillEnds(contact.a, contact.b, contact.p_G, axes, false);
    const ContactMaterial& material = contact.material;
    system_.AddContact(
        {contact.gap_m, material.friction, contact.share * material.stiffness_n_per_m,
         contact.share * material.damping_ns_per_m,
         axes.rightCols<2>().transpose() * contact.bend_G, contact.bend_kept},
        axes.transpose() * contact.impulse_G, ends_);
    if (material.rolling_resistance_m <= 0.0) continue;
    Matrix3d across;
    across << axes.rightCols<2>(), Vector3d::Zero();
    FillEnds(contact.a, contact.b, contact.p_G, across, true);
    system_.AddRolling(material.rolling_resistance_m, across.transpose() * contact.rolling_G, ends_,
                       Place(contact.rolling_contacts));
  }
}

// In the order in which the rows were added.
void RigidWorld::TakeJointImpulses() {
  for (std::size_t i = 0; i < ties_.size(); ++i) ties_[i].impulse_G = system_.tie_impulse(i);
  for (Joint& joint : joints_) joint.rub = joint.from_low = joint.from_high = 0.0;
  for (std::size_t i = 0; i < system_.joint_count(); ++i) {
    Joint& joint = joints_[system_.joint_row(i).owner];
    const JointRow& row = system_.joint_row(i);
    (row.low < 0.0 ? joint.rub : row.sign > 0.0 ? joint.from_low : joint.from_high) = row.impulse;
  }
}

void RigidWorld::TakeContactImpulses() {
  std::size_t rolling = 0;
  for (std::size_t i = 0; i < next_contacts_.size(); ++i) {
    WorldContact& contact = next_contacts_[i];
    const Matrix3d& axes = axes_[i];
    contact.impulse_G = axes * system_.contact_impulse(i);
    contact.bend_G = axes.rightCols<2>() * system_.contact_bend_m(i);
    contact.rolling_G.setZero();
    if (contact.material.rolling_resistance_m <= 0.0) continue;
    contact.rolling_G = axes.rightCols<2>() * system_.rolling_impulse(rolling++).head<2>();
  }
}

}  // namespace dockyard
