// Radiance of ground, objects, boards, cables and sky for one camera: grey (or one channel) as
// float, colour as Rgb. No GL.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "render/board_ink.h"
#include "render/ground_mesh.h"
#include "render/ground_shader.h"
#include "render/object_shader.h"
#include "render/scene_light.h"
#include "render/sky_shader.h"

namespace dockyard {

/// The parts of an image next to the views. The shadow is that of the scene.
struct Lit {
  const Scene& scene;
  const GroundTexture& ground;
  const SunShadow& shadow;
};

/// Rays of one pixel that met one thing: the ground, a board, or one object (of grey cameras: one
/// facet of it).
struct Met {
  std::uint32_t thing = 0;
  bool of_board = false;
  float count = 0.0f, inverse_depth = 0.0f;
  Tan ray, from;                    // where the pixel's rays point; where those of the view do
  Eigen::Vector3f normal{0, 0, 0};  // in light axes; of colour cameras the mean

  void Add(float inverse, Tan r, Tan f) {
    ++count;
    inverse_depth += inverse;
    ray = {ray.x + r.x, ray.y + r.y};
    from = {from.x + f.x, from.y + f.y};
  }
};

template <typename Value>
class SceneShader {
 public:
  static constexpr bool kColour = std::is_same_v<Value, Rgb>;

  /// lit must outlive this. channel: of grey cameras.
  SceneShader(const Lit& lit, SceneLight<Value> light, const Pose3& X_WC, Channel channel)
      : light_(std::move(light)),
        bits_(BitsFor(lit.scene.objects.size())),
        objects_(lit.scene, lit.ground.highest_m(), lit.shadow, X_WC),
        sky_(lit.scene, X_WC,
             kColour ? Reflected{.sun = 1.0, .sky = 1.0, .bounce = 1.0}
                     : Reflect(lit.scene.light, Eigen::Vector3d::Ones(), channel)) {
    if (HasGround(lit.scene.ground)) {
      ground_.emplace(lit.ground, lit.scene, lit.shadow, X_WC, channel);
    }
    for (std::size_t i = 0; i < lit.scene.boards.size(); ++i) {
      const BoardShader shader(lit.scene.boards[i], X_WC);
      const Eigen::Vector3f n_C = (X_WC.R.transpose() * shader.normal_W()).template cast<float>();
      boards_.push_back({shader, shader.LightOf<Value>(light_.boards[i], lit.scene.light), n_C});
    }
    const Pose3& X_WU = lit.shadow.fit().X_WU;
    R_CU_ = (X_WC.R.transpose() * X_WU.R).template cast<float>();
    up_U_ = X_WU.R.row(2).transpose().template cast<float>();
  }

  HitBits bits() const { return bits_; }
  std::size_t boards() const { return boards_.size(); }

  Value Sky(Tan tan) const {
    if constexpr (kColour) {
      const SkyShader::Parts parts = sky_.PartsOf(tan);
      return parts.sky * light_.sky.sky + parts.bounce * light_.sky.bounce +
             parts.sun * light_.sky.sun;
    } else {
      return sky_(tan);
    }
  }

  /// Of pixels next to one another.
  void Ground(const GroundShader::PixelRow& row, Value* radiance) const {
    if constexpr (!kColour) (*ground_)(row, radiance);
    if (!kColour && light_.lamps.empty()) return;
    const SurfaceLight<Value>& on = light_.surfaces[light_.ground];
    GroundShader::Factors f;
    for (int first = 0; first < row.count; first += GroundShader::kAtOnce) {
      const GroundShader::PixelRow part = row.From(first);
      ground_->FactorsOf(part, kColour && light_.sunlit, f);
      for (int i = 0; i < part.count; ++i) {
        Value& sum = radiance[first + i];
        if constexpr (kColour) {
          const float sun = light_.sunlit ? f.sun[i] : 0.0f;
          sum = sun * on.sun + f.sky[i] * on.sky + f.bounce[i] * on.bounce;
        }
        if (light_.lamps.empty()) continue;
        const Eigen::Vector3f p_C(f.z[i] * part.x[i], f.z[i] * part.y[i], f.z[i]);
        light_.AddLamps(on, p_C, {f.n_x[i], f.n_y[i], f.n_z[i]}, f.tone[i], sum);
      }
    }
  }

  bool sunlit() const { return light_.sunlit; }

  /// Of an object. Lambert's law is linear in the normal, so the mean one serves for all rays,
  /// unless some of them meet faces that are turned away from a light.
  Value OfObject(std::size_t object, const Met& met, const Pixel& pixel) const {
    const SurfaceLight<Value>& on = light_.surfaces[light_.objects[object]];
    const Eigen::Vector3f& n = met.normal;
    float share = 0.0f;
    if (light_.sunlit && n.z() > 0.0f) {
      share = objects_.SunShare(met.from, met.inverse_depth,
                                kColour ? Eigen::Vector3f(n.normalized()) : n, pixel);
    }
    Value sum = Shade(on.sun, on.sky, on.bounce, n.z(), n.dot(up_U_), share);
    if (!light_.lamps.empty()) {
      light_.AddLamps(on, PointAt(met.from, met.inverse_depth), R_CU_ * n, 1.0f, sum);
    }
    return objects_.Stain(object, met.from, met.ray, met.inverse_depth, n, pixel) * sum;
  }

  /// Of pixels first to first + count - 1 of a row, at most kFacetsAtOnce, each of which met one
  /// facet of an object: what OfObject gives. words: as the views have them; the normals are filled
  /// in here.
  void OfFacets(const std::uint32_t* words, FacetRow& facets, const PixelRow& row, int first,
                int count, Value* radiance) const {
    std::array<float, kFacetsAtOnce> shares{};
    for (int i = 0, end; i < count; i = end) {
      end = EndOfFacet(words, i, count);
      const Eigen::Vector3f n = UnpackNormal({.object = words[i]}, bits_);
      std::fill(&facets.n_x[i], &facets.n_x[i] + (end - i), n.x());
      std::fill(&facets.n_y[i], &facets.n_y[i] + (end - i), n.y());
      std::fill(&facets.n_z[i], &facets.n_z[i] + (end - i), n.z());
    }
    if (light_.sunlit) objects_.FacetShares(facets, row, first, count, shares.data());
    for (int i = 0, end; i < count; i = end) {
      end = EndOfFacet(words, i, count);
      OfFacet(words[i], facets, row, first, i, end, shares.data(), radiance);
    }
  }

  /// Of pixels first to first + count - 1 of a row, all of whose rays met the board.
  void Board(std::size_t board, const PixelRow& row, int first, int count, Value* radiance) const {
    if (boards_[board].shader.bent()) {
      for (int i = 0; i < count; ++i) radiance[i] = OfBentBoard(board, row.At(first + i));
      return;
    }
    for (int i = 0; i < count; i += kBoardAtOnce) {
      const int x = first + i, n = std::min(kBoardAtOnce, count - i);
      float shares[kBoardAtOnce];
      objects_.BoardShares(board, row, x, n, shares);
      if (light_.lamps.empty()) {
        boards_[board].shader.Row(row, x, n, shares, boards_[board].light, radiance + i);
        continue;
      }
      for (int k = 0; k < n; ++k) radiance[i + k] = OfBoard(board, row.At(x + k), shares[k]);
    }
  }
  /// Of the board that some rays of a pixel met.
  Value BoardPart(const Met& met, const Pixel& pixel) const {
    if (boards_[met.thing].shader.bent()) return OfBentBoard(met.thing, pixel);
    return OfBoard(met.thing, pixel, objects_.BoardShare(met.thing, met.ray, pixel));
  }

  /// Of one of the scene's ThinBodies, and behind it what lies there.
  Value OfThin(std::size_t body, const Thin& sum, const Pixel& pixel, const Value& behind) const {
    const float per = 1.0f / sum.cover;
    const SurfaceLight<Value>& on = light_.surfaces[light_.thin[body]];
    const float share = light_.sunlit ? objects_.SunShare(pixel.middle, sum.inverse_depth * per,
                                                          Eigen::Vector3f::UnitZ(), pixel)
                                      : 0.0f;
    Value thin = Shade(on.sun, on.sky, on.bounce, sum.to_sun * per, sum.to_zenith * per, share);
    if (!light_.lamps.empty()) {
      // Of the round body that faces the camera the mean cosine is pi / 4.
      const float z = sum.cover / sum.inverse_depth;
      const Eigen::Vector3f p_C(z * pixel.middle.x, z * pixel.middle.y, z);
      light_.AddLamps(on, p_C, -p_C.normalized(), static_cast<float>(kPi / 4.0), thin);
    }
    return (1.0f - sum.cover) * behind + sum.cover * thin;
  }

 private:
  struct LitBoard {
    BoardShader shader;
    BoardLight<Value> light;
    Eigen::Vector3f n_C;
  };

  static int EndOfFacet(const std::uint32_t* words, int from, int count) {
    int end = from + 1;
    while (end < count && words[end] == words[from]) ++end;
    return end;
  }
  // Pixels from to end - 1 of OfFacets, all of one facet.
  void OfFacet(std::uint32_t word, const FacetRow& facets, const PixelRow& row, int first, int from,
               int end, const float* shares, Value* radiance) const {
    const auto object = static_cast<std::size_t>(ObjectOf({.object = word}, bits_));
    const SurfaceLight<Value>& on = light_.surfaces[light_.objects[object]];
    const Value sun = on.sun, sky = on.sky, bounce = on.bounce;
    const Eigen::Vector3f normal(facets.n_x[from], facets.n_y[from], facets.n_z[from]);
    const float to_sun = normal.z(), to_zenith = normal.dot(up_U_);
    for (int i = from; i < end; ++i) {
      const float share = to_sun > 0.0f ? shares[i] : 0.0f;
      radiance[i] = Shade(sun, sky, bounce, to_sun, to_zenith, share);
    }
    if (light_.lamps.empty() && !objects_.HasStains(object)) return;
    for (int i = from; i < end; ++i) {
      const Tan known{facets.from_x[i], facets.from_y[i]};
      const float inverse_depth = facets.inverse_depth[i];
      const Pixel pixel = row.At(first + i);
      if (!light_.lamps.empty()) {
        light_.AddLamps(on, PointAt(known, inverse_depth), R_CU_ * normal, 1.0f, radiance[i]);
      }
      radiance[i] =
          objects_.Stain(object, known, MeanRay(pixel), inverse_depth, normal, pixel) * radiance[i];
    }
  }
  static Tan MeanRay(const Pixel& pixel) {
    Tan sum;
    for (int k = 0; k < kRays; ++k) {
      const Tan ray = pixel.Ray(k);
      sum = {sum.x + ray.x, sum.y + ray.y};
    }
    return {sum.x / kRays, sum.y / kRays};
  }
  static Eigen::Vector3f PointAt(Tan tan, float inverse_depth) {
    const float z = 1.0f / inverse_depth;
    return {z * tan.x, z * tan.y, z};
  }

  Value OfBoard(std::size_t board, const Pixel& pixel, float share) const {
    const LitBoard& b = boards_[board];
    if (light_.lamps.empty()) return b.shader.At(pixel.corners(), share, b.light);
    BoardLight<Value> light = b.light;
    const Eigen::Vector3f& plane = objects_.BoardPlane(board);
    const Tan tan = pixel.middle;
    AddLampsToBoard(board, PointAt(tan, plane.x() * tan.x + plane.y() * tan.y + plane.z()), b.n_C,
                    light);
    return b.shader.At(pixel.corners(), share, light);
  }

  void AddLampsToBoard(std::size_t board, const Eigen::Vector3f& p_C, const Eigen::Vector3f& n_C,
                       BoardLight<Value>& light) const {
    const auto& paints = light_.boards[board];
    light_.AddLamps(paints.white, p_C, n_C, 1.0f, light.white.around);
    light_.AddLamps(paints.black, p_C, n_C, 1.0f, light.black.around);
    light_.AddLamps(paints.dust, p_C, n_C, 1.0f, light.dust.around);
  }

  // Each pixel has a normal of its own. All of its light is in `around`.
  Value OfBentBoard(std::size_t board, const Pixel& pixel) const {
    const LitBoard& b = boards_[board];
    const BoardShader::Spot spot = b.shader.SpotAt(pixel.middle);
    const Eigen::Vector3f n_U = R_CU_.transpose() * spot.n_C;
    float share = 0.0f;
    if (light_.sunlit && n_U.z() > 0.0f) {
      const float per_z = 1.0f / spot.p_C.z();
      share = objects_.SunShare({per_z * spot.p_C.x(), per_z * spot.p_C.y()}, per_z, n_U, pixel);
    }
    const auto paint = [&](const SurfaceLight<Value>& on) {
      return typename BoardLight<Value>::Paint{
          .around = Shade(on.sun, on.sky, on.bounce, n_U.z(), n_U.dot(up_U_), share)};
    };
    const auto& paints = light_.boards[board];
    BoardLight<Value> light{paint(paints.white), paint(paints.black), paint(paints.dust)};
    if (!light_.lamps.empty()) AddLampsToBoard(board, spot.p_C, spot.n_C, light);
    return b.shader.At(pixel.corners(), 0.0f, light);
  }

  SceneLight<Value> light_;
  HitBits bits_;
  ObjectShader objects_;
  SkyShader sky_;  // of colour cameras: of lights of strength 1
  std::optional<GroundShader> ground_;
  std::vector<LitBoard> boards_;
  Eigen::Matrix3f R_CU_;
  Eigen::Vector3f up_U_;
};

}  // namespace dockyard
