#include "models/read/gltf_layout.h"

namespace dockyard {
namespace {

constexpr long kTriangles = 4, kStrip = 5, kFan = 6;
constexpr long kFloat = 5126;

/// Bytes of one element, 0 for what the standard does not know.
long ElementBytes(const GltfLayout::Accessor& accessor) {
  static const std::map<std::string, long> parts{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  static const std::map<long, long> bytes{{5120, 1}, {5121, 1}, {5122, 2},
                                          {5123, 2}, {5125, 4}, {kFloat, 4}};
  const auto count = parts.find(accessor.type);
  const auto each = bytes.find(accessor.component);
  return count == parts.end() || each == bytes.end() ? 0 : count->second * each->second;
}

std::string Numbered(const char* list, long at) {
  return std::string(list) + "[" + std::to_string(at) + "]: ";
}

std::string ViewObjection(const GltfLayout& layout, long at, const GltfLayout::View& view,
                          std::size_t own_bytes) {
  const auto buffer = layout.buffers.find(view.buffer);
  if (buffer == layout.buffers.end()) {
    return Numbered("bufferViews", at) + "expected the place of a buffer";
  }
  const bool own = !buffer->second.elsewhere;
  if (own && (view.buffer != 0 || static_cast<std::size_t>(buffer->second.bytes) > own_bytes)) {
    return Numbered("buffers", view.buffer) + "byteLength: expected at most the " +
           std::to_string(own_bytes) + " bytes of the file's own buffer, or a uri";
  }
  if (view.offset + view.bytes > buffer->second.bytes) {
    return Numbered("bufferViews", at) + "expected all within the buffer's " +
           std::to_string(buffer->second.bytes) + " bytes";
  }
  return {};
}

std::string AccessorObjection(const GltfLayout& layout, long at,
                              const GltfLayout::Accessor& accessor) {
  const long element = ElementBytes(accessor);
  if (element == 0) {
    return Numbered("accessors", at) + "expected a type and a componentType of glTF 2.0";
  }
  if (accessor.view < 0) return {};
  const auto view = layout.views.find(accessor.view);
  if (view == layout.views.end()) {
    return Numbered("accessors", at) + "expected the place of a buffer view";
  }
  const long stride = view->second.stride == 0 ? element : view->second.stride;
  if (stride < element) {
    return Numbered("bufferViews", accessor.view) + "byteStride: expected 0 or at least " +
           std::to_string(element);
  }
  const long end = accessor.count == 0 ? 0 : (accessor.count - 1) * stride + element;
  if (accessor.offset + end > view->second.bytes) {
    return Numbered("accessors", at) + "expected all within the view's " +
           std::to_string(view->second.bytes) + " bytes";
  }
  return {};
}

/// How many corners a primitive names; -1 when it names none.
long Corners(const GltfLayout& layout, const GltfLayout::Primitive& primitive) {
  const auto accessor =
      layout.accessors.find(primitive.indices < 0 ? primitive.positions : primitive.indices);
  return accessor == layout.accessors.end() ? -1 : accessor->second.count;
}

std::string PrimitiveObjection(const GltfLayout& layout, long mesh,
                               const GltfLayout::Primitive& primitive) {
  const auto is = [&](long at, const char* type) {
    const auto accessor = layout.accessors.find(at);
    return accessor != layout.accessors.end() && accessor->second.type == type;
  };
  const std::string place = Numbered("meshes", mesh);
  if (!is(primitive.positions, "VEC3") ||
      layout.accessors.at(primitive.positions).component != kFloat) {
    return place + "POSITION: expected an accessor of VEC3 of floats";
  }
  if (primitive.indices >= 0 && (!is(primitive.indices, "SCALAR") ||
                                 layout.accessors.at(primitive.indices).component == kFloat)) {
    return place + "indices: expected an accessor of SCALAR whole numbers";
  }
  const long corners = Corners(layout, primitive);
  const bool whole = primitive.mode == kTriangles                         ? corners % 3 == 0
                     : primitive.mode == kStrip || primitive.mode == kFan ? corners >= 3
                                                                          : true;
  return whole ? "" : place + "expected three corners a triangle";
}

}  // namespace

std::string LayoutObjection(const GltfLayout& layout, std::size_t own_bytes) {
  std::string objection;
  for (const auto& [at, view] : layout.views) {
    if (objection.empty()) objection = ViewObjection(layout, at, view, own_bytes);
  }
  for (const auto& [at, accessor] : layout.accessors) {
    if (objection.empty()) objection = AccessorObjection(layout, at, accessor);
  }
  for (const auto& [at, primitive] : layout.primitives) {
    if (objection.empty()) objection = PrimitiveObjection(layout, at.first, primitive);
  }
  return objection;
}

long TrianglesOf(const GltfLayout& layout) {
  long triangles = 0;
  for (const auto& [at, primitive] : layout.primitives) {
    const long corners = Corners(layout, primitive);
    if (primitive.mode == kTriangles) triangles += corners / 3;
    if (primitive.mode == kStrip || primitive.mode == kFan) triangles += corners - 2;
  }
  return triangles;
}

}  // namespace dockyard
