#pragma once

#include "core/project/project.h"

#include <memory>

namespace esm {

/// A photo on top of the others, projected by `projector` with falloff; `atlas`, never null, is taken where
/// the project has none. Precondition, here and below: `id` is not another's, see nextId().
void addPhoto(Project& project, LayerId id, std::shared_ptr<const Photo> photo, const Projector& projector,
              std::shared_ptr<const Atlas> atlas);

/// A layer to paint on, on top of the others; `atlas` as above.
void addPaintLayer(Project& project, LayerId id, std::shared_ptr<const Atlas> atlas);

/// A copy just above a layer, with all that belongs to it: photo, placement, preparation, landmarks, strokes.
/// Precondition: the project has that layer.
void duplicateLayer(Project& project, LayerId layer, LayerId copy);

/// Nothing where it is not there.
void removeLayer(Project& project, LayerId layer);

/// Lays a layer over so many of those above it, or under those below it where `above` is below zero.
bool canMoveLayer(const Project& project, LayerId layer, int above);
void moveLayer(Project& project, LayerId layer, int above);

} // namespace esm
