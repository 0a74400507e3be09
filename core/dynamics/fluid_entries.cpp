#include "core/dynamics/fluid_entries.h"

namespace esm {

namespace {

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& d) {
    Eigen::Matrix3d matrix;
    matrix << 0, -d.z(), d.y(), d.z(), 0, -d.x(), -d.y(), d.x(), 0;
    return matrix;
}

} // namespace

// Of a ring's side (a, b) the gradient at x has (a − x)×(b − x)/6. Over a closed ring that is Σ a×b/6, of
// which the parts by a and b are −[b]×/6 and [a]×/6; places are taken from x, since the ring's sum does not
// depend on where they are taken from.
void addTurning(const SpringSystem::Filled& cavity, double pressure, const Vectors& places,
                BlockEntries& entries) {
    const CavityWall& wall = *cavity.wall;
    for (std::uint32_t place = 0; place < wall.size(); ++place)
        for (std::uint32_t i = wall.starts[place]; i < wall.starts[place + 1]; ++i) {
            const auto [from, to] = wall.sides[i];
            const Eigen::Vector3d a = places[from] - places.front(), b = places[to] - places.front();
            entries.add(wall.nodes[place], wall.nodes[from], pressure / 6 * crossMatrix(b));
            entries.add(wall.nodes[place], wall.nodes[to], -pressure / 6 * crossMatrix(a));
        }
}

} // namespace esm
