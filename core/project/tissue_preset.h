#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm {

/// What the words of a preset came to where they were published, or what was measured.
struct PublishedTissue {
    std::optional<double> springConstant; ///< N/m
    std::optional<double> viscosity;      ///< N·s/m
    std::optional<double> youngsModulus;  ///< Pa
    std::optional<double> relaxationTime; ///< s

    bool operator==(const PublishedTissue&) const = default;
};
template<>
inline constexpr auto fieldsOf<PublishedTissue> = fieldTable(
    field("spring_constant", &PublishedTissue::springConstant, amountLimits("the spring constant", "N/m"))
        .whenSet(),
    field("viscosity", &PublishedTissue::viscosity, amountLimits("the viscosity", "N·s/m")).whenSet(),
    field("youngs_modulus", &PublishedTissue::youngsModulus, amountLimits("Young's modulus", "Pa")).whenSet(),
    field("relaxation_time", &PublishedTissue::relaxationTime, amountLimits("the relaxation time", "s"))
        .whenSet());

/// Tissue as somebody published it, in words, with the mass of the organ and what holds it in place. Nothing
/// of it knows another organ's size or number of springs: it is taken as it was published.
struct TissuePreset {
    std::string name;                          ///< one word: "tube"
    std::string title;                         ///< for people
    std::string description;                   ///< a sentence or two in plain words
    std::string source;                        ///< where it was published
    std::shared_ptr<const FuzzySystem> system; ///< null: tissue stays as it was
    NamedValues inputs;                        ///< of the system
    PublishedTissue published;
    std::optional<double> mass;      ///< kg, of the whole organ
    std::vector<TetherRule> tethers; ///< of the whole organ; none: they stay as they were
};
template<>
inline constexpr auto fieldsOf<TissuePreset> =
    fieldTable(field("name", &TissuePreset::name), field("title", &TissuePreset::title),
               field("description", &TissuePreset::description), field("source", &TissuePreset::source),
               field("system", &TissuePreset::system).whenSet(),
               field("inputs", &TissuePreset::inputs).onlyWhere([](const TissuePreset& preset) {
                   return preset.system != nullptr;
               }),
               field("published", &TissuePreset::published).whenSet(),
               field("mass", &TissuePreset::mass, massLimits("the mass")).whenSet(),
               field("tethers", &TissuePreset::tethers).whenSet());

/// Gives a region the preset's words, in place of what it had and of what was held of stiffness and
/// viscosity.
void layPreset(Region& region, const TissuePreset& preset);

/// Ties the whole organ to its surroundings as the preset does.
void tiePreset(Scene& scene, const TissuePreset& preset);

/// Whether the tissue still is what the preset made of it: of a region, with the base mass and the tethers
/// where it is the whole organ's; without a region the tethers of a preset that has nothing else.
bool isAsPublished(const Project& project, const Region* region, const TissuePreset& preset);

/// Whether it is tissue that was measured, in clinical units, not that of a published simulator.
bool isMeasured(const TissuePreset& preset);

/// "81.3091 N/m, 6 N·s/m, 0.5 kg", and the tethers; "5.49 kPa, 0.07 s" of tissue that was measured.
std::string publishedText(const TissuePreset& preset);

} // namespace esm
