#include "core/model/scene_cavities.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

namespace {

/// The parts that were named so far, over one surface.
class NamedCavities {
public:
    NamedCavities(const SpringNetwork& network, const std::vector<Triangle>& surface)
        : m_network(network), m_surface(surface) {}

    /// @param entry of the scene, which names it
    Cavity& named(std::uint32_t part, const std::string& entry) {
        const auto isNamed = [&](const Cavity& cavity) { return cavity.part == part; };
        const auto known = std::find_if(m_cavities.begin(), m_cavities.end(), isNamed);
        if (known != m_cavities.end()) return *known;
        if (const std::string why = whyNoRoom(m_network); !why.empty())
            throw InvalidModel(entry + ": " + why + "; " + adviceOnRoom);
        try {
            return m_cavities.emplace_back(cavityOf(m_network.restPositions, m_surface, part));
        } catch (const InvalidModel& problem) {
            throw InvalidModel(entry + ": " + problem.what());
        }
    }
    std::vector<Cavity> take() { return std::move(m_cavities); }

private:
    const SpringNetwork& m_network;
    const std::vector<Triangle>& m_surface;
    std::vector<Cavity> m_cavities;
};

template<typename OfPart> const OfPart* entryOf(const std::vector<OfPart>& entries, std::uint32_t part) {
    const auto isMeant = [part](const OfPart& entry) { return entry.part == part; };
    const auto found = std::find_if(entries.begin(), entries.end(), isMeant);
    return found == entries.end() ? nullptr : &*found;
}

} // namespace

std::vector<std::uint32_t> fluidParts(const Scene& scene) {
    std::set<std::uint32_t> parts;
    for (const FluidFilling& filling : scene.fillings)
        parts.insert(filling.part);
    for (const PartPressure& pressure : scene.pressures)
        parts.insert(pressure.part);
    return {parts.begin(), parts.end()};
}

const FluidFilling* fluidOf(const Scene& scene, std::uint32_t part) {
    return entryOf(scene.fillings, part);
}

const PartPressure* pressureOf(const Scene& scene, std::uint32_t part) {
    return entryOf(scene.pressures, part);
}

void removeFluids(Scene& scene) {
    scene.fillings.clear();
    scene.pressures.clear();
}

std::string whyNoRoom(const SpringNetwork& network) {
    if (!network.lattice) return {};
    // Its surface has two sides, of which the inner one turns its back to what it encloses.
    if (isWall(network.lattice->filling)) return "within a wall of prisms a fluid is not computed yet";
    return "a lattice fills this organ, and leaves no room for a fluid";
}

std::vector<Cavity> cavitiesOf(const Scene& scene, const SpringNetwork& network,
                               const std::vector<Triangle>& surface) {
    NamedCavities cavities(network, surface);
    for (std::size_t i = 0; i < scene.fillings.size(); ++i)
        cavities.named(scene.fillings[i].part, sceneEntry("fillings", i)).stiffness =
            scene.fillings[i].stiffness;
    for (std::size_t i = 0; i < scene.pressures.size(); ++i) {
        Cavity& cavity = cavities.named(scene.pressures[i].part, sceneEntry("pressures", i));
        cavity.initialPressure = pressureAt(scene.pressures[i], 0);
        for (const PressurePoint& point : scene.pressures[i].path)
            cavity.largestPressure = std::max(cavity.largestPressure, std::abs(point.pressure));
    }
    return cavities.take();
}

} // namespace esm
