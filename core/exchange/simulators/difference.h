#pragma once

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Something of an organ that the program it is handed to does not do as it is done here.
struct Difference {
    std::string what;    ///< it cannot carry, as a sentence
    std::string instead; ///< what stands in its place, as a sentence

    bool operator==(const Difference&) const = default;
};

/// What will differ after handing an organ over.
struct Differences {
    std::vector<Difference> list = {};
    std::string scheme = {};  ///< by which the target steps the organ; empty where that is not said to it
    double timeStep = 0;      ///< s, that it is handed over with
    double largestStep = 0;   ///< s, predicted for that scheme; infinite where it has no limit
    std::string caution = {}; ///< why motion in these steps may be far from ours; empty where it is near
    std::string refusal = {}; ///< why it cannot be handed over; empty where it can, else all that there is

    /// Whether the step that it is handed over with is longer than the target bears.
    bool blowsUp() const { return !scheme.empty() && timeStep > largestStep; }
    /// Whether the step that it is handed over with may spoil the motion.
    bool hasPoorStep() const { return blowsUp() || !caution.empty(); }
};

} // namespace esm
