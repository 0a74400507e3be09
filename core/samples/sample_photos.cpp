#include "core/exchange/image_file.h"
#include "core/samples/noise.h"
#include "core/samples/samples.h"
#include "core/samples/tissue_picture.h"
#include "core/samples/vessel_tree.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

double fromMiddle(double x, double y) {
    return std::hypot(x - 0.5, y - 0.5);
}

/// Branching vessels over moist tissue, fading out at the picture's rim.
Tissue vessels() {
    Field arteries, veins;
    drawVesselTree(arteries, {{-5, 330}, -0.25, 7, 11});
    drawVesselTree(arteries, {{520, 90}, 2.7, 4.5, 12});
    drawVesselTree(arteries, {{300, 520}, -1.3, 4, 14});
    drawVesselTree(veins, {{-5, 372}, -0.2, 10, 21});
    drawVesselTree(veins, {{400, -5}, 1.9, 6, 23});
    Tissue tissue;
    tissue.height = bumps(5, 3, 46, 31);
    for (std::size_t i = 0; i < tissue.height.values.size(); ++i)
        tissue.height.values[i] += 1.0 * std::max(arteries.values[i], veins.values[i]);
    tissue.colour = [arteries, veins](double x, double y) {
        const TissueColour ground = mottled({0.72, 0.33, 0.29}, {0.9, 0.58, 0.5}, x, y, 41);
        const TissueColour withVeins = mixed(ground, {0.5, 0.22, 0.31}, 0.6 * valueAt(veins, x, y));
        return mixed(withVeins, {0.68, 0.1, 0.1}, 0.7 * valueAt(arteries, x, y));
    };
    tissue.alpha = [](double x, double y) {
        const double rim = std::min({x, y, 1 - x, 1 - y}) + 0.03 * (layeredNoise(8 * x, 8 * y, 3, 61) - 0.5);
        return smoothStep(0.01, 0.12, rim);
    };
    return tissue;
}

/// The glistening skin of an organ, in a soft round field like an endoscope's.
Tissue serosa() {
    Field capillaries;
    for (std::uint32_t i = 0; i < 14; ++i) {
        const Eigen::Vector2d start(pictureSize * gridNoise(1, static_cast<int>(i), 71),
                                    pictureSize * gridNoise(2, static_cast<int>(i), 71));
        drawVesselTree(capillaries, {start, 6.28 * gridNoise(3, static_cast<int>(i), 71), 1.3, 80 + i});
    }
    Tissue tissue;
    tissue.height = bumps(4.5, 3, 54, 91);
    tissue.gloss = 0.8;
    tissue.colour = [capillaries](double x, double y) {
        const TissueColour ground = mottled({0.76, 0.4, 0.37}, {0.93, 0.67, 0.6}, x, y, 101);
        return mixed(ground, {0.68, 0.14, 0.15}, 0.6 * valueAt(capillaries, x, y));
    };
    tissue.alpha = [](double x, double y) { return smoothStep(0.5, 0.36, fromMiddle(x, y)); };
    return tissue;
}

/// Noise is read along a circle around its own middle, so that it meets itself after a turn and the rim has
/// no jump.
/// Distance from the lesion's middle, 1 at its irregular rim.
Field lesionRadius() {
    Field radius;
    for (int row = 0; row < pictureSize; ++row) {
        for (int column = 0; column < pictureSize; ++column) {
            const double x = (column + 0.5) / pictureSize, y = (row + 0.5) / pictureSize;
            const double angle = std::atan2(y - 0.5, x - 0.5);
            const double lobes =
                layeredNoise(3 + 1.3 * std::cos(angle), 3 + 1.3 * std::sin(angle), 3, 111) - 0.5;
            radius.at(column, row) =
                fromMiddle(x, y) / (0.3 + 0.2 * lobes) + 0.25 * (layeredNoise(12 * x, 12 * y, 4, 121) - 0.5);
        }
    }
    return radius;
}

/// A pale spot with a reddened, irregular rim; all around it is transparent.
Tissue lesion() {
    const Field radius = lesionRadius();
    Tissue tissue;
    tissue.height = bumps(6, 3, 38, 131);
    for (std::size_t i = 0; i < radius.values.size(); ++i)
        tissue.height.values[i] += 10 * smoothStep(1.1, 0.3, radius.values[i]);
    tissue.gloss = 0.6;
    tissue.colour = [radius](double x, double y) {
        const double r = valueAt(radius, x, y);
        const TissueColour core = mottled({0.8, 0.63, 0.47}, {0.93, 0.82, 0.68}, x, y, 141);
        const TissueColour rim = mottled({0.55, 0.17, 0.16}, {0.7, 0.29, 0.26}, x, y, 151);
        const TissueColour inside = mixed({0.62, 0.38, 0.27}, core, smoothStep(0.02, 0.4, r));
        return mixed(inside, rim, smoothStep(0.5, 1.0, r));
    };
    tissue.alpha = [radius](double x, double y) { return smoothStep(1.4, 0.9, valueAt(radius, x, y)); };
    return tissue;
}

} // namespace

const std::vector<std::string>& samplePhotoNames() {
    static const std::vector<std::string> names{"vessels", "serosa", "lesion"};
    return names;
}

std::shared_ptr<const Photo> makeSamplePhoto(const std::string& name) {
    const auto picture = [&] {
        if (name == "vessels") return pictureOf(vessels());
        if (name == "serosa") return pictureOf(serosa());
        if (name == "lesion") return pictureOf(lesion());
        throw InvalidModel("there is no sample photo \"" + name + "\"; choose vessels, serosa or lesion");
    };
    auto photo = std::make_shared<Photo>();
    photo->fileName = name + ".png";
    photo->image = picture();
    photo->encoded = encodePng(photo->image);
    return photo;
}

} // namespace esm
