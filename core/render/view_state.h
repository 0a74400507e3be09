#pragma once

#include "core/render/colouring.h"
#include "core/render/cut_plane.h"

namespace esm {

/// What is shown of an organ, wherever it is looked at from and in whatever projection: both are the
/// camera's.
struct ViewState {
    bool surface = true, wireframe = false, springs = false, nodes = false, regions = true;
    ColourBy colourBy = ColourBy::Texture;
    SceneLight light = SceneLight::Room;
    std::optional<Cut> cut;

    bool operator==(const ViewState&) const = default;
};

/// Shows and hides the organ's parts, and cuts it as it is drawn now. A pure motion model keeps its springs.
void showParts(RenderScene& scene, const ViewState& view, const Camera& camera);

} // namespace esm
