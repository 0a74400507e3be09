#pragma once

#include "core/texture/layers/brush_stroke.h"

#include <vector>

namespace esm {

/// Where a stroke meets its surroundings, told by discs along its path. Corners of the path that lie between
/// two discs are cut.
class StrokeOutline {
public:
    explicit StrokeOutline(const BrushStroke& stroke);

    /// Places a little outside of the stroke, in the planes that touch the surface along its path, with the
    /// surface's normal there.
    std::vector<BrushPoint> placesAround() const;
    bool isOutside(const Eigen::Vector3d& place) const { return isBeyond(place, 1); }
    double spacing() const { return m_spacing; } ///< m, about how far the places lie from one another

private:
    struct Disc {
        BrushPoint point; ///< its normal of length 1
        double radius;    ///< m
    };
    /// @param share of the radius
    bool isBeyond(const Eigen::Vector3d& place, double share) const;

    double m_spacing;
    std::vector<Disc> m_discs; ///< joined by straight lines
};

/// How much what lies around a stroke differs from what it copies there. Added to the copy, it lets that pass
/// into its surroundings without a step, and keep its own details.
class HealingRim {
public:
    struct Place {
        Eigen::Vector3d at;         ///< m
        Eigen::Vector3f difference; ///< red, green, blue, −255 to 255
    };

    /// @param spacing m, about how far the places lie from one another
    HealingRim(const std::vector<Place>& places, double spacing);

    /// What is added at a point within; zero where nothing is known around the stroke.
    Eigen::Vector3f at(const Eigen::Vector3d& point) const;

private:
    Eigen::Matrix3Xd m_places;
    Eigen::Matrix3Xf m_differences;
    double m_blur; ///< m², added to squared distances
};

} // namespace esm
