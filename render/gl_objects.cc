#include "render/gl_objects.h"

#include <stdexcept>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kUploadUnit = 7;

GLuint Compile(const GlFunctions& gl, GLenum kind, const std::string& source) {
  const GLuint shader = gl.CreateShader(kind);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    char log[2048] = "";
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    gl.DeleteShader(shader);
    throw std::runtime_error(std::string("shader does not compile: ") + log);
  }
  return shader;
}

void RequireComplete(const GlFunctions& gl) {
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the GL context cannot draw into the framebuffer it is asked for");
  }
}

}  // namespace

GlProgram::GlProgram(const GlFunctions& gl, const std::string& vertex, const std::string& fragment)
    : gl_(gl) {
  const GLuint vs = Compile(gl, GL_VERTEX_SHADER, vertex);
  const GLuint fs = Compile(gl, GL_FRAGMENT_SHADER, fragment);
  id_ = gl.CreateProgram();
  gl.AttachShader(id_, vs);
  gl.AttachShader(id_, fs);
  gl.LinkProgram(id_);
  gl.DeleteShader(vs);
  gl.DeleteShader(fs);
  GLint good = 0;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &good);
  if (!good) {
    char log[2048] = "";
    gl.GetProgramInfoLog(id_, sizeof log, nullptr, log);
    gl.DeleteProgram(id_);
    throw std::runtime_error(std::string("shader does not link: ") + log);
  }
}

GlProgram::~GlProgram() { gl_.DeleteProgram(id_); }

GLint GlProgram::Location(const char* name) {
  const auto known = locations_.find(name);
  if (known != locations_.end()) return known->second;
  // -1 (a uniform that the compiler found unused) is legal and ignored by GL.
  return locations_[name] = gl_.GetUniformLocation(id_, name);
}

void GlProgram::Set(const char* name, int value) { gl_.Uniform1i(Location(name), value); }

void GlProgram::Set(const char* name, double value) {
  gl_.Uniform1f(Location(name), static_cast<float>(value));
}

void GlProgram::Set(const char* name, const Eigen::Vector2d& value) {
  const Eigen::Vector2f v = value.cast<float>();
  gl_.Uniform2f(Location(name), v.x(), v.y());
}

void GlProgram::Set(const char* name, const Eigen::Vector3d& value) {
  const Eigen::Vector3f v = value.cast<float>();
  gl_.Uniform3f(Location(name), v.x(), v.y(), v.z());
}

void GlProgram::Set(const char* name, const Eigen::Vector4d& value) {
  const Eigen::Vector4f v = value.cast<float>();
  gl_.Uniform4f(Location(name), v.x(), v.y(), v.z(), v.w());
}

void GlProgram::Set(const char* name, const Eigen::Matrix4d& value) {
  const Eigen::Matrix4f m = value.cast<float>();
  gl_.UniformMatrix4fv(Location(name), 1, GL_FALSE, m.data());
}

void GlProgram::Set(const char* name, const Eigen::Matrix<float, 4, Eigen::Dynamic>& values) {
  if (values.cols() == 0) return;
  gl_.Uniform4fv(Location(name), static_cast<GLsizei>(values.cols()), values.data());
}

void GlTexture::Bind(int unit) const {
  gl_.ActiveTexture(GL_TEXTURE0 + unit);
  gl_.BindTexture(GL_TEXTURE_2D, id_);
}

void GlTexture::Image(GLint internal, int width, int height, GLenum format, GLenum type,
                      const void* data) {
  Bind(kUploadUnit);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, data);
}

void GlTexture::Sampling(GLint minify, GLint magnify, GLint wrap) {
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  const bool mipmapped = minify == GL_LINEAR_MIPMAP_LINEAR || minify == GL_LINEAR_MIPMAP_NEAREST;
  if (mipmapped) gl_.GenerateMipmap(GL_TEXTURE_2D);
}

GlViewTarget::GlViewTarget(const GlFunctions& gl, int width, int height)
    : gl_(gl), width_(width), height_(height) {
  gl_.GenRenderbuffers(3, buffers_);
  const auto store = [&](GLuint buffer, GLenum format) {
    gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  };
  store(buffers_[0], GL_RG32UI);
  store(buffers_[1], GL_RGBA32F);
  store(buffers_[2], GL_DEPTH_COMPONENT32F);
  const auto frame = [&](GLuint& id, GLuint color) {
    gl_.GenFramebuffers(1, &id);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, id);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers_[2]);
    RequireComplete(gl_);
  };
  frame(seen_, buffers_[0]);
  frame(thin_, buffers_[1]);
}

GlViewTarget::~GlViewTarget() {
  gl_.DeleteFramebuffers(1, &seen_);
  gl_.DeleteFramebuffers(1, &thin_);
  gl_.DeleteRenderbuffers(3, buffers_);
}

void GlViewTarget::Read(int w, int h, Seen* pixels) const {
  static_assert(sizeof(Seen) == 8);
  DOCKYARD_CHECK(w <= width_ && h <= height_);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(0, 0, w, h, GL_RG_INTEGER, GL_UNSIGNED_INT, pixels);
}

void GlViewTarget::Read(int x, int y, int w, int h, Thin* pixels) const {
  static_assert(sizeof(Thin) == 4 * sizeof(float));
  DOCKYARD_CHECK(x >= 0 && y >= 0 && x + w <= width_ && y + h <= height_);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(x, y, w, h, GL_RGBA, GL_FLOAT, pixels);
}

GlTextureTarget::GlTextureTarget(const GlFunctions& gl, const GlTexture* color,
                                 const GlTexture* depth)
    : gl_(gl) {
  gl_.GenFramebuffers(1, &id_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
  const auto attach = [&](const GlTexture* texture, GLenum where) {
    if (texture) gl_.FramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, texture->id(), 0);
  };
  attach(color, GL_COLOR_ATTACHMENT0);
  attach(depth, GL_DEPTH_ATTACHMENT);
  if (!color) {
    gl_.DrawBuffer(GL_NONE);
    gl_.ReadBuffer(GL_NONE);
  }
  RequireComplete(gl_);
}

void GlTextureTarget::Bind(int width, int height) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, id_);
  gl_.Viewport(0, 0, width, height);
}

}  // namespace dockyard
