// Where a glTF document says its numbers lie: buffers, views of them, accessors, primitives
// (Khronos, glTF 2.0, 3.6). assimp 5.2.5 reads beyond a view that an accessor's offset leaves, and
// takes positions of any type.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace dockyard {

/// The numbers as stated, each within the bounds of CheckGltf; keyed by place in their list.
struct GltfLayout {
  struct Buffer {
    long bytes = 0;
    bool elsewhere = false;  // has a uri; else it is the GLB's own
  };
  struct View {
    long buffer = -1, offset = 0, bytes = 0, stride = 0;
  };
  struct Accessor {
    long view = -1, offset = 0, count = 0, component = 0;
    std::string type;
  };
  struct Primitive {
    long mode = 4, positions = -1, indices = -1;  // 4: triangles, also when it is not stated
  };
  std::map<long, Buffer> buffers;
  std::map<long, View> views;
  std::map<long, Accessor> accessors;
  std::map<std::pair<long, long>, Primitive> primitives;  // by mesh and place in it
};

/// Why the layout is refused, empty when it is not: views beyond their buffer, accessors beyond
/// their view, positions other than three floats, triangles that want a corner.
/// @param own_bytes  of the GLB's own buffer
std::string LayoutObjection(const GltfLayout& layout, std::size_t own_bytes);

/// How many triangles the primitives have together. The layout has no objection.
long TrianglesOf(const GltfLayout& layout);

}  // namespace dockyard
