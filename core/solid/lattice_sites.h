#pragma once

#include "core/solid/background_lattice.h"

#include <functional>

namespace esm {

/// Whether sites of a lattice lie within a body. Sites on a side of its box are looked at closely: a block is
/// bounded by such sites, and would lose its corners were they taken for outside.
class SitesOfBody {
public:
    /// @param body and `query` outlive this
    SitesOfBody(const ClosedBody& body, const BodyQuery& query);

    bool holds(const Eigen::Vector3d& place) const;

private:
    const BodyQuery& m_query;
    Eigen::AlignedBox3d m_outer, m_inner;
};

/// @throws InvalidModel where a box around a body has so many sites that no memory takes them
/// @param spacing between nearest neighbours, m
void checkSiteCount(double sites, double spacing);

/// Of a whole grid two thirds lie outside an organ. Only what has a corner inside is kept, and its points are
/// numbered anew, in the order of the cells: neighbours in space lie near each other in memory.
///
/// Takes tetrahedra over into a lattice whose points are numbered in the order of their first use.
class SiteTaker {
public:
    /// @param isInside per site of the grid
    SiteTaker(std::function<Eigen::Vector3d(std::size_t site)> placeOf, const std::vector<char>& isInside,
              BackgroundLattice& lattice)
        : m_placeOf(std::move(placeOf)), m_isInside(isInside), m_lattice(lattice),
          m_numbers(isInside.size(), noIndex) {}

    /// Of sites, in positive order. @return whether it was taken; its shares are then to be added
    bool take(const Tetrahedron& sites, double volume);
    /// The number of a site that was taken; noIndex for others.
    std::uint32_t numberOf(std::uint32_t site) const { return m_numbers[site]; }

private:
    std::uint32_t taken(std::uint32_t site);

    std::function<Eigen::Vector3d(std::size_t)> m_placeOf;
    const std::vector<char>& m_isInside;
    BackgroundLattice& m_lattice;
    std::vector<std::uint32_t> m_numbers;
};

} // namespace esm
