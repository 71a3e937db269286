#include "controller/vision/robust_planar_pose.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/geometry/decompositions.h"

namespace dockyard {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The object-space problem: V_i projects onto the line of sight i.
class ObjectSpace {
 public:
  ObjectSpace(const std::vector<Eigen::Vector2d>& points_B,
              const std::vector<Eigen::Vector2d>& sights) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points_B.size(); ++i) {
      const Eigen::Vector3d v(sights[i].x(), sights[i].y(), 1.0);
      points_.emplace_back(points_B[i].x(), points_B[i].y(), 0.0);
      lines_.push_back(v * v.transpose() / v.squaredNorm());
      sum += lines_.back();
    }
    const double n = static_cast<double>(points_.size());
    solve_ = (Eigen::Matrix3d::Identity() - sum / n).inverse() / n;
  }

  /// The best translation for a rotation (Lu et al., eq. 20).
  Eigen::Vector3d Translation(const Eigen::Matrix3d& R) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      sum += (lines_[i] - Eigen::Matrix3d::Identity()) * (R * points_[i]);
    }
    return solve_ * sum;
  }

  double Error(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) const {
    double error = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector3d q = R * points_[i] + t;
      error += (q - lines_[i] * q).squaredNorm();
    }
    return error;
  }

  /// Orthogonal iteration (Lu et al., section 3) from a rotation.
  PlanarMinimum Iterate(Eigen::Matrix3d R) const {
    constexpr int kLimit = 2000;     // converges linearly; slow where two minima are near
    constexpr double kStop = 1e-12;  // relative change of the error
    Eigen::Vector3d t = Translation(R);
    double error = Error(R, t);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points_) mean += p / static_cast<double>(points_.size());
    for (int i = 0; i < kLimit; ++i) {
      Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
      for (std::size_t k = 0; k < points_.size(); ++k) {
        M += (lines_[k] * (R * points_[k] + t)) * (points_[k] - mean).transpose();
      }
      R = NearestRotation(M);
      t = Translation(R);
      const double next = Error(R, t);
      const bool done = std::abs(error - next) <= kStop * (error + 1e-18);
      error = next;
      if (done) break;
    }
    return {.X_CB = {R, t}, .error = error};
  }

 private:
  Points points_;
  std::vector<Eigen::Matrix3d> lines_;
  Eigen::Matrix3d solve_;
};

/// A rotation to start from: weak perspective (Lu et al., section 4): the plane perpendicular to
/// the view.
Eigen::Matrix3d Start(const std::vector<Eigen::Vector2d>& points_B,
                      const std::vector<Eigen::Vector2d>& sights) {
  Eigen::Vector2d mean_b = Eigen::Vector2d::Zero(), mean_s = mean_b;
  const double n = static_cast<double>(points_B.size());
  for (std::size_t i = 0; i < points_B.size(); ++i) {
    mean_b += points_B[i] / n;
    mean_s += sights[i] / n;
  }
  double along = 0.0, across = 0.0;
  for (std::size_t i = 0; i < points_B.size(); ++i) {
    const Eigen::Vector2d b = points_B[i] - mean_b, s = sights[i] - mean_s;
    along += b.dot(s);
    across += b.x() * s.y() - b.y() * s.x();
  }
  return RotZ(std::atan2(across, along));
}

/// All minima over beta of the error of R_z(gamma) ... R_y(beta): with t on the z axis, the poses
/// that the ambiguity leaves are turns of the plane about one axis perpendicular to the view
/// (Schweighofer and Pinz, section 3).
std::vector<Eigen::Matrix3d> Minima(const ObjectSpace& space, const PlanarMinimum& first) {
  // R_t turns the translation onto the z axis; R_t R = R_z(a) R_y(b) R_z(c).
  const Eigen::Matrix3d R_t = RotationBetween(first.X_CB.p, Eigen::Vector3d::UnitZ());
  const Eigen::Matrix3d Q = R_t * first.X_CB.R;
  const double b = std::atan2(std::hypot(Q(2, 0), Q(2, 1)), Q(2, 2));
  if (std::sin(b) < 1e-9) return {};  // perpendicular to the view: nothing to turn about
  const double a = std::atan2(Q(1, 2), Q(0, 2)), c = std::atan2(Q(2, 1), -Q(2, 0));
  const auto rotation = [&](double beta) {
    return Eigen::Matrix3d(R_t.transpose() * RotZ(a) * RotY(beta) * RotZ(c));
  };
  const auto error = [&](double beta) {
    const Eigen::Matrix3d R = rotation(beta);
    return space.Error(R, space.Translation(R));
  };
  constexpr int kSteps = 180;
  std::vector<double> errors;
  const auto at = [](int i) { return kPi * (static_cast<double>(i) / kSteps - 0.5); };
  for (int i = 0; i <= kSteps; ++i) errors.push_back(error(at(i)));
  std::vector<Eigen::Matrix3d> minima;
  for (std::size_t i = 1; i + 1 < errors.size(); ++i) {
    if (errors[i] < errors[i - 1] && errors[i] <= errors[i + 1]) {
      minima.push_back(rotation(at(static_cast<int>(i))));
    }
  }
  return minima;
}

}  // namespace

std::vector<PlanarMinimum> RobustPlanarPose(const std::vector<Eigen::Vector2d>& points_B,
                                            const std::vector<Eigen::Vector2d>& sights) {
  if (points_B.size() < 4 || points_B.size() != sights.size()) return {};
  const ObjectSpace space(points_B, sights);
  std::vector<PlanarMinimum> minima{space.Iterate(Start(points_B, sights))};
  for (const Eigen::Matrix3d& R : Minima(space, minima[0])) {
    const PlanarMinimum minimum = space.Iterate(R);
    const bool known = std::any_of(minima.begin(), minima.end(), [&](const PlanarMinimum& other) {
      return Eigen::AngleAxisd(other.X_CB.R.transpose() * minimum.X_CB.R).angle() < Radians(0.5);
    });
    if (!known) minima.push_back(minimum);
  }
  std::erase_if(minima, [](const PlanarMinimum& m) {
    return !m.X_CB.p.allFinite() || !m.X_CB.R.allFinite() || m.X_CB.p.z() <= 0.0;
  });
  std::sort(minima.begin(), minima.end(),
            [](const PlanarMinimum& a, const PlanarMinimum& b) { return a.error < b.error; });
  return minima;
}

Eigen::Vector2d LinearSight(const Camera& camera, const Eigen::Vector2d& pixel) {
  return (pixel - camera.centre_px()).cwiseQuotient(camera.focal_px());
}

}  // namespace dockyard
