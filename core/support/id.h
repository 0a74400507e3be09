#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace esm {

/// Which of its kind a part of a project is. It stays the same while the part is edited, renamed or moved in
/// its list, and files do not hold it: see numberByPlace().
template<typename Part> struct Id {
    std::uint32_t number = 0; ///< from 1; 0: not given yet

    bool operator==(const Id&) const = default;
};

/// Gives the struct that stands on it an identity. Which one makes no two parts differ: they are equal where
/// they say the same.
template<typename Part> struct Identified {
    Id<Part> id;

    friend bool operator==(const Identified&, const Identified&) { return true; }
};

/// Where a part lies in its list; none where it is not there.
template<typename Part>
std::optional<std::size_t> placeOf(const std::vector<Part>& parts, const Id<Part>& id) {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.id == id; });
    if (found == parts.end()) return std::nullopt;
    return static_cast<std::size_t>(found - parts.begin());
}

/// Null where it is not there.
template<typename Part> const Part* findPart(const std::vector<Part>& parts, const Id<Part>& id) {
    const auto place = placeOf(parts, id);
    return place ? &parts[*place] : nullptr;
}

/// @throws std::bad_optional_access where it is not there
template<typename Part> Part& partOf(std::vector<Part>& parts, const Id<Part>& id) {
    return parts[placeOf(parts, id).value()];
}
template<typename Part> const Part& partOf(const std::vector<Part>& parts, const Id<Part>& id) {
    return parts[placeOf(parts, id).value()];
}

/// One above the highest that is given.
template<typename Part> Id<Part> nextId(const std::vector<Part>& parts) {
    Id<Part> highest;
    for (const Part& part : parts)
        highest.number = std::max(highest.number, part.id.number);
    return {highest.number + 1};
}

/// Gives the parts of a list that was loaded or made the identities 1, 2, … in its order.
template<typename Part> void numberByPlace(std::vector<Part>& parts) {
    std::uint32_t number = 0;
    for (Part& part : parts)
        part.id = {++number};
}

} // namespace esm
