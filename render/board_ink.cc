#include "render/board_ink.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/base/two_widths.h"
#include "render/board_wear.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

// Share of a footprint that reaches `reach` to both sides where a distance is below zero.
float Below(float distance, float reach) {
  return std::clamp(0.5f - distance / std::max(2.0f * reach, 1e-9f), 0.0f, 1.0f);
}

}  // namespace

float DustShare(const BoardView& board, const Eigen::Vector2f& p_B) {
  double cover = board.dust_cover;
  for (const DustySpot& spot : board.dusty_spots) {
    const bool inside = (p_B - spot.p_B.cast<float>()).norm() < static_cast<float>(spot.radius_m);
    if (inside) cover = std::max(cover, spot.cover);
  }
  if (cover <= 0.0) return 0.0f;
  float patches = 0.0f;  // 0 to 1, mean 1/2
  for (const auto& [size_m, part] : {std::pair(0.08f, 0.6f), {0.02f, 0.4f}}) {
    const float x = p_B.x() / size_m, y = p_B.y() / size_m;
    const std::uint64_t seed = board.dust_seed + (size_m > 0.05f ? 0u : 1u);
    const float ix = std::floor(x), iy = std::floor(y);
    const auto knot = [&](int dx, int dy) {
      const auto column = static_cast<std::uint32_t>(static_cast<int>(ix) + dx);
      const auto row = static_cast<std::uint32_t>(static_cast<int>(iy) + dy);
      return static_cast<float>(HashUniform(seed, std::uint64_t{row} << 32 | column));
    };
    const auto smooth = [](float t) { return t * t * (3.0f - 2.0f * t); };
    const float fx = smooth(x - ix), fy = smooth(y - iy);
    const float top = knot(0, 0) + fx * (knot(1, 0) - knot(0, 0));
    const float low = knot(0, 1) + fx * (knot(1, 1) - knot(0, 1));
    patches += part * (top + fy * (low - top));
  }
  return std::min(static_cast<float>(cover) * (0.5f + patches), 1.0f);
}

BoardShader::BoardShader(const BoardView& view, const Pose3& X_WC) : view_(view) {
  const Pose3 X_CB = Inverse(X_WC) * view.X_WB;
  // A point (x, y) of the board lies at x e1 + y e2 + p in the camera; tan is that over its depth.
  Eigen::Matrix3d tan_from_board;
  tan_from_board << X_CB.R.col(0), X_CB.R.col(1), X_CB.p;
  board_from_tan_ = tan_from_board.inverse().cast<float>();
  printed_side_ = X_CB.R.col(2).dot(X_CB.p) > 0.0;
  normal_W_ = (printed_side_ ? -1.0 : 1.0) * view.X_WB.R.col(2);
  X_BC_ = Inverse(X_CB);
  if (view.flatness_m != 0.0) bent_.emplace(view);
  for (const Fiducial& f : view.board.fiducials) {
    // Counter-clockwise for the viewer is towards -y, for y points down.
    marks_.push_back({static_cast<float>(f.p_BF.x()), static_cast<float>(f.p_BF.y()),
                      static_cast<float>(std::cos(f.rotation)),
                      static_cast<float>(-std::sin(f.rotation))});
  }
  radius_ = static_cast<float>(0.5 * view.board.disc_diameter_m);
  for (const SquareTag& tag : view.board.tags) {
    const TagInk& ink = tags_.emplace_back(tag);
    marks_.push_back(
        {static_cast<float>(tag.p_BT.x()), static_cast<float>(tag.p_BT.y()), 1.0f, 0.0f});
    radius_ = std::max(radius_, static_cast<float>(ink.radius_m()));
  }
  half_length_ = static_cast<float>(0.5 * view.board.bar_length_m);
  half_width_ = static_cast<float>(0.5 * view.board.bar_width_m);
}

BoardShader::Spot BoardShader::SpotAt(Tan tan) const {
  const Eigen::Vector2d p = bent_->Meet(X_BC_.p, X_BC_.R * Eigen::Vector3d(tan.x, tan.y, 1.0));
  const Eigen::Vector3d n_B = (printed_side_ ? 1.0 : -1.0) * bent_->Normal(p);
  return {(Inverse(X_BC_) * bent_->At(p)).cast<float>(), (X_BC_.R.transpose() * n_B).cast<float>()};
}

Eigen::Vector2f BoardShader::ToBoard(Tan tan) const {
  if (bent_) {
    const Eigen::Vector3d ray(tan.x, tan.y, 1.0);
    return bent_->Meet(X_BC_.p, X_BC_.R * ray).cast<float>();
  }
  const Eigen::Matrix3f& h = board_from_tan_;
  const float scale = 1.0f / (h(2, 0) * tan.x + h(2, 1) * tan.y + h(2, 2));
  return {(h(0, 0) * tan.x + h(0, 1) * tan.y + h(0, 2)) * scale,
          (h(1, 0) * tan.x + h(1, 1) * tan.y + h(1, 2)) * scale};
}

float BoardShader::InkAt(const Mark& mark, const Eigen::Vector2f& p, const Eigen::Vector2f& step_x,
                         const Eigen::Vector2f& step_y) const {
  const Eigen::Vector2f q(p.x() - mark.x, p.y() - mark.y);
  const auto reach = [&](float nx, float ny) {
    const float x = nx * step_x.x() + ny * step_x.y(), y = nx * step_y.x() + ny * step_y.y();
    return 0.5f * std::sqrt(x * x + y * y);
  };
  const float r = std::max(std::sqrt(q.x() * q.x() + q.y() * q.y()), 1e-6f);
  const float disc = Below(r - radius_, reach(q.x() / r, q.y() / r));
  const float a = std::abs(q.x() * mark.along_x + q.y() * mark.along_y) - half_length_;
  const float b = std::abs(q.y() * mark.along_x - q.x() * mark.along_y) - half_width_;
  const float bar =
      Below(a, reach(mark.along_x, mark.along_y)) * Below(b, reach(-mark.along_y, mark.along_x));
  return disc * (1.0f - bar);
}

std::array<Eigen::Vector2f, 4> BoardShader::Footprint(const PixelCorners& c) const {
  return {ToBoard(c[0]), ToBoard(c[1]), ToBoard(c[3]), ToBoard(c[2])};
}

float BoardShader::TagShare(const std::array<Eigen::Vector2f, 4>& footprint_B) const {
  double ink = 0.0;
  for (const TagInk& tag : tags_) ink += tag.Share(footprint_B);
  return static_cast<float>(std::min(ink, 1.0));
}

float BoardShader::InkShare(const PixelCorners& c) const {
  if (!printed_side_) return 0.0f;
  const float ink = tags_.empty() ? DiscShare(c) : TagShare(Footprint(c));
  if (ink == 0.0f || view_.wear <= 0.0) return ink;
  return ink * (1.0f - FlakedShare(view_, Footprint(c)));
}

float BoardShader::DiscShare(const PixelCorners& c) const {
  const Eigen::Vector2f middle = ToBoard(
      {0.25f * (c[0].x + c[1].x + c[2].x + c[3].x), 0.25f * (c[0].y + c[1].y + c[2].y + c[3].y)});
  const Mark* near = nullptr;
  float nearest = 1e9f;
  for (const Mark& mark : marks_) {
    const float dx = middle.x() - mark.x, dy = middle.y() - mark.y;
    const float squared = dx * dx + dy * dy;
    if (squared < nearest) {
      nearest = squared;
      near = &mark;
    }
  }
  const Eigen::Vector2f p00 = ToBoard(c[0]), p10 = ToBoard(c[1]), p01 = ToBoard(c[2]),
                        p11 = ToBoard(c[3]);
  const float span = std::max((p11 - p00).cwiseAbs().maxCoeff(), (p01 - p10).cwiseAbs().maxCoeff());
  const float beyond = radius_ + span;
  if (nearest > beyond * beyond) return 0.0f;
  constexpr int kParts = 4;  // a side: the corner of an edge is flat enough by then
  const Eigen::Vector2f step_x = (0.5f / kParts) * (p10 + p11 - p00 - p01);
  const Eigen::Vector2f step_y = (0.5f / kParts) * (p01 + p11 - p00 - p10);
  const float one = InkAt(*near, middle, 2.0f * kParts * step_x, 2.0f * kParts * step_y);
  if (one == 0.0f || one == 1.0f) return one;  // no edge as near as a pixel
  float sum = 0.0f;
  for (int j = 0; j < kParts; ++j) {
    const float v = (static_cast<float>(j) + 0.5f) / kParts;
    for (int i = 0; i < kParts; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) / kParts;
      const Eigen::Vector2f p = (1 - v) * ((1 - u) * p00 + u * p10) + v * ((1 - u) * p01 + u * p11);
      sum += InkAt(*near, p, step_x, step_y);
    }
  }
  return sum / (kParts * kParts);
}

// Asks what InkShare asks at first, of many pixels at once.
DOCKYARD_TWO_WIDTHS
void BoardShader::NearMarks(const PixelRow& row, int first, int count, std::uint8_t* near) const {
  constexpr int kMost = kBoardAtOnce;
  const Eigen::Matrix3f h = board_from_tan_;
  const float* __restrict mx = &row.x[first];
  const float* __restrict my = &row.y[first];
  const float* __restrict ax = &row.along_x[first];
  const float* __restrict ay = &row.along_y[first];
  const float* __restrict dx = &row.down_x[first];
  const float* __restrict dy = &row.down_y[first];
  float p_x[kMost], p_y[kMost], nearest[kMost], span[kMost], other[kMost];
  // Board places of a corner, over that of the one across from it.
  const auto reach = [&](float u, float v, float* out) {
    for (int i = 0; i < count; ++i) {
      const float ax_ = u * ax[i], ay_ = u * ay[i], dx_ = v * dx[i], dy_ = v * dy[i];
      const float x0 = mx[i] + ax_ + dx_, y0 = my[i] + ay_ + dy_;
      const float x1 = mx[i] - ax_ - dx_, y1 = my[i] - ay_ - dy_;
      const float s0 = 1.0f / (h(2, 0) * x0 + h(2, 1) * y0 + h(2, 2));
      const float s1 = 1.0f / (h(2, 0) * x1 + h(2, 1) * y1 + h(2, 2));
      const float bx = (h(0, 0) * x0 + h(0, 1) * y0 + h(0, 2)) * s0 -
                       (h(0, 0) * x1 + h(0, 1) * y1 + h(0, 2)) * s1;
      const float by = (h(1, 0) * x0 + h(1, 1) * y0 + h(1, 2)) * s0 -
                       (h(1, 0) * x1 + h(1, 1) * y1 + h(1, 2)) * s1;
      out[i] = std::max(std::abs(bx), std::abs(by));
    }
  };
  for (int i = 0; i < count; ++i) {
    const float scale = 1.0f / (h(2, 0) * mx[i] + h(2, 1) * my[i] + h(2, 2));
    p_x[i] = (h(0, 0) * mx[i] + h(0, 1) * my[i] + h(0, 2)) * scale;
    p_y[i] = (h(1, 0) * mx[i] + h(1, 1) * my[i] + h(1, 2)) * scale;
    nearest[i] = 1e9f;
  }
  for (const Mark& mark : marks_) {
    for (int i = 0; i < count; ++i) {
      const float x = p_x[i] - mark.x, y = p_y[i] - mark.y;
      nearest[i] = std::min(nearest[i], x * x + y * y);
    }
  }
  reach(0.5f, 0.5f, span);
  reach(0.5f, -0.5f, other);
  for (int i = 0; i < count; ++i) {
    constexpr float kRounding = 1.0001f;
    const float beyond = kRounding * (radius_ + std::max(span[i], other[i]));
    near[i] = nearest[i] > beyond * beyond ? 0 : 1;
  }
}

float BoardShader::DustAt(const PixelCorners& c) const {
  return DustShare(view_, ToBoard({0.25f * (c[0].x + c[1].x + c[2].x + c[3].x),
                                   0.25f * (c[0].y + c[1].y + c[2].y + c[3].y)}));
}

}  // namespace dockyard
