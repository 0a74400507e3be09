#include "core/dynamics/cavity_wall.h"

#include "core/dynamics/kernel/thread_team.h"

#include <algorithm>

namespace esm {

namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

/// Places whose sums are added up before those of others: so many that threads have enough to do, and always
/// the same, so that rounding is.
constexpr std::size_t placesPerBlock = 512;

std::vector<std::uint32_t> nodesOf(const std::vector<Triangle>& triangles) {
    std::vector<std::uint32_t> nodes;
    nodes.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        nodes.insert(nodes.end(), triangle.begin(), triangle.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

} // namespace

CavityWall::CavityWall(const std::vector<Triangle>& triangles)
    : nodes(nodesOf(triangles)), starts(nodes.size() + 1, 0), sides(3 * triangles.size()) {
    const auto placeOf = [this](std::uint32_t node) {
        return static_cast<std::uint32_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
    };
    std::vector<Triangle> own;
    own.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles)
        own.push_back({placeOf(a), placeOf(b), placeOf(c)});
    for (const Triangle& triangle : own)
        for (const std::uint32_t place : triangle)
            ++starts[place + 1];
    for (std::size_t place = 0; place < nodes.size(); ++place)
        starts[place + 1] += starts[place];
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (const auto& [a, b, c] : own) {
        sides[next[a]++] = {b, c};
        sides[next[b]++] = {c, a};
        sides[next[c]++] = {a, b};
    }
}

Places placesOf(const CavityWall& wall, const Places& positions) {
    Places places;
    places.reserve(wall.size());
    for (const std::uint32_t node : wall.nodes)
        places.push_back(positions[node]);
    return places;
}

Vector3d volumeGradientAt(const CavityWall& wall, const Places& places, std::uint32_t place) {
    const Vector3d& here = places[place];
    Vector3d sum = Vector3d::Zero();
    for (std::uint32_t i = wall.starts[place]; i < wall.starts[place + 1]; ++i) {
        const auto [from, to] = wall.sides[i];
        sum += (places[from] - here).cross(places[to] - here);
    }
    return sum / 6;
}

// The volume is of the third degree in its places, so that by Euler's theorem it is a third of Σ x·∂V/∂x: one
// pass over the nodes gives both. Each ring is read and only its own node written, hence threads do not meet;
// and since shifting a closed surface changes nothing, places are taken from one of them, lest far from the
// origin the volume be lost in the difference of large numbers.
CavityVolume volumeOf(const CavityWall& wall, const Places& places, ThreadTeam* team) {
    CavityVolume result{0, Places(wall.size())};
    const std::size_t blocks = (wall.size() + placesPerBlock - 1) / placesPerBlock;
    std::vector<double> sums(blocks, 0);
    const auto compute = [&](std::size_t block) {
        const std::size_t end = std::min(wall.size(), (block + 1) * placesPerBlock);
        for (std::size_t place = block * placesPerBlock; place < end; ++place) {
            result.gradient[place] = volumeGradientAt(wall, places, static_cast<std::uint32_t>(place));
            sums[block] += (places[place] - places.front()).dot(result.gradient[place]);
        }
    };
    if (team && blocks > 1)
        team->run(blocks, compute);
    else
        for (std::size_t block = 0; block < blocks; ++block)
            compute(block);
    for (const double sum : sums)
        result.volume += sum / 3;
    return result;
}

Places gradientChange(const CavityWall& wall, const Places& places, const Places& displacements) {
    Places change(wall.size(), Vector3d::Zero());
    for (std::size_t place = 0; place < wall.size(); ++place) {
        const Vector3d &here = places[place], &moved = displacements[place];
        for (std::uint32_t i = wall.starts[place]; i < wall.starts[place + 1]; ++i) {
            const auto [from, to] = wall.sides[i];
            change[place] += ((displacements[from] - moved).cross(places[to] - here) +
                              (places[from] - here).cross(displacements[to] - moved)) /
                             6;
        }
    }
    return change;
}

} // namespace esm
