#include <Eigen/Geometry>
#include <cmath>

#include "controller/geometry/lens.h"

namespace dockyard {
namespace {

// How the angle theta off O becomes a distance chi on the image plane, and its derivative.
struct Curve {
  double chi = 0.0, slope = 0.0;
};

std::optional<Curve> CurveAt(double linearity, double theta) {
  const double bent = linearity * theta;
  if (!(std::abs(bent) < kPi / 2) || theta > kWidestView_rad) return std::nullopt;
  if (linearity == 0.0) return Curve{theta, 1.0};
  if (linearity < 0.0) return Curve{std::sin(bent) / linearity, std::cos(bent)};
  const double tangent = std::tan(bent);
  return Curve{tangent / linearity, 1.0 + tangent * tangent};
}

double ThetaOf(double linearity, double chi) {
  if (linearity == 0.0) return std::min(chi, kWidestView_rad);
  if (linearity > 0.0) return std::min(std::atan(linearity * chi) / linearity, kWidestView_rad);
  return std::min(std::asin(std::max(linearity * chi, -1.0)) / linearity, kWidestView_rad);
}

/// Share by which radial distortion lengthens chi, mu, and d (chi (1 + mu)) / d chi.
double Mu(const Eigen::Vector3d& R, double chi) {
  const double c2 = chi * chi;
  return R[0] + c2 * (R[1] + c2 * R[2]);
}
double Spread(const Eigen::Vector3d& R, double chi) {
  const double c2 = chi * chi;
  return 1.0 + R[0] + c2 * (3.0 * R[1] + c2 * 5.0 * R[2]);
}

/// The angle at which a point off the axis by `across`, ahead by `ahead`, meets the pupil, and the
/// derivative of the equation that sets it. None where Newton's method finds none: at the pupil.
struct Incidence {
  double theta = 0.0, slope = 0.0;
};
std::optional<Incidence> IncidenceOf(const Eigen::Vector3d& E, double ahead, double across) {
  double theta = std::atan2(across, ahead);
  if (E.isZero(0.0)) return Incidence{theta, std::hypot(ahead, across)};
  double slope = 0.0, last = 1e300;
  for (int i = 0; i < 50; ++i) {
    const double s = std::sin(theta), c = std::cos(theta), t2 = theta * theta;
    const double pupil = E[0] + t2 * (E[1] + t2 * E[2]);
    slope = ahead * c + across * s - (1.0 - c) * pupil -
            (theta - s) * theta * (2.0 * E[1] + 4.0 * t2 * E[2]);
    if (!(slope > 0.0)) return std::nullopt;
    const double step = (ahead * s - across * c - (theta - s) * pupil) / slope;
    theta -= step;
    if (std::abs(step) < 1e-15 || (std::abs(step) < 1e-13 && std::abs(step) >= last)) {
      return theta >= 0.0 ? std::optional(Incidence{theta, slope}) : std::nullopt;
    }
    last = std::abs(step);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Eigen::Vector2d> Cahvore::Project(const Eigen::Vector3d& point,
                                                PixelJacobian* J) const {
  const Eigen::Vector3d p = point - C;
  const double ahead = p.dot(O);
  const Eigen::Vector3d l = p - ahead * O;
  const double across = l.norm();
  if (across == 0.0 && ahead <= 0.0) return std::nullopt;
  const auto incidence = IncidenceOf(E, ahead, across);
  if (!incidence) return std::nullopt;
  const auto curve = CurveAt(linearity, incidence->theta);
  if (!curve || !(Spread(R, curve->chi) > 0.0)) return std::nullopt;
  const double chi = curve->chi;
  const bool on_axis = chi < 1e-7;  // the quotients below lose their digits; their limits hold
  const double depth = on_axis ? ahead : across / chi;
  const double mu = Mu(R, chi);
  const Eigen::Vector3d image = depth * O + (1.0 + mu) * l;  // the point as CAHV alone shows it
  const double w = image.dot(A);
  if (!(w > 0.0)) return std::nullopt;
  const Eigen::Vector2d pixel(image.dot(H) / w, image.dot(V) / w);
  if (J) {
    const Eigen::RowVector3d d_ahead = O.transpose();
    Eigen::RowVector3d d_depth = d_ahead, d_mu = Eigen::RowVector3d::Zero();
    if (!on_axis) {
      const double s = std::sin(incidence->theta), c = std::cos(incidence->theta);
      const Eigen::RowVector3d d_across = l.transpose() / across;
      const Eigen::RowVector3d d_chi =
          curve->slope / incidence->slope * (c * d_across - s * d_ahead);
      d_depth = (d_across - depth * d_chi) / chi;
      d_mu = chi * (2.0 * R[1] + 4.0 * R[2] * chi * chi) * d_chi;
    }
    const Eigen::Matrix3d d_image =
        O * d_depth + l * d_mu + (1.0 + mu) * (Eigen::Matrix3d::Identity() - O * d_ahead);
    J->row(0) = (H - pixel.x() * A).transpose() * d_image / w;
    J->row(1) = (V - pixel.y() * A).transpose() * d_image / w;
  }
  return pixel;
}

LensRay Cahvore::Ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector3d image = (V - pixel.y() * A).cross(H - pixel.x() * A) / A.dot(V.cross(H));
  const double ahead = image.dot(O);
  const Eigen::Vector3d l = image - ahead * O;
  const double across = l.norm();
  if (across == 0.0) return {.origin = C, .direction = O};
  // A pixel behind the lens's own plane has no ray: the widest ray stands for it.
  const double seen = ahead > 0.0 ? across / ahead : 1e6;
  double chi = seen;
  while (!(Spread(R, chi) > 0.0) && chi > 1e-3) chi *= 0.8;
  for (int i = 0; i < 50; ++i) {
    const double slope = Spread(R, chi);
    if (!(slope > 1e-6)) break;  // beyond the polynomial's peak no pixel has a ray
    const double step = (chi * (1.0 + Mu(R, chi)) - seen) / slope;
    chi -= step;
    if (std::abs(step) < 1e-16 * (1.0 + chi)) break;
  }
  const double theta = ThetaOf(linearity, std::max(chi, 0.0));
  const double s = std::sin(theta), t2 = theta * theta;
  const double pupil = s > 1e-8 ? (theta / s - 1.0) * (E[0] + t2 * (E[1] + t2 * E[2])) : 0.0;
  return {.origin = C + pupil * O, .direction = s / across * l + std::cos(theta) * O};
}

Pose3 CameraFrameOf(const Cahvore& lens_F) {
  const Eigen::Vector3d z = lens_F.A.normalized();
  const Eigen::Vector3d x = (lens_F.H - lens_F.H.dot(z) * z).normalized();
  Pose3 X_FC;
  X_FC.R << x, z.cross(x), z;
  X_FC.p = lens_F.C;
  return X_FC;
}

Cahvore InFrame(const Cahvore& lens_F, const Pose3& X_FG) {
  Cahvore lens = lens_F;
  lens.C = Inverse(X_FG) * lens_F.C;
  for (Eigen::Vector3d* v : {&lens.A, &lens.H, &lens.V, &lens.O}) *v = X_FG.R.transpose() * *v;
  return lens;
}

CahvScales ScalesOf(const Cahvore& lens) {
  return {.hs = lens.A.cross(lens.H).norm(),
          .vs = lens.A.cross(lens.V).norm(),
          .hc = lens.A.dot(lens.H),
          .vc = lens.A.dot(lens.V)};
}

}  // namespace dockyard
