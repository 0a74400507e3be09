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

/// The same projector of another kind, its photo in the same place and size where its middle meets the organ.
Projector ofKind(ProjectorKind kind, const Projector& before, const Image& photo, const TriangleMesh& mesh);

} // namespace esm
