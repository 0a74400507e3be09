#pragma once

#include "app/editor/workers/imported_surface.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/render/renderer.h"

namespace esm {

/// A surface as it would stand in the window, its open borders as amber lines.
RenderScene importPreview(const ImportedSurface& surface, LengthUnit unit, UpAxis up);

} // namespace esm
