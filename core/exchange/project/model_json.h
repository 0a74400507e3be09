#pragma once

#include "core/exchange/tissue_json.h"
#include "core/project/project.h"

/// What the project file and the model package hold alike, besides their regions.
namespace esm {

/// What decides a file's version.
struct VersionNeeds {
    bool binding = false;           ///< a surface that is carried by fewer nodes: version 2
    bool stiffening = false;        ///< biphasic springs: version 3
    bool extendedInference = false; ///< norms, weights, OR or NOT in a fuzzy system: version 4
    bool softRims = false;          ///< regions that fade into what lies beneath: version 5
    bool perspective = false;       ///< photos projected in perspective or with falloff: version 6
    bool preparation = false;       ///< photos that are prepared: version 7
    bool painting = false;          ///< layers painted or blended otherwise than by hiding: version 8
    bool landmarks = false;         ///< photos with landmarks: version 8
    bool maskedPhotos = false;      ///< photos with strokes, or their colours matched: version 8
    bool instruments = false;       ///< others than one sphere without a name or a turn: version 9
    bool splits = false;            ///< a scene that splits the organ: version 9
    bool wideBinding = false;       ///< more than three nodes that carry one vertex: version 9
    bool shapedMasks = false;       ///< fields and masks of any shape, highlights by surroundings: version 10
    bool finish = false;            ///< how the surface shines: version 11
    bool stretchedLayout = false;   ///< a mesh's own texture coordinates, or triangles stretched: version 11
    bool lattice = false;           ///< a body that is filled: version 12
    bool clinicalUnits = false; ///< fuzzy systems that say moduli or times, a wall's thickness: version 13
    bool sheet = false;         ///< springs that make an even sheet: version 13
    bool fluids = false;        ///< parts that fluid fills or presses: version 13
    bool bending = false;       ///< a wall that resists bending: version 13
    bool prisms = false;        ///< a wall of prisms: version 13
    bool graded = false;        ///< a graded lattice: version 13
    bool retouching = false; ///< adjusted colours, newer blendings, strokes that heal or of a pen: version 11
};

/// Whether a system says tissue in clinical units, which older programs take for nothing.
bool needsClinicalUnits(const FuzzySystem& system);

/// Whether older programs would misread a system: version 4.
bool needsExtendedInference(const FuzzySystem& system);

/// What the regions and their fuzzy systems need, with what else does.
VersionNeeds needsOf(const std::vector<Region>& regions, const BaseTissue& base, bool binding);

/// The oldest that has all of it, so that older programs go on reading all that they understand.
int versionOf(const VersionNeeds& needs);

} // namespace esm
