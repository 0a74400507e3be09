#pragma once

#include "core/render/renderer.h"

#include <GL/glcorearb.h>

namespace esm {

// clang-format off
#define ESM_GL_FUNCTIONS(X) \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture) X(PFNGLATTACHSHADERPROC, AttachShader) \
    X(PFNGLBINDBUFFERPROC, BindBuffer) X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer) X(PFNGLBINDTEXTUREPROC, BindTexture) \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray) X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate) \
    X(PFNGLBUFFERDATAPROC, BufferData) X(PFNGLCLEARPROC, Clear) X(PFNGLCOMPILESHADERPROC, CompileShader) \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram) X(PFNGLCREATESHADERPROC, CreateShader) \
    X(PFNGLCULLFACEPROC, CullFace) X(PFNGLDELETEBUFFERSPROC, DeleteBuffers) \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers) X(PFNGLDELETEPROGRAMPROC, DeleteProgram) X(PFNGLDELETESHADERPROC, DeleteShader) \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures) X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays) \
    X(PFNGLDEPTHFUNCPROC, DepthFunc) X(PFNGLDEPTHMASKPROC, DepthMask) \
    X(PFNGLDISABLEPROC, Disable) X(PFNGLDRAWARRAYSPROC, DrawArrays) X(PFNGLDRAWBUFFERPROC, DrawBuffer) \
    X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced) X(PFNGLDRAWELEMENTSPROC, DrawElements) \
    X(PFNGLENABLEPROC, Enable) X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray) \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D) X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers) \
    X(PFNGLGENBUFFERSPROC, GenBuffers) X(PFNGLGENTEXTURESPROC, GenTextures) \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays) X(PFNGLGENERATEMIPMAPPROC, GenerateMipmap) \
    X(PFNGLGETINTEGERVPROC, GetIntegerv) X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog) \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv) X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog) \
    X(PFNGLGETSHADERIVPROC, GetShaderiv) X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation) \
    X(PFNGLLINKPROGRAMPROC, LinkProgram) X(PFNGLPIXELSTOREIPROC, PixelStorei) X(PFNGLPOLYGONOFFSETPROC, PolygonOffset) X(PFNGLREADBUFFERPROC, ReadBuffer) \
    X(PFNGLSHADERSOURCEPROC, ShaderSource) X(PFNGLTEXBUFFERPROC, TexBuffer) \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D) X(PFNGLTEXPARAMETERIPROC, TexParameteri) X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D) \
    X(PFNGLUNIFORM1FPROC, Uniform1f) X(PFNGLUNIFORM1IPROC, Uniform1i) X(PFNGLUNIFORM2FPROC, Uniform2f) \
    X(PFNGLUNIFORM3FPROC, Uniform3f) X(PFNGLUNIFORM4FPROC, Uniform4f) \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv) X(PFNGLUSEPROGRAMPROC, UseProgram) \
    X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor) X(PFNGLVERTEXATTRIBIPOINTERPROC, VertexAttribIPointer) \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer) X(PFNGLVIEWPORTPROC, Viewport)
// clang-format on

/// The functions of OpenGL 3.3 core that the renderer calls, without their `gl` prefix; resolved once per
/// context.
struct GlFunctions {
    /// @throws std::runtime_error naming the first function the context lacks
    explicit GlFunctions(const Renderer::Resolver& resolver);

#define ESM_GL_MEMBER(type, name)                                                                            \
    type name = nullptr; // NOLINT(readability-identifier-naming): OpenGL's names
    ESM_GL_FUNCTIONS(ESM_GL_MEMBER)
#undef ESM_GL_MEMBER
};

} // namespace esm
