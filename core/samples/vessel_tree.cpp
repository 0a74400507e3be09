#include "core/samples/vessel_tree.h"

#include "core/samples/noise.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// A walk whose direction drifts, as its bend keeps four fifths of itself from step to step, while the radius
/// shrinks. Where it branches, the side branch turns off sharply and the stem gives way a little to the other
/// side, as vessels do; the stem loses some of its cross-section to the branch. Branches are grown at once
/// and end below half a pixel, so that the walk ends.
class VesselTree {
public:
    VesselTree(Field& cover, std::uint32_t seed) : m_cover(cover), m_seed(seed) {}

    void grow(Eigen::Vector2d place, double direction, double radius) {
        double bend = 0;
        while (radius > 0.55 && isNear(place)) {
            bend = 0.8 * bend + 0.09 * (random() - 0.5);
            direction += bend;
            const double step = std::max(1.0, radius / 2);
            place += step * Eigen::Vector2d(std::cos(direction), std::sin(direction));
            stamp(place, radius);
            radius *= 1 - 0.0022 * step;
            if (random() < 0.016 * step) {
                const double side = random() < 0.5 ? -1 : 1, share = 0.45 + 0.35 * random();
                grow(place, direction + side * (0.4 + 0.5 * random()), radius * share);
                direction -= side * 0.25 * share;
                radius *= std::sqrt(1 - 0.6 * share * share);
            }
        }
    }

private:
    double random() { return gridNoise(static_cast<int>(++m_drawn), 0, m_seed); }

    static bool isNear(const Eigen::Vector2d& place) {
        return place.minCoeff() > -20 && place.maxCoeff() < pictureSize + 20;
    }

    void stamp(const Eigen::Vector2d& place, double radius) {
        const double reach = radius + 1;
        const Eigen::Vector2i low = (place.array() - reach).floor().cast<int>().max(0);
        const Eigen::Vector2i high = (place.array() + reach).ceil().cast<int>().min(pictureSize - 1);
        for (int y = low.y(); y <= high.y(); ++y) {
            for (int x = low.x(); x <= high.x(); ++x) {
                const double distance = (Eigen::Vector2d(x, y) - place).norm();
                const double cover =
                    std::clamp(radius + 0.5 - distance, 0.0, 1.0) * std::min(1.0, 0.2 + radius / 3);
                m_cover.at(x, y) = std::max(m_cover.at(x, y), cover);
            }
        }
    }

    Field& m_cover;
    std::uint32_t m_seed;
    std::uint32_t m_drawn = 0;
};

} // namespace

void drawVesselTree(Field& cover, const VesselRoot& root) {
    VesselTree(cover, root.seed).grow(root.place, root.direction, root.radius);
}

} // namespace esm
