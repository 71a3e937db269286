#include "render/compose.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/board_ink.h"
#include "render/ground_mesh.h"

namespace dockyard {
namespace {

constexpr int kRays = 4;  // of a pixel: the middles of its quarters
// A shaded facet's normal and its plane differ by the sagitta of its curve.
constexpr float kCurvedBias_m = 0.003f, kFlatBias_m = 0.001f;
// Points of the sun's disc: to find casters, to measure their cover.
constexpr int kSearches = 4, kPoints = 8, kBoardSearches = 8, kBoardPoints = 16;

// A flat view's own pixels from the tan plane.
struct Sampler {
  explicit Sampler(const FlatView& v)
      : view(v),
        sx(static_cast<float>(v.width / (v.rect.right - v.rect.left))),
        sy(static_cast<float>(v.height / (v.rect.bottom - v.rect.top))),
        x0(static_cast<float>(v.rect.left)),
        y0(static_cast<float>(v.rect.top)) {}

  int Column(float tan_x) const { return static_cast<int>((tan_x - x0) * sx); }
  int Row(float tan_y) const { return static_cast<int>((tan_y - y0) * sy); }
  const Seen& At(int x, int y) const {
    return view.seen[static_cast<std::size_t>(y) * view.width + x];
  }
  // Whether any thin body may touch the pixels from (x1, y1) to (x2, y2).
  bool HasThin(int x1, int y1, int x2, int y2) const {
    return x2 >= view.thin_x && x1 < view.thin_x + view.thin_width && y2 >= view.thin_y &&
           y1 < view.thin_y + view.thin_height;
  }
  // Bilinear, for the bodies are drawn hardly wider than the rays are apart.
  Thin ThinAt(Tan tan) const {
    const float x = (tan.x - x0) * sx - 0.5f, y = (tan.y - y0) * sy - 0.5f;
    const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy);
    Thin sum;
    for (int k = 0; k < 4; ++k) {
      const int tx = ix + (k & 1) - view.thin_x, ty = iy + (k >> 1) - view.thin_y;
      if (tx < 0 || ty < 0 || tx >= view.thin_width || ty >= view.thin_height) continue;
      const float weight = ((k & 1) ? fx : 1.0f - fx) * ((k & 2) ? fy : 1.0f - fy);
      Add(view.thin[static_cast<std::size_t>(ty) * view.thin_width + tx], weight, sum);
    }
    return sum;
  }
  static void Add(const Thin& thin, float weight, Thin& sum) {
    sum.to_sun += weight * thin.to_sun;
    sum.to_zenith += weight * thin.to_zenith;
    sum.inverse_depth += weight * thin.inverse_depth;
    sum.cover += weight * thin.cover;
  }
  bool Holds(Tan tan) const {
    const float x = (tan.x - x0) * sx, y = (tan.y - y0) * sy;
    return x >= 0.0f && y >= 0.0f && x < static_cast<float>(view.width) &&
           y < static_cast<float>(view.height);
  }

  const FlatView& view;
  float sx, sy, x0, y0;
};

// Sky twice as bright at the horizon as overhead (assumed, 1-3 for a clear sky); over the level
// surface it adds up to the whole sky's irradiance: 2 * integral of 0.75 (2 - s) s ds = 1.
class SkyShader {
 public:
  SkyShader(const Scene& scene, const Pose3& X_WC, Channel channel)
      : up_C_(X_WC.R.row(2).transpose().cast<float>()),
        sun_C_((X_WC.R.transpose() * scene.light.to_sun_W).cast<float>()) {
    const Reflected r = Reflect(scene.light, Eigen::Vector3d::Ones(), channel);
    const double radius = 0.5 * scene.light.sun_angular_diameter_rad;
    sky_ = static_cast<float>(r.sky) * kInversePi;
    bounce_ = static_cast<float>(r.bounce) * kInversePi;
    near_sun_ = static_cast<float>(std::cos(radius));
    if (radius > 0.0) disc_ = static_cast<float>(r.sun / (kPi * radius * radius));
  }
  float operator()(Tan tan) const {
    const float shorten = 1.0f / std::sqrt(1.0f + tan.x * tan.x + tan.y * tan.y);
    const float s = (up_C_.x() * tan.x + up_C_.y() * tan.y + up_C_.z()) * shorten;
    const float cosine = (sun_C_.x() * tan.x + sun_C_.y() * tan.y + sun_C_.z()) * shorten;
    const float sky = s > 0.0f ? sky_ * 0.75f * (2.0f - s) : bounce_;
    return cosine > near_sun_ ? sky + disc_ : sky;
  }

 private:
  Eigen::Vector3f up_C_, sun_C_;
  float sky_, bounce_, near_sun_, disc_ = 0.0f;
};

// Objects' and thin bodies' light, and any place's share of the sun.
class ObjectShader {
 public:
  ObjectShader(const Lit& lit, const Pose3& X_WC, Channel channel)
      : shadow_(lit.shadow), thin_(ToFloats(lit.scene, lit.scene.tether.albedo, channel)) {
    const Pose3 X_UC = Inverse(shadow_.fit().X_WU) * X_WC;
    R_UC_ = X_UC.R.cast<float>();
    p_UC_ = X_UC.p.cast<float>();
    up_U_ = shadow_.fit().X_WU.R.row(2).transpose().cast<float>();
    for (const SceneObject& object : lit.scene.objects) {
      objects_.push_back(ToFloats(lit.scene, object.albedo, channel));
    }
    const BoardView& board = lit.scene.board;
    n_board_U_ = (shadow_.fit().X_WU.R.transpose() * board.X_WB.R.col(2)).cast<float>();
    const Eigen::Vector3d p_B = Inverse(board.X_WB) * X_WC.p;
    const Eigen::Vector3d n_C = X_WC.R.transpose() * board.X_WB.R.col(2);
    board_plane_C_ = (n_C / n_C.dot(X_WC.R.transpose() * (board.X_WB.p - X_WC.p))).cast<float>();
    if (p_B.z() < 0.0) n_board_U_ = -n_board_U_;  // its face, which looks along -z
  }

  float operator()(const Seen& seen, Tan tan, float blur, int turn) const {
    const Eigen::Vector3f n = UnpackNormal(seen);
    const Floats& f = objects_[static_cast<std::size_t>(ObjectOf(seen))];
    const float share =
        n.z() > 0.0f ? Share(tan, -seen.code, n, kCurvedBias_m, blur, turn, kSearches, kPoints)
                     : 0.0f;
    return Shade(f.sun, f.sky, f.bounce, n.z(), n.dot(up_U_), share);
  }
  float BoardShare(Tan tan, float blur, int turn) const {
    if (n_board_U_.z() <= 0.0f) return 0.0f;
    // Its plane is known better than any ray's depth.
    const float inverse_depth =
        board_plane_C_.x() * tan.x + board_plane_C_.y() * tan.y + board_plane_C_.z();
    return Share(tan, inverse_depth, n_board_U_, kFlatBias_m, blur, turn, kBoardSearches,
                 kBoardPoints);
  }
  /// Radiance times cover.
  float OfThin(const Thin& thin, Tan tan, float blur, int turn) const {
    const float per = 1.0f / thin.cover;
    const float share = Share(tan, thin.inverse_depth * per, Eigen::Vector3f::UnitZ(),
                              kCurvedBias_m, blur, turn, kSearches, kPoints);
    return thin.cover * Shade(thin_.sun, thin_.sky, thin_.bounce, thin.to_sun * per,
                              thin.to_zenith * per, share);
  }

 private:
  struct Floats {
    float sun, sky, bounce;
  };
  static Floats ToFloats(const Scene& scene, const Eigen::Vector3d& albedo, Channel channel) {
    const Reflected r = Reflect(scene.light, albedo, channel);
    return {static_cast<float>(r.sun), static_cast<float>(r.sky), static_cast<float>(r.bounce)};
  }
  float Share(Tan tan, float inverse_depth, const Eigen::Vector3f& n, float bias, float blur,
              int turn, int searches, int points) const {
    const float z = 1.0f / inverse_depth;
    return shadow_.Share({.p = p_UC_ + R_UC_ * Eigen::Vector3f(z * tan.x, z * tan.y, z),
                          .n = n,
                          .bias_m = bias,
                          .blur_m = blur * z,
                          .turn = turn},
                         searches, points);
  }

  const SunShadow& shadow_;
  Floats thin_;
  std::vector<Floats> objects_;
  Eigen::Matrix3f R_UC_;
  Eigen::Vector3f p_UC_, up_U_, n_board_U_, board_plane_C_;
};

// The pixels of one row: where their middles look, and how that changes along and down the picture.
struct Row {
  explicit Row(int width)
      : x(width), y(width), along_x(width), along_y(width), down_x(width), down_y(width) {}

  void Fill(const PixelGrid& grid, int row) {
    const std::size_t first = static_cast<std::size_t>(row) * (grid.width + 1);
    const float *ax = &grid.x[first], *ay = &grid.y[first];
    const float *bx = ax + grid.width + 1, *by = ay + grid.width + 1;
    for (int i = 0; i < grid.width; ++i) {
      x[i] = 0.25f * (ax[i] + ax[i + 1] + bx[i] + bx[i + 1]);
      y[i] = 0.25f * (ay[i] + ay[i + 1] + by[i] + by[i + 1]);
      along_x[i] = 0.5f * (ax[i + 1] + bx[i + 1] - ax[i] - bx[i]);
      along_y[i] = 0.5f * (ay[i + 1] + by[i + 1] - ay[i] - by[i]);
      down_x[i] = 0.5f * (bx[i] + bx[i + 1] - ax[i] - ax[i + 1]);
      down_y[i] = 0.5f * (by[i] + by[i + 1] - ay[i] - ay[i + 1]);
    }
  }

  std::vector<float> x, y, along_x, along_y, down_x, down_y;
};

struct Pixel {
  Tan middle, along, down;
  int turn;

  float blur() const {  // half its width
    return 0.25f * (std::abs(along.x) + std::abs(along.y) + std::abs(down.x) + std::abs(down.y));
  }
  Tan Ray(int k) const {
    const float u = (k & 1) ? 0.25f : -0.25f, v = (k & 2) ? 0.25f : -0.25f;
    return {middle.x + u * along.x + v * down.x, middle.y + u * along.y + v * down.y};
  }
  PixelCorners corners() const {
    PixelCorners c;
    for (int k = 0; k < 4; ++k) {
      const float u = (k & 1) ? 0.5f : -0.5f, v = (k & 2) ? 0.5f : -0.5f;
      c[k] = {middle.x + u * along.x + v * down.x, middle.y + u * along.y + v * down.y};
    }
    return c;
  }
};

// Scatters neighbouring pixels (Jimenez, SIGGRAPH 2014, interleaved gradient noise).
int Turn(int x, int y) {
  const float a = 0.06711056f * static_cast<float>(x) + 0.00583715f * static_cast<float>(y);
  const float b = 52.9829189f * (a - static_cast<float>(static_cast<int>(a)));
  const float c = b - static_cast<float>(static_cast<int>(b));
  return std::min(static_cast<int>(c * SunShadow::kTurns), SunShadow::kTurns - 1);
}

// One camera's picture.
class Composer {
 public:
  Composer(const FlatView& wide, const FlatView* close, const Lit& lit, const Pose3& X_WC,
           Channel channel)
      : wide_(wide), sky_(lit.scene, X_WC, channel), objects_(lit, X_WC, channel) {
    if (close) close_.emplace(*close);
    if (HasGround(lit.scene.ground)) {
      ground_.emplace(lit.ground, lit.scene, lit.shadow, X_WC, channel);
    }
    if (lit.scene.board.board.width_m > 0.0) board_.emplace(lit.scene, X_WC, channel);
  }

  float operator()(const Pixel& pixel) const {
    const Sampler& view = close_ && HeldClose(pixel) ? *close_ : wide_;
    int at[kRays][2];
    Seen seen[kRays];
    for (int k = 0; k < kRays; ++k) {
      const Tan tan = pixel.Ray(k);
      at[k][0] = view.Column(tan.x);
      at[k][1] = view.Row(tan.y);
      seen[k] = view.At(at[k][0], at[k][1]);
    }
    const float least =
        std::min(std::min(seen[0].code, seen[1].code), std::min(seen[2].code, seen[3].code));
    const float most =
        std::max(std::max(seen[0].code, seen[1].code), std::max(seen[2].code, seen[3].code));
    float radiance = 0.0f;
    if (least > 0.0f && most < kBoardCode) {
      const float code = 0.25f * (seen[0].code + seen[1].code + seen[2].code + seen[3].code);
      radiance = (*ground_)(pixel.middle, code, pixel.along, pixel.down, pixel.turn);
    } else if (least == 0.0f && most == 0.0f) {
      radiance = sky_(pixel.middle);
    } else {
      radiance = Mixed(pixel, seen);
    }
    return view.HasThin(at[0][0], at[0][1], at[3][0], at[3][1]) ? Behind(view, pixel, radiance)
                                                                : radiance;
  }

 private:
  bool HeldClose(const Pixel& pixel) const {
    if (!close_->Holds(pixel.middle)) return false;
    const PixelCorners c = pixel.corners();
    return close_->Holds(c[0]) && close_->Holds(c[1]) && close_->Holds(c[2]) && close_->Holds(c[3]);
  }

  // Rays of one pixel that met objects, the board, or different things.
  float Mixed(const Pixel& pixel, const Seen (&seen)[kRays]) const {
    float radiance = 0.0f, ground_near = 0.0f;
    float grounds = 0.0f, boards = 0.0f, skies = 0.0f;
    float last = 0.0f;
    Tan ground_tan, board_tan;
    for (int k = 0; k < kRays; ++k) {
      if (IsObject(seen[k].code)) {
        // Rays that met the same facet share one look.
        if (k > 0 && seen[k].object == seen[k - 1].object) {
          radiance += last;
          continue;
        }
        last = objects_(seen[k], pixel.Ray(k), pixel.blur(), pixel.turn);
        radiance += last;
      } else if (IsBoard(seen[k].code)) {
        ++boards;
        board_tan = {board_tan.x + pixel.Ray(k).x, board_tan.y + pixel.Ray(k).y};
      } else if (IsSky(seen[k].code)) {
        ++skies;
      } else {
        ++grounds;
        ground_near += seen[k].code;
        ground_tan = {ground_tan.x + pixel.Ray(k).x, ground_tan.y + pixel.Ray(k).y};
      }
    }
    if (grounds > 0.0f) {
      radiance += grounds * (*ground_)({ground_tan.x / grounds, ground_tan.y / grounds},
                                       ground_near / grounds, pixel.along, pixel.down, pixel.turn);
    }
    if (boards > 0.0f) {
      const float share = objects_.BoardShare({board_tan.x / boards, board_tan.y / boards},
                                              pixel.blur(), pixel.turn);
      radiance += boards * (*board_)(pixel.corners(), share);
    }
    if (skies > 0.0f) radiance += skies * sky_(pixel.middle);
    return radiance * (1.0f / kRays);
  }

  // The same behind thin bodies.
  float Behind(const Sampler& view, const Pixel& pixel, float radiance) const {
    Thin sum;
    for (int k = 0; k < kRays; ++k) Sampler::Add(view.ThinAt(pixel.Ray(k)), 0.25f, sum);
    if (sum.cover <= 0.0f) return radiance;
    return radiance * (1.0f - sum.cover) +
           objects_.OfThin(sum, pixel.middle, pixel.blur(), pixel.turn);
  }

  Sampler wide_;
  std::optional<Sampler> close_;
  SkyShader sky_;
  ObjectShader objects_;
  std::optional<GroundShader> ground_;
  std::optional<BoardShader> board_;
};

}  // namespace

Eigen::Vector3f UnpackNormal(const Seen& seen) {
  constexpr float kPerStep = 2.0f / kNormalSteps;
  const float x = static_cast<float>(seen.object & 4095u) * kPerStep - 1.0f;
  const float y = static_cast<float>(seen.object >> 12 & 4095u) * kPerStep - 1.0f;
  const float z = 1.0f - std::abs(x) - std::abs(y);
  const float back = std::max(-z, 0.0f);  // folded over the edges
  const float nx = x >= 0.0f ? x - back : x + back, ny = y >= 0.0f ? y - back : y + back;
  const float shorten = 1.0f / std::sqrt(nx * nx + ny * ny + z * z);
  return {nx * shorten, ny * shorten, z * shorten};
}

RadianceImage Compose(const PixelGrid& grid, const FlatView& wide, const FlatView* close,
                      const Lit& lit, const Pose3& X_WC, Channel channel) {
  RadianceImage image{.width = grid.width, .height = grid.height, .values = {}};
  image.values.resize(static_cast<std::size_t>(grid.width) * grid.height);
  const Composer composer(wide, close, lit, X_WC, channel);
  Row row(grid.width);
  for (int y = 0; y < grid.height; ++y) {
    row.Fill(grid, y);
    float* out = &image.values[static_cast<std::size_t>(y) * grid.width];
    for (int x = 0; x < grid.width; ++x) {
      out[x] = composer({.middle = {row.x[x], row.y[x]},
                         .along = {row.along_x[x], row.along_y[x]},
                         .down = {row.down_x[x], row.down_y[x]},
                         .turn = Turn(x, y)});
    }
  }
  return image;
}

}  // namespace dockyard
