#pragma once

#include "core/geometry/collider.h"
#include "core/geometry/ellipsoid.h"
#include "core/geometry/triangle_mesh.h"
#include "core/model/spring_network.h"
#include "core/render/camera.h"
#include "core/render/cut_plane.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/finish/surface_finish.h"
#include "core/texture/image.h"
#include "core/texture/layers/blending.h"
#include "core/texture/layers/page_levels.h"
#include "core/texture/layers/tiled_pages.h"
#include "core/texture/projection/projector.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace esm {

using Colour = std::array<std::uint8_t, 3>; ///< red, green, blue
using Paint = std::array<std::uint8_t, 4>;  ///< the same, and how much it covers

struct DrawnEllipsoid {
    Ellipsoid shape;
    Colour colour{63, 182, 168};
    bool selected = false;
    double rim = 0; ///< m around it; its end is a broken outline
};

/// Nodes and the springs between them that are marked as belonging together.
struct MarkedNodes {
    std::shared_ptr<const std::vector<double>> weights; ///< one per node: 0 is not marked, 1 in full
    Colour colour{63, 182, 168};                        ///< of springs that have no value's colour, and nodes
};

struct DrawnProjector {
    Projector projector;
    std::shared_ptr<const Image> photo; ///< shown half-transparently on the box's face; may be null
    bool selected = false;
    bool isLaid = false; ///< the scene's texture shows the photo on the organ
    double cover = 0.35; ///< how much the photo on the box's face hides of what lies behind it, 0 to 1
    double depth = 0;    ///< m, where the photo is shown: see `shownDepth`

    PhotoSize size() const {
        return photo && !photo->empty() ? PhotoSize{photo->width, photo->height} : PhotoSize{1, 1};
    }
};

/// A photo that is projected onto the surface without being painted, as while its projector moves.
struct ProjectedPhoto {
    Projector projector;
    std::shared_ptr<const Image> photo; ///< may be null: nothing is projected
    double blendPixels = 0; ///< photo pixels over which the weight rises from 0 at the border to 1
    double opacity = 1;     ///< 0 to 1
    Blending blending = Blending::Normal;
    bool isMasked = false;                ///< the texture's alpha is how much of it strokes have left
    bool fadesAtMask = false;             ///< see `fadesAtMask`
    std::shared_ptr<const Image> bands{}; ///< added to the photo, see `bandsAddedTo`; null for nothing
};

/// What light falls on the organ.
enum class SceneLight {
    Room,     ///< a soft sky and two lamps, as over a table
    Endoscope ///< the lamp at the eye, weaker with the square of the distance, in a dark cavity
};

/// Everything one picture shows. Shared parts are compared by pointer and uploaded only when they change.
struct RenderScene {
    std::shared_ptr<const TriangleMesh> mesh;
    std::shared_ptr<const SpringNetwork> network;
    /// m, one per node (without a network per vertex); else the rest shape
    std::vector<Eigen::Vector3d> nodePositions;
    std::shared_ptr<const Atlas> atlas;             ///< null: base colour only
    std::shared_ptr<const TiledPages> texturePages; ///< null: base colour only
    /// Of each page, as `smallerPages` makes them; null: small surface flickers
    std::shared_ptr<const SmallerPages> smallerPages;
    Colour baseColour{186, 92, 84};
    SceneLight light = SceneLight::Room;
    std::optional<SurfaceFinish> finish; ///< where pages have none; none: tissue shines as it always did
    std::shared_ptr<const TiledPages>
        finishPages; ///< like the texture's, see `composedFinish`; null for none
    bool showSurface = true;
    bool showWireframe = false; ///< the triangles' edges, over the surface or in its place
    bool showSprings = false;   ///< a network without triangles always shows them, and its nodes
    bool showNodes = false;
    bool unlit = false; ///< the texture's own colours, without light
    /// Over the surface's own colours, one per node (without a network per vertex); may be null.
    std::shared_ptr<const std::vector<Paint>> nodePaint;
    /// One per spring; may be null. A spring whose paint covers nothing is drawn quietly.
    std::shared_ptr<const std::vector<Paint>> springPaint;
    std::optional<CutPlane> cut;           ///< through the organ, of which it hides a part
    std::vector<std::uint32_t> fixedNodes; ///< held in space: white dots with a dark edge
    std::optional<MarkedNodes> marked;     ///< over the surface, whether or not all springs are shown
    std::vector<DrawnEllipsoid> ellipsoids;
    std::vector<DrawnProjector> projectors;
    std::optional<ProjectedPhoto> projectedPhoto; ///< over the texture
    std::vector<PlacedCollider> instruments;
    std::optional<PlacedCollider> heldInstrument; ///< by the hand
    Colour backgroundTop{57, 64, 71}, backgroundBottom{29, 32, 37};
};

/// A picture of `width` times `height` pixels, of which the bound target shows the part from `left`, `bottom`
/// on.
struct PictureSize {
    int width = 0, height = 0;
    double pixelRatio = 1;    ///< pixels per pixel of the design, as lines have a width
    int left = 0, bottom = 0; ///< pixels
};

/// Draws into the bound target of the current OpenGL 3.3 core context. One instance per context.
class Renderer {
public:
    using Resolver = std::function<void*(const char* name)>; ///< address of a GL function

    /// @throws std::runtime_error when a function is missing or a shader does not compile
    explicit Renderer(const Resolver& resolver);
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    ~Renderer(); ///< needs the context current

    /// Expects indices in range: a mesh and a network as import and `validate` leave them. Leaves neither
    /// program, vertex array nor texture bound, and depth test and blending off.
    void draw(const RenderScene& scene, const Camera& camera, const PictureSize& size);

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

} // namespace esm
