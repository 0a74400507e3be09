#pragma once

#include "core/project/project.h"
#include "core/render/camera.h"

namespace esm {

/// A projector between the eye and the organ that looks where the camera looks, with the photo's proportions
/// and 40 % of the organ's size.
Projector projectorFromCamera(const Camera& camera, const Image& photo, const TriangleMesh& mesh);

/// The selected photo projected from where the camera looks, as its kind does it: a perspective one shows
/// exactly what is seen, its height filling the picture's, of an orthographic view what lies at the target's
/// depth; a parallel one keeps its size.
Projector aimedByCamera(const Projector& before, const Camera& camera, const Image& photo,
                        const TriangleMesh& mesh);

/// The camera that sees a projector's whole photo where it is projected, in a picture of this aspect (width
/// over height): from the eye of a perspective one, with its lens; without perspective along the axis of a
/// parallel one. Its target is where the axis meets the organ.
Camera cameraThrough(const Projector& projector, PhotoSize photo, const TriangleMesh& mesh, double aspect);

/// The same projector of another kind, its photo in the same place and size where its middle meets the organ.
Projector ofKind(ProjectorKind kind, const Projector& before, const Image& photo, const TriangleMesh& mesh);

} // namespace esm
