// GL objects that free themselves. All must die while their context is current.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include "render/flat_view.h"
#include "render/gl_functions.h"

namespace dockyard {

/// A linked program and its uniforms. The setters act on the program in use.
class GlProgram {
 public:
  /// Throws std::runtime_error with the compiler's log.
  GlProgram(const GlFunctions& gl, const std::string& vertex, const std::string& fragment);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void Use() const { gl_.UseProgram(id_); }
  void Set(const char* name, int value);
  void Set(const char* name, double value);
  void Set(const char* name, const Eigen::Vector2d& value);
  void Set(const char* name, const Eigen::Vector3d& value);
  void Set(const char* name, const Eigen::Vector4d& value);
  void Set(const char* name, const Eigen::Matrix4d& value);
  void Set(const char* name, const Eigen::Matrix<float, 4, Eigen::Dynamic>& values);

 private:
  GLint Location(const char* name);

  const GlFunctions& gl_;
  GLuint id_ = 0;
  std::map<std::string, GLint, std::less<>> locations_;
};

class GlTexture {
 public:
  explicit GlTexture(const GlFunctions& gl) : gl_(gl) { gl_.GenTextures(1, &id_); }
  ~GlTexture() { gl_.DeleteTextures(1, &id_); }
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  GLuint id() const { return id_; }
  void Bind(int unit) const;
  /// Binds to the last unit and gives it an image; data may be null.
  void Image(GLint internal, int width, int height, GLenum format, GLenum type, const void* data);
  /// Filters and wrapping; acts on the texture that Image left bound.
  void Sampling(GLint minify, GLint magnify, GLint wrap);

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

/// A flat view to draw into: one plane for surfaces, one for thin bodies before them, one depth.
class GlViewTarget {
 public:
  /// Throws std::runtime_error when the context cannot.
  GlViewTarget(const GlFunctions& gl, int width, int height);
  ~GlViewTarget();
  GlViewTarget(const GlViewTarget&) = delete;
  GlViewTarget& operator=(const GlViewTarget&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  void BindSeen() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, seen_); }
  void BindThin() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, thin_); }
  /// Copy pixels out of the plane, which is bound; row by row from GL's row 0.
  void Read(int w, int h, Seen* pixels) const;
  void Read(int x, int y, int w, int h, Thin* pixels) const;

 private:
  const GlFunctions& gl_;
  int width_, height_;
  GLuint seen_ = 0, thin_ = 0, buffers_[3] = {};
};

/// A framebuffer that draws into textures.
class GlTextureTarget {
 public:
  /// Either may be null. Throws std::runtime_error when the context cannot.
  GlTextureTarget(const GlFunctions& gl, const GlTexture* color, const GlTexture* depth);
  ~GlTextureTarget() { gl_.DeleteFramebuffers(1, &id_); }
  GlTextureTarget(const GlTextureTarget&) = delete;
  GlTextureTarget& operator=(const GlTextureTarget&) = delete;

  void Bind(int width, int height) const;

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

}  // namespace dockyard
