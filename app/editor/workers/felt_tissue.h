#pragma once

#include "core/geometry/collider.h"

#include <optional>
#include <vector>

namespace esm {

/// What a hand feels of the tissue that it moves.
struct FeltTissue {
    double force = 0;        ///< N
    double displacement = 0; ///< m, of the tissue there, from rest
};

/// A mean that forgets, so that a force can be read while tissue trembles.
class ForceMean {
public:
    /// @param seconds of simulated time that the force acted
    void add(const Eigen::Vector3d& newtons, double seconds);
    void clear() { m_mean.reset(); }
    /// N; none until one was added
    std::optional<double> size() const;

private:
    std::optional<Eigen::Vector3d> m_mean;
};

/// m, from rest, of the node that is nearest to a collider; 0 without nodes.
double displacementAt(const PlacedCollider& collider, const std::vector<Eigen::Vector3d>& rest,
                      const std::vector<Eigen::Vector3d>& positions);

} // namespace esm
