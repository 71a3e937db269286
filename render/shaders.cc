#include "render/shaders.h"

#include <cstdio>

#include "render/soil_texture.h"

namespace dockyard {
namespace {

const char* const kVersion = "#version 330 core\n";

std::string Constant(const char* type, const char* name, double value) {
  char text[120];
  std::snprintf(text, sizeof text, "const %s %s = %s(%.9g);\n", type, name, type, value);
  return text;
}

// How much of the sun's disc a point of a surface sees. u_window: centre x, y [m], texels per
// metre, texels a side; u_column: first column in the atlas. Beyond both windows: all of it.
const char* const kSunShare = R"(
uniform sampler2D u_shadow;   // 0 at u_depth.x towards the sun, 1 at u_depth.x - u_depth.y
uniform sampler2D u_tiles;
uniform vec4 u_coarse, u_fine;
uniform float u_fine_column;
uniform vec2 u_depth;
uniform float u_sun_radius;   // [rad]
uniform float u_bias;         // [m]
uniform vec2 u_effort;        // points of the search, points of the penumbra

// Turn by the golden angle: sunflower points fill a disc (Vogel, Mathematical Biosciences 44, 1979).
const mat2 kGolden = mat2(-0.73736888, 0.67549029, -0.67549029, -0.73736888);

float Caster(ivec2 texel) {
  float z = texelFetch(u_shadow, texel, 0).r;
  return z < 1.0 ? u_depth.x - z * u_depth.y : -1e9;
}

// Whether the texel at q (of the atlas, relative to place q0) stands over the receiver's plane.
bool Over(vec2 q, vec2 q0, float z, vec2 slope, float texel, out float gap) {
  vec2 middle = floor(q) + 0.5;
  gap = Caster(ivec2(q)) - (z + dot(slope, (middle - q0) * texel));
  return gap > u_bias;
}

float SunShare(vec3 p, vec3 n) {
  vec2 q = (p.xy - u_fine.xy) * u_fine.z + 0.5 * u_fine.w;
  vec4 window = u_fine;
  float column = u_fine_column;
  const float kEdge = 18.0;
  bool outside = false;
  if (any(lessThan(q, vec2(kEdge))) || any(greaterThan(q, vec2(u_fine.w - kEdge)))) {
    q = (p.xy - u_coarse.xy) * u_coarse.z + 0.5 * u_coarse.w;
    window = u_coarse;
    column = 0.0;
    outside = any(lessThan(q, vec2(kEdge))) || any(greaterThan(q, vec2(u_coarse.w - kEdge)));
  }
  q.x += column;
  float texel = 1.0 / window.z;
  vec2 slope = -n.xy / max(n.z, 0.12);
  float sway = length(slope) * texel * kReachTexels;
  vec2 bounds = texelFetch(u_tiles, ivec2(q) / kTile, 0).rg;  // highest, lowest caster
  // Software GL skips no branch, but it leaves loops: so both searches are loops whose length is
  // nought where the tile has settled the matter.
  bool clear = outside || bounds.x < p.z - sway;
  bool dark = !outside && bounds.y > p.z + sway + u_bias;
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  vec2 ray = vec2(cos(turn), sin(turn));
  // How far the nearest casters are decides how wide the penumbra is.
  float reach = clamp(u_sun_radius * (bounds.x - p.z + sway) * window.z, 1.5, kMaxReach);
  float searches = clear || dark ? 0.0 : u_effort.x;
  float total = 0.0, found = 0.0, gap;
  for (float i = 0.5; i < searches; ++i) {
    if (Over(q + ray * (reach * sqrt(i / u_effort.x)), q, p.z, slope, texel, gap)) {
      total += gap;
      found += 1.0;
    }
    ray = kGolden * ray;
  }
  float radius = clamp(u_sun_radius * (total / max(found, 1.0)) * window.z, 0.8, kMaxReach);
  float taps = found > 0.0 ? u_effort.y : 0.0;
  float blocked = dark ? u_effort.y : 0.0;
  for (float i = 0.5; i < taps; ++i) {
    if (Over(q + ray * (radius * sqrt(i / u_effort.y)), q, p.z, slope, texel, gap)) blocked += 1.0;
    ray = kGolden * ray;
  }
  return 1.0 - blocked / u_effort.y;
}
)";

// Lambert under sun, sky and ground: n in light axes, open = 1 under a free sky.
const char* const kShade = R"(
uniform vec3 u_light;  // irradiance: sun, whole sky, ground's bounce
uniform vec3 u_up;

float Shade(float albedo, vec3 n, float sun_share, float open) {
  float up = dot(n, u_up);
  float sky = 0.5 * (1.0 + up) * u_light.y + 0.5 * (1.0 - up) * u_light.z;
  return albedo * 0.318309886 * (max(n.z, 0.0) * sun_share * u_light.x + sky * open);
}
)";

std::string ShadowCode() {
  return Constant("int", "kTile", kShadowTile) +
         Constant("float", "kReachTexels", kShadowTile * (kShadowReachTiles + 1)) +
         Constant("float", "kMaxReach", kShadowTile * kShadowReachTiles) + kSunShare + kShade;
}

}  // namespace

std::string SurfaceVertexShader() {
  return std::string(kVersion) + R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in float a_coverage;
uniform mat4 u_clip_from_object, u_light_from_object;
out vec3 v_light;
out vec3 v_normal;
out vec2 v_plane;
out float v_coverage;
void main() {
  v_light = (u_light_from_object * vec4(a_position, 1.0)).xyz;
  v_normal = mat3(u_light_from_object) * a_normal;
  v_plane = a_position.xy;
  v_coverage = a_coverage;
  gl_Position = u_clip_from_object * vec4(a_position, 1.0);
}
)";
}

std::string SurfaceFragmentShader() {
  return kVersion + ShadowCode() + R"(
in vec3 v_light;
in vec3 v_normal;
in float v_coverage;
uniform float u_albedo;
out vec4 o_radiance;
void main() {
  vec3 n = normalize(gl_FrontFacing ? v_normal : -v_normal);
  float sun = n.z > 0.0 ? SunShare(v_light, n) : 0.0;
  o_radiance = vec4(Shade(u_albedo, n, sun, 1.0), 0.0, 0.0, v_coverage);
}
)";
}

std::string GroundFragmentShader(bool shadows) {
  return kVersion + ShadowCode() + (shadows ? "" : "#define SunShare(place, normal) 1.0\n") +
         Constant("float", "kTileLength", kSoilTile_m) +
         Constant("float", "kSlopeFull", kSoilSlopeFull) + R"(
in vec3 v_light;
in vec2 v_plane;
uniform mat4 u_light_from_object;
uniform sampler2D u_relief, u_soil, u_lumps;
uniform vec2 u_pole;      // of the fan, in the site frame
uniform vec2 u_grid_scale, u_grid_shift;  // site metres to texture
uniform float u_albedo;
out vec4 o_radiance;

vec4 Signed(vec4 texel) { return (texel * 255.0 - 128.0) / 127.0; }

void main() {
  vec2 site = v_plane + u_pole;
  vec2 uv = site * u_grid_scale + u_grid_shift;
  vec3 relief = texture(u_relief, uv).xyz;
  vec2 beyond = max(max(-uv, uv - 1.0), 0.0) / u_grid_scale;
  float on_grid = 1.0 - smoothstep(0.0, 0.3, max(beyond.x, beyond.y));
  vec2 slope = relief.xy * on_grid;
  mat3 turn = mat3(u_light_from_object);
  vec3 smooth_n = normalize(turn * vec3(-slope, 1.0));

  vec4 close = Signed(texture(u_soil, site / kTileLength, -0.8));
  vec2 turned = vec2(0.7986 * site.x - 0.6018 * site.y, 0.6018 * site.x + 0.7986 * site.y);
  vec4 wide = Signed(texture(u_lumps, turned / (6.7 * kTileLength)));
  float far = Signed(texture(u_lumps, turned.yx / (61.0 * kTileLength))).x;
  slope += kSlopeFull * (close.yz + 0.5 * wide.yz);
  vec3 n = normalize(turn * vec3(-slope, 1.0));
  float tone = (1.0 + close.x) * (1.0 + 0.6 * wide.x) * (1.0 + 0.8 * far);
  float sun = n.z > 0.0 ? SunShare(v_light, smooth_n) * mix(1.0, relief.z, on_grid) : 0.0;
  o_radiance = vec4(Shade(u_albedo * tone, n, sun, clamp(0.92 + 0.5 * close.w, 0.7, 1.0)), 0.0, 0.0, 1.0);
}
)";
}

std::string BoardFragmentShader() {
  return kVersion + ShadowCode() + "const int kMost = " + std::to_string(kMaxFiducials) + ";\n" +
         R"(
in vec3 v_light;
in vec3 v_normal;
in vec2 v_plane;
uniform vec4 u_fiducials[kMost];  // centre, direction of the bar
uniform int u_fiducial_count;
uniform vec3 u_sizes;    // disc radius, half bar length, half bar width [m]
uniform vec2 u_albedos;  // white, black
uniform float u_printed_side;
out vec4 o_radiance;

// Share of the pixel where a distance that grows by `slope` a pixel is below zero.
float Below(float distance, float slope) { return clamp(0.5 - distance / max(slope, 1e-9), 0.0, 1.0); }

void main() {
  vec2 dx = dFdx(v_plane), dy = dFdy(v_plane);
  float black = 0.0;
  for (int i = 0; i < u_fiducial_count; ++i) {
    vec2 q = v_plane - u_fiducials[i].xy;
    float r = length(q);
    vec2 outward = q / max(r, 1e-6);
    float disc = Below(r - u_sizes.x, length(vec2(dot(outward, dx), dot(outward, dy))));
    vec2 along = u_fiducials[i].zw, across = vec2(-along.y, along.x);
    float bar = Below(abs(dot(q, along)) - u_sizes.y, length(vec2(dot(along, dx), dot(along, dy)))) *
                Below(abs(dot(q, across)) - u_sizes.z, length(vec2(dot(across, dx), dot(across, dy))));
    black = max(black, disc * (1.0 - bar));
  }
  bool printed = gl_FrontFacing;
  float albedo = mix(u_albedos.x, u_albedos.y, printed ? black : 0.0);
  vec3 n = normalize(printed ? v_normal : -v_normal);
  float sun = n.z > 0.0 ? SunShare(v_light, n) : 0.0;
  o_radiance = vec4(Shade(albedo, n, sun, 1.0), 0.0, 0.0, 1.0);
}
)";
}

std::string FullScreenVertexShader() {
  return std::string(kVersion) + R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";
}

std::string SkyVertexShader() {
  return std::string(kVersion) + R"(
uniform vec4 u_rect;  // tan plane: left, top, width, height
out vec2 v_tan;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  v_tan = u_rect.xy + (0.5 * corner + 0.5) * u_rect.zw;
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";
}

// Sky twice as bright at the horizon as overhead (assumed, 1-3 for a clear sky); over the level
// surface it adds up to the whole sky's irradiance: 2 * integral of 0.75 (2 - s) s ds = 1.
std::string SkyFragmentShader() {
  return std::string(kVersion) + R"(
in vec2 v_tan;
uniform vec3 u_up_C, u_sun_C, u_light;
uniform float u_sun_radius;
out vec4 o_radiance;
void main() {
  vec3 ray = normalize(vec3(v_tan, 1.0));
  float s = dot(ray, u_up_C);
  float radiance = s > 0.0 ? u_light.y * 0.75 * (2.0 - s) : u_light.z;
  radiance *= 0.318309886;
  if (length(ray - u_sun_C) < u_sun_radius) {
    radiance += u_light.x * 0.318309886 / (u_sun_radius * u_sun_radius);
  }
  o_radiance = vec4(radiance, 0.0, 0.0, 1.0);
}
)";
}

std::string DepthVertexShader() {
  return std::string(kVersion) + R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_clip_from_object;
void main() { gl_Position = u_clip_from_object * vec4(a_position, 1.0); }
)";
}

std::string DepthFragmentShader() { return std::string(kVersion) + "void main() {}\n"; }

std::string TileBoundsFragmentShader() {
  return kVersion + Constant("int", "kTile", kShadowTile) + R"(
uniform sampler2D u_shadow;
uniform vec2 u_depth;
out vec4 o_bounds;
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * kTile;
  float nearest = 1.0, farthest = 0.0;
  for (int y = 0; y < kTile; ++y) {
    for (int x = 0; x < kTile; ++x) {
      float z = texelFetch(u_shadow, corner + ivec2(x, y), 0).r;
      nearest = min(nearest, z);
      farthest = max(farthest, z);
    }
  }
  float highest = nearest < 1.0 ? u_depth.x - nearest * u_depth.y : -1e9;
  float lowest = farthest < 1.0 ? u_depth.x - farthest * u_depth.y : -1e9;
  o_bounds = vec4(highest, lowest, 0.0, 1.0);
}
)";
}

std::string TileSpreadFragmentShader() {
  return kVersion + Constant("int", "kSpread", kShadowReachTiles) + R"(
uniform sampler2D u_tiles;
out vec4 o_bounds;
void main() {
  ivec2 last = textureSize(u_tiles, 0) - 1, here = ivec2(gl_FragCoord.xy);
  vec2 bounds = texelFetch(u_tiles, here, 0).rg;
  for (int y = -kSpread; y <= kSpread; ++y) {
    for (int x = -kSpread; x <= kSpread; ++x) {
      vec2 other = texelFetch(u_tiles, clamp(here + ivec2(x, y), ivec2(0), last), 0).rg;
      bounds = vec2(max(bounds.x, other.x), min(bounds.y, other.y));
    }
  }
  o_bounds = vec4(bounds, 0.0, 1.0);
}
)";
}

}  // namespace dockyard
