#pragma once

#include "core/project/project.h"

namespace esm {

/// What an edit changes, where edits of it that follow each other are one step for the user.
enum class EditKind {
    Alone, ///< a step of its own, whatever comes next
    // The whole organ.
    BaseTissue,
    Stiffening,
    WallThickness,
    FixedNodes,
    FluidStiffness,
    FluidPressure,
    // A region.
    HeldValue,
    Input,
    InputPair,
    EllipsoidCentre,
    EllipsoidRadii,
    EllipsoidTurn,
    RegionShape,
    SoftRim,
    // A region's fuzzy system.
    NewTerm,
    Rules,
    TermShape,
    VariableRange,
    // A photo or painted layer.
    Adjustment,
    BrushStroke,
    Crop,
    EvenLight,
    FadingBorder,
    Field,
    Finish,
    Highlights,
    Landmarks,
    Opacity,
    ProjectorCalibration,
    ProjectorCarrying,
    ProjectorDrag,
    ProjectorPosition,
    ProjectorSize,
    ProjectorTurn
};

/// Edits that follow each other with the same key become one step.
struct MergeKey {
    EditKind kind = EditKind::Alone;
    std::uint32_t part = 0;  ///< number of the region's or layer's identity
    std::uint64_t place = 0; ///< within the part: which parameter, input, stroke

    MergeKey() = default;
    explicit MergeKey(EditKind kind, std::uint64_t place = 0) : kind(kind), place(place) {}
    template<typename Part>
    MergeKey(EditKind kind, const Id<Part>& id, std::uint64_t place = 0)
        : kind(kind), part(id.number), place(place) {}

    bool operator==(const MergeKey&) const = default;
};

} // namespace esm
