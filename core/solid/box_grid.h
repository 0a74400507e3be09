#pragma once

#include <Eigen/Core>

#include <cstddef>

namespace esm {

/// Places of a grid in a box and their numbers, x before y before z.
struct BoxGrid {
    Eigen::Vector3i counts;

    std::size_t size() const {
        return static_cast<std::size_t>(counts.x()) * static_cast<std::size_t>(counts.y()) *
               static_cast<std::size_t>(counts.z());
    }
    bool holds(const Eigen::Vector3i& place) const {
        return (place.array() >= 0).all() && (place.array() < counts.array()).all();
    }
    /// Precondition: `holds(place)`.
    std::size_t numberOf(const Eigen::Vector3i& place) const {
        return (static_cast<std::size_t>(place.z()) * static_cast<std::size_t>(counts.y()) +
                static_cast<std::size_t>(place.y())) *
                   static_cast<std::size_t>(counts.x()) +
               static_cast<std::size_t>(place.x());
    }
    Eigen::Vector3i placeAt(std::size_t number) const {
        const auto x = static_cast<std::size_t>(counts.x()), y = static_cast<std::size_t>(counts.y());
        return {static_cast<int>(number % x), static_cast<int>(number / x % y),
                static_cast<int>(number / x / y)};
    }
};

} // namespace esm
