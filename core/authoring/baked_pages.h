#pragma once

#include "core/project/project.h"
#include "core/support/progress.h"
#include "core/texture/layers/tiled_pages.h"

#include <memory>
#include <vector>

namespace esm {

/// What the layers come to on the pages of a project's atlas.
struct BakedPages {
    std::shared_ptr<const std::vector<Image>> colours; ///< null without an atlas
    std::shared_ptr<const TiledPages> finish;          ///< null where all shines alike, see `finishPages`
};

/// @throws Cancelled
BakedPages bakedPages(const Project& project, const Progress& progress = {});

} // namespace esm
