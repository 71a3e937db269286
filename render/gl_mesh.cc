#include "render/gl_mesh.h"

#include <cstddef>

namespace dockyard {
namespace {

void Attribute(const GlFunctions& gl, GLuint at, int size, std::size_t stride, std::size_t offset) {
  gl.EnableVertexAttribArray(at);
  gl.VertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                         reinterpret_cast<const void*>(offset));
}

}  // namespace

GlMesh::GlMesh(const GlFunctions& gl) : gl_(gl) {
  gl_.GenVertexArrays(1, &array_);
  gl_.GenBuffers(1, &vertices_);
  gl_.GenBuffers(1, &indices_);
}

GlMesh::~GlMesh() {
  gl_.DeleteBuffers(1, &indices_);
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteVertexArrays(1, &array_);
}

void GlMesh::Upload(const SurfaceMesh& mesh) {
  static_assert(sizeof(SurfaceVertex) == 7 * sizeof(float));
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(SurfaceVertex)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
  Attribute(gl_, 0, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, position));
  Attribute(gl_, 1, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, normal));
  Attribute(gl_, 2, 1, sizeof(SurfaceVertex), offsetof(SurfaceVertex, coverage));
  UploadIndices(mesh.indices);
}

void GlMesh::Upload(const std::vector<Eigen::Vector3f>& positions,
                    const std::vector<std::uint32_t>& indices) {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.BufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(positions.size() * sizeof(Eigen::Vector3f)),
                 positions.data(), GL_STATIC_DRAW);
  Attribute(gl_, 0, 3, sizeof(Eigen::Vector3f), 0);
  UploadIndices(indices);
}

void GlMesh::UploadIndices(const std::vector<std::uint32_t>& indices) {
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_STATIC_DRAW);
  count_ = static_cast<int>(indices.size());
}

void GlMesh::Draw(int first, int count) const {
  if (count == 0) return;
  gl_.BindVertexArray(array_);
  gl_.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

}  // namespace dockyard
