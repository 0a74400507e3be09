#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm {

/// Tissue as somebody published it, in words, with the mass of the organ and what holds it in place. Nothing
/// of it knows another organ's size or number of springs: it is taken as it was published.
struct TissuePreset {
    std::string name;                          ///< one word: "tube"
    std::string title;                         ///< for people
    std::string description;                   ///< a sentence or two in plain words
    std::string source;                        ///< where it was published
    std::shared_ptr<const FuzzySystem> system; ///< null: tissue stays as it was
    NamedValues inputs;
    TissueValues published; ///< what the words came to at the source, and the mass of the whole organ
    std::vector<TetherRule> tethers; ///< of the whole organ; none: they stay as they were
};

/// Gives a region the preset's words, in place of what it had and of what was held of stiffness and
/// viscosity.
void layPreset(Region& region, const TissuePreset& preset);

/// Ties the whole organ to its surroundings as the preset does.
void tiePreset(Scene& scene, const TissuePreset& preset);

/// "81.3091 N/m, 6 N·s/m, 0.5 kg", and the tethers.
std::string publishedText(const TissuePreset& preset);

} // namespace esm
