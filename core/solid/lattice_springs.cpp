#include "core/solid/lattice_springs.h"

#include "core/geometry/sorted_by_vertex.h"

#include <algorithm>

namespace esm {

namespace {

using Eigen::Vector3d;

class SpringGatherer {
public:
    SpringGatherer(const BackgroundLattice& background, const StuffedLattice& lattice)
        : m_background(background), m_lattice(lattice), m_nodes(background.points.size(), noIndex) {
        for (std::uint32_t node = 0; node < lattice.points.size(); ++node)
            if (lattice.points[node] != noIndex) m_nodes[lattice.points[node]] = node;
    }

    void gather(std::size_t number) {
        const std::uint32_t origin = m_lattice.origins[number];
        const auto first = m_background.shares.begin() + m_background.shareStarts[origin],
                   last = m_background.shares.begin() + m_background.shareStarts[origin + 1];
        const Tetrahedron& nodes = m_lattice.tetrahedra[number];
        const bool isSkin = m_background.hasSkin && std::any_of(nodes.begin(), nodes.end(), [&](auto node) {
                                return m_lattice.isOnSurface[node];
                            });
        const bool isLattice =
            m_lattice.isWhole[number] && !isSkin && std::all_of(first, last, [&](const auto& share) {
                return isNode(share.first) && isNode(share.second);
            });
        const double volume = volumeOf(nodes, m_lattice.nodes);
        if (isLattice) {
            const double ratio = volume / m_background.volumes[origin];
            for (auto share = first; share != last; ++share)
                addShare(*share, ratio);
        } else {
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j)
                    add(nodes[i], nodes[j],
                        m_background.cutStiffness * volume / squaredLength(nodes[i], nodes[j]), 0);
        }
    }

    // Parts of one spring come in the order of their tetrahedra whatever the threads did before, so that sums
    // round the same way each time.
    std::vector<FittedSpring> gathered() && {
        const auto isLess = [](const FittedSpring& one, const FittedSpring& other) {
            return one.spring.second < other.spring.second;
        };
        std::vector<FittedSpring> sorted = sortedByVertex(
            m_parts, [](const FittedSpring& part) { return part.spring.first; }, isLess);
        std::size_t count = 0;
        for (const FittedSpring& part : sorted) {
            const bool isSame = count > 0 && sorted[count - 1].spring.first == part.spring.first &&
                                sorted[count - 1].spring.second == part.spring.second;
            if (!isSame) {
                sorted[count++] = part;
                continue;
            }
            sorted[count - 1].spring.constant += part.spring.constant;
            sorted[count - 1].latticeLength = std::max(sorted[count - 1].latticeLength, part.latticeLength);
        }
        sorted.resize(count);
        return sorted;
    }

private:
    bool isNode(std::uint32_t point) const { return point != noIndex && m_nodes[point] != noIndex; }
    double squaredLength(std::uint32_t one, std::uint32_t other) const {
        return (m_lattice.nodes[one] - m_lattice.nodes[other]).squaredNorm();
    }
    void addShare(const LatticeShare& share, double ratio) {
        const std::uint32_t first = m_nodes[share.first], second = m_nodes[share.second];
        const double stretch = share.length * share.length / squaredLength(first, second);
        add(first, second, share.constant * ratio * stretch, share.length);
    }
    void add(std::uint32_t one, std::uint32_t other, double constant, double latticeLength) {
        const auto [first, second] = std::minmax(one, other);
        m_parts.push_back({{first, second, constant}, latticeLength});
    }

    const BackgroundLattice& m_background;
    const StuffedLattice& m_lattice;
    std::vector<std::uint32_t> m_nodes; ///< per point of the background
    std::vector<FittedSpring> m_parts;
};

} // namespace

// A spring is the sum of what the tetrahedra around it give. One that is whole gives the lattice's own
// shares, times its volume over that in the lattice, by the square of how much shorter the spring has become:
// at the same strain the energy then goes with the volume, as it does in a solid. What was cut has no springs
// of the lattice; its own edges become springs, of the constants that Van Gelder (1998) gives them. Where a
// spring of the lattice would end beyond the surface, all tetrahedra that it runs through do the same.
std::vector<FittedSpring> fittedSprings(const BackgroundLattice& background, const StuffedLattice& lattice) {
    SpringGatherer gatherer(background, lattice);
    for (std::size_t i = 0; i < lattice.tetrahedra.size(); ++i)
        gatherer.gather(i);
    return std::move(gatherer).gathered();
}

} // namespace esm
