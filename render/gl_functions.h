// The GL entry points in use, fetched through the context that owns them. Nothing links a GL
// library's symbols: those of one library cannot drive a context of another.
#pragma once

#include <GL/glcorearb.h>

namespace dockyard {

// Types of GL 1.1 that the header leaves out where gl.h was read before it.
using GlBindTexture = void(APIENTRYP)(GLenum target, GLuint texture);
using GlDeleteTextures = void(APIENTRYP)(GLsizei n, const GLuint* textures);
using GlGenTextures = void(APIENTRYP)(GLsizei n, GLuint* textures);
using GlDrawArrays = void(APIENTRYP)(GLenum mode, GLint first, GLsizei count);
using GlDrawElements = void(APIENTRYP)(GLenum mode, GLsizei count, GLenum type,
                                       const void* indices);
using GlGetString = const GLubyte*(APIENTRYP)(GLenum name);
using GlPolygonOffset = void(APIENTRYP)(GLfloat factor, GLfloat units);

// The core 3.3 subset that the renderer needs: type, name without "gl".
#define DOCKYARD_GL_FUNCTIONS(X)                               \
  X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                     \
  X(PFNGLATTACHSHADERPROC, AttachShader)                       \
  X(PFNGLBINDBUFFERPROC, BindBuffer)                           \
  X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                 \
  X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)               \
  X(GlBindTexture, BindTexture)                                \
  X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                 \
  X(PFNGLBLENDFUNCPROC, BlendFunc)                             \
  X(PFNGLBUFFERDATAPROC, BufferData)                           \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)   \
  X(PFNGLCLEARPROC, Clear)                                     \
  X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                     \
  X(PFNGLCLEARBUFFERUIVPROC, ClearBufferuiv)                   \
  X(PFNGLCOMPILESHADERPROC, CompileShader)                     \
  X(PFNGLCREATEPROGRAMPROC, CreateProgram)                     \
  X(PFNGLCREATESHADERPROC, CreateShader)                       \
  X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                     \
  X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)           \
  X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                     \
  X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)         \
  X(PFNGLDELETESHADERPROC, DeleteShader)                       \
  X(GlDeleteTextures, DeleteTextures)                          \
  X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)           \
  X(PFNGLDEPTHFUNCPROC, DepthFunc)                             \
  X(PFNGLDEPTHMASKPROC, DepthMask)                             \
  X(PFNGLDISABLEPROC, Disable)                                 \
  X(GlDrawArrays, DrawArrays)                                  \
  X(PFNGLDRAWBUFFERPROC, DrawBuffer)                           \
  X(GlDrawElements, DrawElements)                              \
  X(PFNGLENABLEPROC, Enable)                                   \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray) \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer) \
  X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)       \
  X(PFNGLFRONTFACEPROC, FrontFace)                             \
  X(PFNGLGENBUFFERSPROC, GenBuffers)                           \
  X(PFNGLGENERATEMIPMAPPROC, GenerateMipmap)                   \
  X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                 \
  X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)               \
  X(GlGenTextures, GenTextures)                                \
  X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                 \
  X(PFNGLGETERRORPROC, GetError)                               \
  X(PFNGLGETINTEGERVPROC, GetIntegerv)                         \
  X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)             \
  X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                       \
  X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)               \
  X(PFNGLGETSHADERIVPROC, GetShaderiv)                         \
  X(GlGetString, GetString)                                    \
  X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)           \
  X(PFNGLLINKPROGRAMPROC, LinkProgram)                         \
  X(PFNGLPIXELSTOREIPROC, PixelStorei)                         \
  X(GlPolygonOffset, PolygonOffset)                            \
  X(PFNGLREADBUFFERPROC, ReadBuffer)                           \
  X(PFNGLREADPIXELSPROC, ReadPixels)                           \
  X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage)         \
  X(PFNGLSCISSORPROC, Scissor)                                 \
  X(PFNGLSHADERSOURCEPROC, ShaderSource)                       \
  X(PFNGLTEXIMAGE2DPROC, TexImage2D)                           \
  X(PFNGLTEXPARAMETERFPROC, TexParameterf)                     \
  X(PFNGLTEXPARAMETERIPROC, TexParameteri)                     \
  X(PFNGLUNIFORM1FPROC, Uniform1f)                             \
  X(PFNGLUNIFORM1IPROC, Uniform1i)                             \
  X(PFNGLUNIFORM2FPROC, Uniform2f)                             \
  X(PFNGLUNIFORM3FPROC, Uniform3f)                             \
  X(PFNGLUNIFORM4FPROC, Uniform4f)                             \
  X(PFNGLUNIFORM4FVPROC, Uniform4fv)                           \
  X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)               \
  X(PFNGLUSEPROGRAMPROC, UseProgram)                           \
  X(PFNGLVERTEXATTRIB1FPROC, VertexAttrib1f)                   \
  X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)         \
  X(PFNGLVIEWPORTPROC, Viewport)

struct GlFunctions {
#define DOCKYARD_GL_MEMBER(type, name) type name = nullptr;
  DOCKYARD_GL_FUNCTIONS(DOCKYARD_GL_MEMBER)
#undef DOCKYARD_GL_MEMBER
};

using GlProc = void (*)();

/// Fills the table; get(name) answers an entry point or null. Throws std::runtime_error naming the
/// first function that the context does not have.
template <class GetProc>
GlFunctions LoadGlFunctions(GetProc get);

/// Throws std::runtime_error: the entry point is missing.
[[noreturn]] void ThrowMissingGlFunction(const char* name);

template <class GetProc>
GlFunctions LoadGlFunctions(GetProc get) {
  GlFunctions gl;
#define DOCKYARD_GL_LOAD(type, name)                 \
  gl.name = reinterpret_cast<type>(get("gl" #name)); \
  if (!gl.name) ThrowMissingGlFunction("gl" #name);
  DOCKYARD_GL_FUNCTIONS(DOCKYARD_GL_LOAD)
#undef DOCKYARD_GL_LOAD
  return gl;
}

}  // namespace dockyard
