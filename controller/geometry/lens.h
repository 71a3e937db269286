// The lens models: projection and its inverse. Lens frame: the camera frame C for the models with a
// focal length (z along the view, x right, y down); for CAHVORE the frame in which its vectors are
// written. Pixel (0, 0) is the centre of the first pixel.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <variant>

#include "controller/geometry/pose.h"

namespace dockyard {

using PixelJacobian = Eigen::Matrix<double, 2, 3>;  // d pixel / d point [px/m]

/// No lens here sees further off its axis.
inline constexpr double kWidestView_rad = 120.0 * kPi / 180.0;

/// The line of points that one pixel shows: origin + s direction, s > 0, direction of length 1.
struct LensRay {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // [m]; a central lens: its centre
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Fish-eye after Kannala and Brandt (IEEE TPAMI 28(8), 2006), as in OpenCV's fisheye module:
///   theta = angle off the axis,
///   rho = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8),
///   u = fx rho cos(phi) + cx,  v = fy rho sin(phi) + cy.
/// All k zero is the equidistant lens.
struct KannalaBrandt {
  double fx = 0.0, fy = 0.0;  // [px/rad], > 0
  double cx = 0.0, cy = 0.0;  // [px]
  std::array<double, 4> k{};  // k1..k4 [-]

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const KannalaBrandt&) const = default;
};

/// Pinhole with Brown's distortion (D. C. Brown, Photogrammetric Engineering 32(3), 1966), as in
/// OpenCV's projectPoints with five coefficients: with x, y = p.xy / p.z and r^2 = x^2 + y^2,
///   x' = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2),
///   y' = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y.
struct BrownPinhole {
  double fx = 0.0, fy = 0.0;                                // [px], > 0
  double cx = 0.0, cy = 0.0;                                // [px]
  double k1 = 0.0, k2 = 0.0, k3 = 0.0, p1 = 0.0, p2 = 0.0;  // [-]

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const BrownPinhole&) const = default;
};

/// CAHV, CAHVOR and CAHVORE (Yakimovsky and Cunningham 1978; Gennery 2001 and 2006). Equations in
/// docs/reference/cameras.md. CAHVOR is linearity 1 with E = 0, CAHV that with R = 0; the types 1,
/// 2, 3 of camera files are linearity 1, 0 and a number of its own. E != 0 moves the entrance pupil
/// along O with the angle: the lens has no single centre. A keeps the length that the file gives
/// it; O must have length 1, else the two directions disagree.
struct Cahvore {
  Eigen::Vector3d C = Eigen::Vector3d::Zero();   // centre [m]
  Eigen::Vector3d A = Eigen::Vector3d::UnitZ();  // axis of the image plane
  Eigen::Vector3d H = Eigen::Vector3d::UnitX();  // [px]
  Eigen::Vector3d V = Eigen::Vector3d::UnitY();  // [px]
  Eigen::Vector3d O = Eigen::Vector3d::UnitZ();  // axis of the lens, length 1
  Eigen::Vector3d R = Eigen::Vector3d::Zero();   // radial distortion [-]
  Eigen::Vector3d E = Eigen::Vector3d::Zero();   // entrance pupil [m]
  double linearity = 1.0;                        // -1 to 1

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const Cahvore&) const = default;
};

/// Pinhole with OpenCV's rational distortion (projectPoints with eight coefficients): BrownPinhole
/// with the radial factor
///   (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6).
struct RationalPinhole {
  double fx = 0.0, fy = 0.0;  // [px], > 0
  double cx = 0.0, cy = 0.0;  // [px]
  std::array<double, 6> k{};  // k1..k6 [-]
  double p1 = 0.0, p2 = 0.0;  // [-]

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const RationalPinhole&) const = default;
};

/// Two unit spheres, xi apart, and a pinhole (Usenko, Demmel and Cremers, 3DV 2018):
///   d1 = |p|, z1 = z + xi d1, d2 = |(x, y, z1)|, u = fx x / (alpha d2 + (1 - alpha) z1) + cx.
struct DoubleSphere {
  double fx = 0.0, fy = 0.0;     // [px], > 0
  double cx = 0.0, cy = 0.0;     // [px]
  double xi = 0.0, alpha = 0.0;  // -1 < xi <= 1, 0 <= alpha <= 1

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const DoubleSphere&) const = default;
};

/// Enhanced unified camera model (Khomutenko, Garcia and Martinet, RA-L 1(1), 2016):
///   d = sqrt(beta (x^2 + y^2) + z^2), u = fx x / (alpha d + (1 - alpha) z) + cx.
struct Eucm {
  double fx = 0.0, fy = 0.0;       // [px], > 0
  double cx = 0.0, cy = 0.0;       // [px]
  double alpha = 0.0, beta = 1.0;  // 0 <= alpha <= 1, beta > 0

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const Eucm&) const = default;
};

/// Omnidirectional camera (Mei and Rives, ICRA 2007), as in OpenCV's omnidir module without skew:
/// x, y = p.xy / (z + xi |p|), then BrownPinhole's distortion with k3 = 0.
struct Omni {
  double fx = 0.0, fy = 0.0;                      // [px], > 0
  double cx = 0.0, cy = 0.0;                      // [px]
  double xi = 0.0;                                // >= 0
  double k1 = 0.0, k2 = 0.0, p1 = 0.0, p2 = 0.0;  // [-]

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const Omni&) const = default;
};

/// Field-of-view lens (Devernay and Faugeras, Machine Vision and Applications 13, 2001): with r the
/// distance off the axis at depth 1, it shows the point at r' = atan(2 r tan(w / 2)) / w.
struct FovPinhole {
  double fx = 0.0, fy = 0.0;  // [px], > 0
  double cx = 0.0, cy = 0.0;  // [px]
  double w_rad = 1.0;         // > 0, < pi

  std::optional<Eigen::Vector2d> Project(const Eigen::Vector3d& p, PixelJacobian* J) const;
  LensRay Ray(const Eigen::Vector2d& pixel) const;
  bool operator==(const FovPinhole&) const = default;
};

/// Horizontal and vertical focal length and centre of a CAHV* model [px]: hs, vs, hc, vc.
struct CahvScales {
  double hs = 0.0, vs = 0.0, hc = 0.0, vc = 0.0;
};
CahvScales ScalesOf(const Cahvore& lens);

/// The camera frame of a lens whose vectors stand in a frame F: at C, z along A, x along the part
/// of H across A.
Pose3 CameraFrameOf(const Cahvore& lens_F);
/// The same lens with its vectors in the frame G.
Cahvore InFrame(const Cahvore& lens_F, const Pose3& X_FG);

using Lens = std::variant<KannalaBrandt, BrownPinhole, Cahvore, RationalPinhole, DoubleSphere, Eucm,
                          Omni, FovPinhole>;

}  // namespace dockyard
