#include "render/shaders.h"

namespace dockyard {
namespace {

const char* const kVersion = "#version 330 core\n";

}  // namespace

std::string PlainVertexShader() {
  return std::string(kVersion) + R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_clip_from_object;
void main() { gl_Position = u_clip_from_object * vec4(a_position, 1.0); }
)";
}

std::string SurfaceVertexShader() {
  return std::string(kVersion) + R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in float a_coverage;
uniform mat4 u_clip_from_object, u_light_from_object;
out vec3 v_normal;
out float v_coverage;
void main() {
  v_normal = mat3(u_light_from_object) * a_normal;
  v_coverage = a_coverage;
  gl_Position = u_clip_from_object * vec4(a_position, 1.0);
}
)";
}

// The normal unfolded from the octahedron |x| + |y| + |z| = 1 (Meyer et al., EGSR 2010).
std::string ObjectFragmentShader(HitBits bits) {
  const std::string of_normal = std::to_string(bits.normal);
  return kVersion + std::string("const float kSteps = ") + std::to_string(bits.NormalSteps()) +
         ".0;\nconst int kBits = " + of_normal + ";\n" + R"(
in vec3 v_normal;
uniform int u_object;
out uvec2 o_seen;
void main() {
  vec3 n = gl_FrontFacing ? v_normal : -v_normal;
  vec2 q = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
  if (n.z < 0.0) q = (1.0 - abs(q.yx)) * vec2(q.x < 0.0 ? -1.0 : 1.0, q.y < 0.0 ? -1.0 : 1.0);
  uvec2 steps = uvec2(floor((0.5 * q + 0.5) * kSteps + 0.5));
  uint object = uint(u_object) << (2 * kBits) | steps.y << kBits | steps.x;
  o_seen = uvec2(object, floatBitsToUint(-gl_FragCoord.w));
}
)";
}

std::string GroundFragmentShader() {
  return std::string(kVersion) + R"(
out uvec2 o_seen;
void main() { o_seen = uvec2(0u, floatBitsToUint(gl_FragCoord.w)); }
)";
}

std::string BoardFragmentShader() {
  return kVersion + std::string("const float kBoardCode = ") + std::to_string(kBoardCode) + ";\n" +
         R"(
uniform int u_board;
out uvec2 o_seen;
void main() { o_seen = uvec2(uint(u_board), floatBitsToUint(kBoardCode + gl_FragCoord.w)); }
)";
}

std::string ThinFragmentShader() {
  return std::string(kVersion) + R"(
in vec3 v_normal;
in float v_coverage;
uniform vec3 u_up;
out vec4 o_thin;
void main() {
  vec3 n = normalize(v_normal);
  o_thin = v_coverage * vec4(max(n.z, 0.0), dot(n, u_up), gl_FragCoord.w, 1.0);
}
)";
}

std::string DepthFragmentShader() { return std::string(kVersion) + "void main() {}\n"; }

}  // namespace dockyard
