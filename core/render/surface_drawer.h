#pragma once

#include "core/render/frame.h"
#include "core/render/gl_objects.h"
#include "core/render/photo_projection.h"
#include "core/render/shaders.h"

#include <memory>
#include <utility>
#include <vector>

namespace esm {

/// Draws an organ's surface, lit or not, with its texture pages where there are any.
class SurfaceDrawer {
public:
    explicit SurfaceDrawer(const GlFunctions& gl);

    /// @param photo what is projected onto the surface over its texture; may be null
    void draw(const RenderScene& scene, const std::vector<Eigen::Vector3d>& vertices, const Frame& frame,
              const PhotoProjection* photo);

private:
    struct PageRange {
        std::size_t page;
        GLint first;
        GLsizei count;
    };

    void takeVertices(const RenderScene& scene, const std::vector<Eigen::Vector3d>& vertices,
                      const Frame& frame);
    void takeTriangles(const std::shared_ptr<const TriangleMesh>& mesh);
    void takeAtlas(const std::shared_ptr<const Atlas>& atlas);
    void takePages(const RenderScene& scene);
    void takeFinish(const std::shared_ptr<const TiledPages>& pages);
    const GlProgram& programFor(const shaders::SurfaceParts& parts);
    static void setFinish(const GlProgram& program, const RenderScene& scene, const Frame& frame);
    bool hidesItsInside(const RenderScene& scene, const Frame& frame) const;
    void drawPlain(const GlProgram& program) const;
    /// @param areMasked their alpha is what is left of the photo over them
    void drawPages(const GlProgram& program, bool areMasked) const;

    const GlFunctions& m_gl;
    /// Made when first needed, which of all that there could be are few.
    std::vector<std::pair<shaders::SurfaceParts, std::unique_ptr<GlProgram>>> m_programs;
    GlBuffer m_vertexBuffer, m_indexBuffer, m_cornerBuffer;
    GlTexture m_vertexTexture;
    GlVertexArray m_plainArray, m_texturedArray;
    std::shared_ptr<const TriangleMesh> m_mesh;
    std::shared_ptr<const Atlas> m_atlas;
    std::shared_ptr<const TiledPages> m_pages;
    std::shared_ptr<const SmallerPages> m_smallerPages;
    std::shared_ptr<const TiledPages> m_finishPages;
    std::vector<std::unique_ptr<GlTexture>> m_pageTextures, m_finishTextures;
    std::vector<PageRange> m_ranges;
    bool m_closed = false;                   ///< the surface has no border and agrees in orientation
    std::vector<Eigen::Vector3d> m_vertices; ///< as last uploaded
    std::shared_ptr<const std::vector<Paint>> m_nodePaint; ///< as last uploaded
    /// Per vertex: position, colour as a number, normal, how much of the colour.
    std::vector<std::array<float, 8>> m_texels;
};

} // namespace esm
