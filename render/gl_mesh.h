// Triangles on the GPU: position (0), normal (1), coverage (2).
#pragma once

#include <cstdint>
#include <vector>

#include "render/gl_functions.h"
#include "render/surface_mesh.h"

namespace dockyard {

/// Buffers of one mesh on the GPU.
class GlMesh {
 public:
  explicit GlMesh(const GlFunctions& gl);
  ~GlMesh();
  GlMesh(const GlMesh&) = delete;
  GlMesh& operator=(const GlMesh&) = delete;

  void Upload(const SurfaceMesh& mesh);
  /// Positions alone; normal and coverage keep GL's constant values.
  void Upload(const std::vector<Eigen::Vector3f>& positions,
              const std::vector<std::uint32_t>& indices);
  void Bind() const { gl_.BindVertexArray(array_); }
  int count() const { return count_; }  // of indices
  void Draw() const { Draw(0, count_); }
  void Draw(int first, int count) const;

 private:
  void UploadIndices(const std::vector<std::uint32_t>& indices);

  const GlFunctions& gl_;
  GLuint array_ = 0, vertices_ = 0, indices_ = 0;
  int count_ = 0;
};

}  // namespace dockyard
