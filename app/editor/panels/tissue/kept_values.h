#pragma once

#include "core/project/tissue_beneath.h"

#include <QString>

namespace esm {

/// What a region keeps where it sets nothing. Kept until something beneath it changes: sliders of the region
/// move often, and all nodes have to be asked.
class KeptValues {
public:
    /// With its unit; empty where the region reaches no node.
    QString text(const Project& project, const Region& region, Parameter parameter);

private:
    /// All that lies beneath a region, and where it reaches.
    struct Place {
        std::shared_ptr<const SpringNetwork> network;
        BaseTissue base;
        std::vector<Region> regions;
        std::optional<Ellipsoid> ellipsoid;
        double rim = 0;

        bool operator==(const Place&) const = default;
    };

    Place m_place;
    std::optional<TissueBeneath> m_beneath;
};

} // namespace esm
