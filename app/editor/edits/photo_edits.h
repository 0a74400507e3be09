#pragma once

#include "core/project/project.h"
#include "core/render/camera.h"

#include <cstddef>
#include <memory>

namespace esm {

/// A projector between the eye and the organ that looks where the camera looks, with the photo's proportions
/// and 40 % of the organ's size.
Projector projectorFromCamera(const Camera& camera, const Image& photo, const TriangleMesh& mesh);

/// The selected photo thrown from where the camera looks, as its kind does it: a perspective one shows
/// exactly what is seen, its height filling the picture's; a parallel one keeps its size.
Projector aimedByCamera(const Projector& before, const Camera& camera, const Image& photo,
                        const TriangleMesh& mesh);

/// The same projector of another kind, its photo in the same place and size where its middle meets the organ.
Projector ofKind(ProjectorKind kind, const Projector& before, const Image& photo, const TriangleMesh& mesh);

/// A photo on top of the others, thrown by `projector` with falloff; `atlas` is taken where the project has
/// none.
void addPhoto(Project& project, std::shared_ptr<const Photo> photo, const Projector& projector,
              std::shared_ptr<const Atlas> atlas);

/// A layer to paint on, on top of the others; `atlas` as above.
void addPaintLayer(Project& project, std::shared_ptr<const Atlas> atlas);

void removePhoto(Project& project, std::size_t photo);

/// Lays a photo over so many of those above it, or under those below it where `above` is below zero.
bool canMovePhoto(const Project& project, std::size_t photo, int above);
void movePhoto(Project& project, std::size_t photo, int above);

} // namespace esm
