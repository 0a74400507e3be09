#pragma once

#include "core/model/tissue_model.h"
#include "core/project/region.h"
#include "core/render/renderer.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the colours of an organ mean.
namespace esm {

enum class ColourBy { Texture, SpringConstant, Viscosity, Mass, Strain, Speed, Region };
inline constexpr std::array<ColourBy, 7> everyColouring{
    ColourBy::Texture, ColourBy::SpringConstant, ColourBy::Viscosity, ColourBy::Mass,
    ColourBy::Strain,  ColourBy::Speed,          ColourBy::Region};

/// "texture", "spring-constant", "viscosity", "mass", "strain", "speed" or "region".
std::string nameOf(ColourBy by);
std::optional<ColourBy> colourByFromName(std::string_view name);
/// Whether the values are those of the moving tissue, so that each frame has others.
bool followsMotion(ColourBy by);

struct ValueRange {
    double minimum = 0, maximum = 0;

    bool operator==(const ValueRange&) const = default;
};

/// What colours mean, for people.
struct ColourLegend {
    struct Entry {
        std::string name;
        Colour colour;
    };
    std::string title;          ///< "Spring constant"
    std::string unit;           ///< "N/m"; empty where there are entries in place of values
    ValueRange range;           ///< in the unit
    std::vector<Entry> entries; ///< the regions, the one that counts first
};

/// What there is to colour by. Its parts outlive its use.
struct ColourSources {
    const TissueModel& tissue;
    const std::vector<Region>& regions;
    const std::vector<double>& speeds; ///< m/s, one per node, of moving tissue; else empty
};

/// Colours springs and surface of a scene, which has the tissue's network; a node's strain is the largest of
/// its springs'. By texture the surface keeps its own colours, and springs show their constants.
///
/// Ranges of what is set go from the least to the largest. Those of motion go from 0 to a round value that
/// never falls, lest colours flicker.
/// @param range of the last scene where that goes on, as it was given back; is replaced by the present one,
/// none for regions
/// @returns none where nothing has a value: then nothing is coloured
std::optional<ColourLegend> colourScene(RenderScene& scene, ColourBy by, const ColourSources& from,
                                        std::optional<ValueRange>& range);

} // namespace esm
