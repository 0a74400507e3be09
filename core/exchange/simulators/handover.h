#pragma once

#include "core/exchange/picture_encoding.h"
#include "core/project/project.h"
#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/layers/tiled_pages.h"

#include <functional>

namespace esm {

/// What the layers come to on the pages of a project's atlas.
struct PackagePages {
    std::shared_ptr<const std::vector<Image>> colours; ///< null without an atlas
    std::shared_ptr<const TiledPages> finish;          ///< null where all shines alike, see `finishPages`
};

/// Draws a picture of the organ.
using DrawPreview = std::function<Image(const Project& project, const PackagePages& pages)>;

/// A project with all that a simulator needs to know of it, valid and evaluated once.
struct Handover {
    Project project; ///< with an atlas, where photos lie on a surface
    TissueModel tissue;
};

/// Photos of a project whose atlas is not packed yet get one packed with the project's settings.
/// @throws InvalidModel with every problem of the project and of the tissue that it comes to; Cancelled
Handover handoverOf(const Project& project, const Progress& progress = {});

/// What helps to write a handover, beside the handover itself.
struct HandoverMeans {
    Progress progress;
    DrawPreview drawPreview; ///< none: without a picture
    PictureEncoding pictures = {};
};

} // namespace esm
