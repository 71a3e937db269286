#include "render/motion_blur.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "controller/base/check.h"
#include "render/four_floats.h"

namespace dockyard {
namespace {

// Between nodes this far apart the shift is linear: to 1e-4 of it for a lens of 90 deg.
constexpr int kCell_px = 16;
// The middle's weight is 1 - 5 d^2 / 48: 0.35 here, and below zero from 3.1 px on.
constexpr float kLongest_px = 2.5f;

/// The shift of a pixel is `far` + inverse_depth * `near`; each has a u and a v.
struct ShiftTerms {
  Eigen::Vector2d far = Eigen::Vector2d::Zero();   // by turning [px]
  Eigen::Vector2d near = Eigen::Vector2d::Zero();  // by displacement [px m]
};

// A point P of the camera frame at rest moves by -(shift + turn x P). The Jacobian of a
// projection is that of the ray's direction, divided by the distance.
ShiftTerms TermsAt(const Camera& camera, const ExposureMotion& motion,
                   const Eigen::Vector2d& pixel) {
  if (!camera.HasRay(pixel)) return {};
  const Eigen::Vector3d ray = camera.Direction(pixel);
  PixelJacobian J;
  if (!camera.Project(ray, J)) return {};
  return {-J * motion.turn_rad.cross(ray), -std::max(0.0, ray.z()) * (J * motion.shift_m)};
}

/// The terms at nodes over the image, and along a row by bilinear interpolation.
class ShiftGrid {
 public:
  ShiftGrid(const Camera& camera, const ExposureMotion& motion)
      : columns_((camera.width - 1) / kCell_px + 2), width_(camera.width) {
    const int rows = (camera.height - 1) / kCell_px + 2;
    nodes_.reserve(static_cast<std::size_t>(columns_) * rows);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const ShiftTerms terms = TermsAt(camera, motion, {column * kCell_px, row * kCell_px});
        nodes_.emplace_back(terms.far.x(), terms.far.y(), terms.near.x(), terms.near.y());
      }
    }
  }

  /// Into u and v: the shift [px] of each pixel of row y with these inverse depths.
  void Row(int y, const float* inverse_depth, float* u, float* v) const {
    const float down = static_cast<float>(y % kCell_px) / kCell_px;
    const Eigen::Vector4f* above = &nodes_[static_cast<std::size_t>(y / kCell_px) * columns_];
    const Eigen::Vector4f* below = above + columns_;
    for (int column = 0; column * kCell_px < width_; ++column) {
      const Eigen::Vector4f left = above[column] + down * (below[column] - above[column]);
      const Eigen::Vector4f right =
          above[column + 1] + down * (below[column + 1] - above[column + 1]);
      const Eigen::Vector4f step = (right - left) / kCell_px;
      const int first = column * kCell_px, count = std::min(kCell_px, width_ - first);
      for (int i = 0; i < count; ++i) {
        const auto along = static_cast<float>(i);
        const float q = inverse_depth[first + i];
        u[first + i] = left[0] + along * step[0] + q * (left[2] + along * step[2]);
        v[first + i] = left[1] + along * step[1] + q * (left[3] + along * step[3]);
      }
    }
  }

 private:
  int columns_, width_;
  std::vector<Eigen::Vector4f> nodes_;
};

/// A multiple of four at least as large: rows are blurred four pixels at a time.
int InFours(int count) { return (count + 3) / 4 * 4; }

Four Load(const float* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
Four Magnitude(Four a) { return a < 0.0f ? -a : a; }
Four Larger(Four a, Four b) { return a > b ? a : b; }

/// Rows of a copy of the image with a border that repeats the outermost pixels: two on the left,
/// at least two on the right.
class BorderedRows {
 public:
  explicit BorderedRows(const RadianceImage& image)
      : height_(image.height), stride_(InFours(image.width) + 4) {
    values_.resize(static_cast<std::size_t>(stride_) * height_);
    for (int y = 0; y < height_; ++y) {
      const float* from = &image.values[static_cast<std::size_t>(y) * image.width];
      float* to = &values_[static_cast<std::size_t>(y) * stride_];
      to[0] = to[1] = from[0];
      std::copy(from, from + image.width, to + 2);
      std::fill(to + 2 + image.width, to + stride_, from[image.width - 1]);
    }
  }
  /// Pixel 0 of row y, or of the nearest row.
  const float* Row(int y) const {
    return &values_[static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * stride_] + 2;
  }

 private:
  int height_, stride_;
  std::vector<float> values_;
};

// Derivatives of fourth order from five values, one pixel apart.
Four Slope(Four a, Four b, Four d, Four e) { return (a - e + 8.0f * (d - b)) / 12.0f; }
Four Curvature(Four a, Four b, Four c, Four d, Four e) {
  return (16.0f * (b + d) - a - e - 30.0f * c) / 12.0f;
}

/// Row y after the blur by the shifts u and v. All three have InFours(width) places.
void BlurRow(const BorderedRows& rows, int y, int width, const float* u, const float* v,
             float* out) {
  const std::array<const float*, 5> r{rows.Row(y - 2), rows.Row(y - 1), rows.Row(y),
                                      rows.Row(y + 1), rows.Row(y + 2)};
  const Four longest = kLongest_px - Four{};
  for (int x = 0; x < width; x += 4) {
    const auto slope = [&](int k) {
      const float* at = r[k] + x;
      return Slope(Load(at - 2), Load(at - 1), Load(at + 1), Load(at + 2));
    };
    const float* at = r[2] + x;
    const Four here = Load(at);
    const Four uu = Curvature(Load(at - 2), Load(at - 1), here, Load(at + 1), Load(at + 2));
    const Four vv = Curvature(Load(r[0] + x), Load(r[1] + x), here, Load(r[3] + x), Load(r[4] + x));
    const Four uv = Slope(slope(0), slope(1), slope(3), slope(4));
    Four du = Load(u + x), dv = Load(v + x);
    const Four scale = longest / Larger(longest, Larger(Magnitude(du), Magnitude(dv)));
    du *= scale;
    dv *= scale;
    const Four light = here + (du * du * uu + 2.0f * du * dv * uv + dv * dv * vv) / 24.0f;
    const Four blurred = Larger(light, Four{});
    std::memcpy(out + x, &blurred, sizeof blurred);
  }
}

/// Weights of five values one apart for the value at t from the middle one, |t| <= 1/2 (Lagrange).
std::array<float, 5> WeightsAt(float t) {
  const float one = t * t - 1.0f, four = t * t - 4.0f;
  return {t * one * (t - 2.0f) / 24.0f, -t * (t - 1.0f) * four / 6.0f, one * four / 4.0f,
          -t * (t + 1.0f) * four / 6.0f, t * one * (t + 2.0f) / 24.0f};
}

/// Of a place in pixels; off the image the outermost pixels go on.
float ValueAt(const RadianceImage& image, float u, float v) {
  const float column = std::floor(u + 0.5f), row = std::floor(v + 0.5f);
  const std::array<float, 5> along = WeightsAt(u - column), down = WeightsAt(v - row);
  float sum = 0.0f;
  for (int j = 0; j < 5; ++j) {
    const int y = std::clamp(static_cast<int>(row) + j - 2, 0, image.height - 1);
    const float* values = &image.values[static_cast<std::size_t>(y) * image.width];
    float line = 0.0f;
    for (int i = 0; i < 5; ++i) {
      line += along[i] * values[std::clamp(static_cast<int>(column) + i - 2, 0, image.width - 1)];
    }
    sum += down[j] * line;
  }
  return std::max(sum, 0.0f);
}

}  // namespace

ExposureMotion MotionOverExposure(const Eigen::Matrix3d& R_WB, const Eigen::Vector3d& v_WB_W,
                                  const Eigen::Vector3d& w_WB_W, double exposure_s) {
  const Eigen::Matrix3d R_BW = R_WB.transpose();
  return {exposure_s * (R_BW * v_WB_W), exposure_s * (R_BW * w_WB_W)};
}

ExposureMotion MotionOfCamera(const ExposureMotion& body, const Pose3& X_BC) {
  const Eigen::Matrix3d R_CB = X_BC.R.transpose();
  return {R_CB * (body.shift_m + body.turn_rad.cross(X_BC.p)), R_CB * body.turn_rad};
}

Eigen::Vector2d ImageShift_px(const Camera& camera, const ExposureMotion& camera_motion,
                              const Eigen::Vector2d& pixel, double inverse_depth) {
  const ShiftTerms terms = TermsAt(camera, camera_motion, pixel);
  return terms.far + inverse_depth * terms.near;
}

void BlurByMotion(const Camera& camera, const ExposureMotion& camera_motion, RadianceImage& image) {
  DOCKYARD_CHECK(image.width == camera.width && image.height == camera.height);
  DOCKYARD_CHECK(image.inverse_depth.size() == image.values.size());
  const ShiftGrid shifts(camera, camera_motion);
  const BorderedRows rows(image);
  const auto places = static_cast<std::size_t>(InFours(image.width));
  std::vector<float> u(places), v(places), out(places);
  for (int y = 0; y < image.height; ++y) {
    const std::size_t first = static_cast<std::size_t>(y) * image.width;
    shifts.Row(y, &image.inverse_depth[first], u.data(), v.data());
    BlurRow(rows, y, image.width, u.data(), v.data(), out.data());
    std::copy(out.begin(), out.begin() + image.width, &image.values[first]);
  }
}

void MoveRows(const Camera& camera, const ExposureMotion& camera_motion, const RowRange& rows,
              double middle, RadianceImage& image) {
  DOCKYARD_CHECK(image.width == camera.width && image.height == camera.height);
  DOCKYARD_CHECK(image.inverse_depth.size() == image.values.size());
  const ShiftGrid shifts(camera, camera_motion);
  const RadianceImage still = image;
  const auto places = static_cast<std::size_t>(InFours(image.width));
  std::vector<float> u(places), v(places);
  for (int y = rows.first; y < rows.end; ++y) {
    const std::size_t first = static_cast<std::size_t>(y) * image.width;
    shifts.Row(y, &still.inverse_depth[first], u.data(), v.data());
    const auto share = static_cast<float>((y + 0.5) / image.height - 0.5 - middle);
    for (int x = 0; x < image.width; ++x) {
      image.values[first + x] = ValueAt(still, static_cast<float>(x) - share * u[x],
                                        static_cast<float>(y) - share * v[x]);
    }
  }
}

}  // namespace dockyard
