#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"
#include "core/texture/layers/texture_layer.h"

#include <optional>
#include <vector>

namespace esm {

/// A projector moved so that its photo lies on what other layers show of the same surface.
struct PoseRefinement {
    Projector projector;    ///< with another pose
    double errorBefore = 0; ///< how far photo and surface differ, by the contrast of their surroundings: 0
                            ///< where they show the same, about 1.4 where they have nothing in common
    double errorAfter = 0;
    double moved = 0; ///< photo pixels by which the surface is seen elsewhere, root of the mean square
};

/// Refines where a photo was taken from by the photo itself: the pose from which it agrees best with the
/// layers beneath, near the one it has. Nothing where it meets too little of what they colour, or where no
/// pose near agrees better and well. Precondition: the layer has a photo.
/// @param beneath from the lowest to the topmost
/// @throws Cancelled
std::optional<PoseRefinement> refinedPose(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                                          const TextureLayer& layer, const Progress& progress = {});

} // namespace esm
