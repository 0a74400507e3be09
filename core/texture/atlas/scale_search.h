#pragma once

#include "core/texture/atlas/atlas.h"
#include "core/texture/atlas/patch_layout.h"

#include <functional>

namespace esm {

/// A layout at so many texels per metre, in the mesh's order.
using LayoutAt = std::function<PatchLayout(const AtlasOptions&, double scale, const Progress&)>;

/// How many layouts a search tries is not known: of what is left of its progress, each takes this share.
constexpr double shareOfAttempt = 0.2;

bool fits(const PatchLayout& layout, const AtlasOptions& options);

struct ScaledLayout {
    double scale = 0; ///< texels per m; 0 where nothing fits
    PatchLayout layout;
};

struct ScaleRange {
    double smallest; ///< texels per m; a smaller one would be no texture
    double bound;    ///< that no layout can reach
};

/// The source's iteration down to a scale that fits [R 4.9, 4.10]. It slows down the nearer it comes, so
/// halving the interval between the last two scales ends it.
ScaledLayout largestBySource(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range,
                             const Progress& progress);

/// Areas grow with the square of the scale: the height that a layout takes tells where to go on. A few steps
/// do, as long as it tells the truth; else halving the interval does.
ScaledLayout largestByHeight(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range,
                             const Progress& progress);

} // namespace esm
