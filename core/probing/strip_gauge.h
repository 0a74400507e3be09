#pragma once

#include "core/probing/strip_cutting.h"

namespace esm {

/// Reads the strain of a strip's tissue in its middle, as a camera does in the laboratory: next to the
/// clamps, and where a bent strip is straightened, the clamps' way says little of it. What lies further from
/// the middle counts for less, to nothing at a third of the strip's length.
class StripGauge {
public:
    StripGauge(const CutStrip& strip, double length);

    /// A mean, along the strip. Of tissue that carries one force from clamp to clamp, force and strain give
    /// force / (crossSection()·strain), its modulus, also where the strip is not everywhere as wide.
    double strain(const std::vector<Eigen::Vector3d>& positions) const;
    /// Of the strip at rest, a mean: m² of a solid, the width in m of a wall.
    double crossSection() const { return m_whole / m_window; }

private:
    struct Watched {
        TissueCell cell;
        Eigen::Vector3d mix; ///< by which the cell's edges from its first corner make the way along the strip
        double weight;       ///< m² or m³
    };
    Eigen::Vector3d m_along; ///< of length 1
    std::vector<Watched> m_watched;
    double m_whole = 0;  ///< sum of the weights
    double m_window = 0; ///< m, of the strip's length that the weights stand for
};

} // namespace esm
