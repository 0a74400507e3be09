#pragma once

#include "core/render/frame.h"
#include "core/render/gl_objects.h"
#include "core/texture/layers/composition_cache.h"

#include <memory>
#include <optional>

namespace esm {

/// A depth picture with a target of its own.
class GlDepthMap {
public:
    explicit GlDepthMap(const GlFunctions& gl);
    GlDepthMap(const GlDepthMap&) = delete;
    GlDepthMap& operator=(const GlDepthMap&) = delete;
    ~GlDepthMap();

    /// Calls `draw` with the cleared map bound as the target and the viewport; then the target that was bound
    /// is bound again.
    template<typename Draw> void render(int width, int height, const Draw& draw) {
        GLint before = 0;
        m_gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
        begin(width, height);
        draw();
        m_gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before));
    }
    /// Shaders compare with it, as a `sampler2DShadow`.
    void bind(int unit) const;

private:
    void begin(int width, int height);

    const GlFunctions& m_gl;
    GLuint m_texture = 0, m_target = 0;
    int m_width = 0, m_height = 0;
};

/// Projects a photo onto the surface while it is drawn, as composing would paint it: the same weights of
/// border, alpha and angle, and, where the projector asks for it, only what it sees, by a depth map from
/// there. On the organ at rest, however it is drawn, so that what is projected lies where it will be painted.
class PhotoProjection {
public:
    explicit PhotoProjection(const GlFunctions& gl);

    /// Draws the depth map where the projector or the organ is another one; changes the viewport.
    /// Precondition: the photo is not empty.
    void take(const ProjectedPhoto& projected, const std::shared_ptr<const TriangleMesh>& mesh,
              const Frame& frame);
    /// Tells the program in use, made with a photo among its `SurfaceParts`.
    void bind(const GlProgram& program) const;

private:
    void takeMesh(const std::shared_ptr<const TriangleMesh>& mesh, const Frame& frame);
    void takePhoto(const std::shared_ptr<const Image>& photo);
    void takeBands(const std::shared_ptr<const Image>& bands);
    void takeFade();
    void measureDepth();
    void drawDepth();

    const GlFunctions& m_gl;
    GlProgram m_depthProgram;
    GlBuffer m_vertexBuffer, m_indexBuffer;
    GlTexture m_vertexTexture;
    GlVertexArray m_array;
    GlDepthMap m_seen;
    std::shared_ptr<const TriangleMesh> m_mesh;
    std::shared_ptr<const Image> m_photo;
    std::unique_ptr<GlTexture> m_photoTexture;
    std::shared_ptr<const Image> m_bands;
    GlTexture m_fadeTexture, m_bandTexture;
    std::shared_ptr<const PhotoFade> m_fade; ///< null where nothing fades
    int m_mapSize = 0;                       ///< pixels of the depth map's longer side
    SeenSide m_side = SeenSide::Both;        ///< that is coloured, of the whole surface
    CompositionCache m_cache;                ///< of the mesh
    std::optional<ProjectedPhoto> m_projected;
    Eigen::Matrix4d m_matrix;     ///< as `photoMatrix`, from the frame's origin
    Eigen::Vector4f m_light;      ///< where the light comes from (w 1), or in which direction (w 0)
    double m_near = 0, m_far = 1; ///< m before the projector, of the depth map
    double m_tolerance = 0;       ///< m
};

} // namespace esm
