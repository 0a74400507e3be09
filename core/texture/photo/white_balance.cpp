#include "core/texture/photo/white_balance.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace esm {

namespace {

using LampLight = std::array<double, 3>; ///< red, green, blue

constexpr double displayGamma = 2.2; ///< what is stored to this power is light; sRGB is near enough to it
constexpr int burntOut = 246;        ///< brightest channel from which on some of the light is cut off

const std::array<double, 256>& lightOfLevels() {
    static const std::array<double, 256> light = [] {
        std::array<double, 256> values{};
        for (std::size_t level = 0; level < values.size(); ++level)
            values[level] = std::pow(static_cast<double>(level) / 255, displayGamma);
        return values;
    }();
    return light;
}

/// The gains of stored levels by which a light becomes grey, green kept. A camera's gains multiply light; of
/// what is stored, its power.
ColourGains gainsFor(const LampLight& light) {
    ColourGains gains{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        gains[channel] = std::clamp(std::pow(light[1] / light[channel], 1 / displayGamma), 0.5, 2.0);
    return gains;
}

int brightestOf(const std::uint8_t* pixel) {
    return std::max({pixel[0], pixel[1], pixel[2]});
}

double medianOf(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Ratios of red and blue to green, one per pixel.
struct LampRatios {
    std::vector<double> red, blue;

    void add(double r, double g, double b) {
        red.push_back(r / g);
        blue.push_back(b / g);
    }
    LampLight light() { return {medianOf(red), 1, medianOf(blue)}; }
    /// Half of the ratios lie so near to the middle one, in relation to it.
    static double spread(std::vector<double> values) {
        const double middle = medianOf(values);
        for (double& value : values)
            value = std::abs(value - middle) / middle;
        return medianOf(values);
    }
    double spread() const { return std::max(spread(red), spread(blue)); }
};

/// What each mirror image adds to the tissue beneath it, by the tissue that it is filled with. Light adds up:
/// the difference is the lamp's own colour wherever no channel is cut off or, near to that, pressed together
/// as cameras do, which is in faint flecks and at the rims of strong ones.
std::vector<LampRatios> lightOfFlecks(const Image& photo) {
    constexpr double faintest = 0.06; // of full light; less is the filling's own error
    constexpr int pressed = 228;      // brightest channel
    const auto& light = lightOfLevels();
    Image filled = photo;
    PixelMask mask = highlightMask(photo, usualSensitivity);
    fillHighlights(filled, mask);
    cv::Mat labels;
    const int count = cv::connectedComponents(cv::Mat(photo.height, photo.width, CV_8U, mask.data()), labels);
    std::vector<LampRatios> flecks(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const std::uint8_t *with = &photo.pixels[4 * i], *without = &filled.pixels[4 * i];
        if (mask[i] == 0 || brightestOf(with) >= pressed) continue;
        const LampLight added{light[with[0]] - light[without[0]], light[with[1]] - light[without[1]],
                              light[with[2]] - light[without[2]]};
        if (*std::min_element(added.begin(), added.end()) > faintest)
            flecks[static_cast<std::size_t>(labels.ptr<int>()[i])].add(added[0], added[1], added[2]);
    }
    return flecks;
}

/// A fleck of many pixels counts more, but not as many times: its errors are of one kind.
LampRatios lampsOf(std::vector<LampRatios> flecks, std::size_t& counted) {
    constexpr std::size_t fewestPixels = 5;
    LampRatios lamps;
    counted = 0;
    for (LampRatios& fleck : flecks) {
        if (fleck.red.size() < fewestPixels) continue;
        ++counted;
        const LampLight lamp = fleck.light();
        for (auto votes = std::lround(std::sqrt(fleck.red.size())); votes > 0; --votes)
            lamps.add(lamp[0], lamp[1], lamp[2]);
    }
    return lamps;
}

/// Lamps go from warm, whose blue lacks twice what their red has too much, to bluish and greenish. None is
/// merely red: where gains would take red alone, they would take it from the tissue.
bool isOfALamp(const ColourGains& gains) {
    constexpr double leastOfRed = 0.75, mostOfRed = 1.4, leastOfBlue = 0.65, mostOfBlue = 1.5;
    constexpr double reddest = 0.94;
    if (gains[0] < leastOfRed || gains[0] > mostOfRed) return false;
    if (gains[2] < leastOfBlue || gains[2] > mostOfBlue) return false;
    return gains[0] * std::max(1.0, gains[2]) > reddest;
}

/// Pixels that are nearly grey, as drapes and metal are, and pale mucosa under some lamps too.
LampRatios lightOfGrey(const Image& photo, std::size_t& seen) {
    constexpr int tooDark = 24, strongestColour = 30; // percent of the brightest channel
    const auto& light = lightOfLevels();
    LampRatios ratios;
    for (std::size_t i = 0; i < photo.pixels.size(); i += 4) {
        const std::uint8_t* pixel = &photo.pixels[i];
        if (pixel[3] == 0) continue;
        ++seen;
        const auto [least, most] = std::minmax({int{pixel[0]}, int{pixel[1]}, int{pixel[2]}});
        if (least >= tooDark && most < burntOut && 100 * (most - least) <= strongestColour * most)
            ratios.add(light[pixel[0]], light[pixel[1]], light[pixel[2]]);
    }
    return ratios;
}

/// The mean light of tissue, with the weight of what counts.
LampLight tissueOf(const Image& photo, bool& isEnough) {
    constexpr int tooDark = 40;
    const auto& light = lightOfLevels();
    const PixelMask shines = highlightMask(photo, usualSensitivity);
    LampLight sum{};
    std::size_t seen = 0, counted = 0;
    for (std::size_t i = 0; i < shines.size(); ++i) {
        const std::uint8_t* pixel = &photo.pixels[4 * i];
        if (pixel[3] == 0) continue;
        ++seen;
        if (shines[i] != 0 || brightestOf(pixel) >= burntOut || brightestOf(pixel) < tooDark) continue;
        ++counted;
        for (std::size_t channel = 0; channel < 3; ++channel)
            sum[channel] += light[pixel[channel]];
    }
    isEnough = 100 * counted >= seen && sum[0] > 0 && sum[1] > 0 && sum[2] > 0;
    return sum;
}

} // namespace

/// That the world is grey on average does not hold in the body: gains for that would turn tissue grey. By the
/// dichromatic reflection model (Shafer 1985, Using color to separate reflection components) a mirror image
/// adds the lamp's own colour to the tissue's, so what flecks add is white. Each fleck gives one lamp, and
/// those of one photo must agree (Lee 1986, Method for computing the scene-illuminant chromaticity from
/// specular highlights: the lines of several surfaces meet in the lamp), as where a camera sharpens or blurs
/// colours what is added takes the tissue's tint. Where there are hardly any, grey things tell the lamp, if
/// all that is nearly grey has one colour: a drape or a shaft has, and pale mucosa varies with its blood.
std::optional<ColourGains> findWhiteBalance(const Image& photo) {
    constexpr std::size_t fewestFlecks = 3;
    constexpr double widestOfFlecks = 0.2, widestOfGrey = 0.05;
    const auto sure = [](LampRatios& ratios) -> std::optional<ColourGains> {
        const ColourGains gains = gainsFor(ratios.light());
        return isOfALamp(gains) ? std::optional(gains) : std::nullopt;
    };
    if (photo.empty()) return std::nullopt;
    std::size_t flecks = 0;
    LampRatios lamps = lampsOf(lightOfFlecks(photo), flecks);
    if (flecks >= fewestFlecks) return lamps.spread() < widestOfFlecks ? sure(lamps) : std::nullopt;
    std::size_t seen = 0;
    LampRatios grey = lightOfGrey(photo, seen);
    if (grey.red.empty() || 100 * grey.red.size() < seen || grey.spread() > widestOfGrey) return std::nullopt;
    return sure(grey);
}

std::optional<ColourGains> whiteBalanceOfSpot(const Image& photo, const Eigen::Vector2d& place,
                                              double radius) {
    constexpr int tooDark = 24;
    const auto& light = lightOfLevels();
    LampLight sum{};
    const auto first = [&](double at) { return std::max(0, static_cast<int>(std::floor(at - radius))); };
    for (int y = first(place.y()); y < photo.height && y + 0.5 <= place.y() + radius; ++y)
        for (int x = first(place.x()); x < photo.width && x + 0.5 <= place.x() + radius; ++x) {
            const std::uint8_t* pixel = photo.at(x, y);
            const int brightest = brightestOf(pixel);
            if (pixel[3] == 0 || brightest < tooDark || brightest >= burntOut) continue;
            if ((Eigen::Vector2d(x + 0.5, y + 0.5) - place).norm() > radius) continue;
            for (std::size_t channel = 0; channel < 3; ++channel)
                sum[channel] += light[pixel[channel]];
        }
    if (!(std::min({sum[0], sum[1], sum[2]}) > 0)) return std::nullopt;
    return gainsFor(sum);
}

std::optional<ColourGains> whiteBalanceLike(const Image& photo, const Image& balanced) {
    bool isEnough = false, isEnoughBalanced = false;
    const LampLight mine = tissueOf(photo, isEnough), other = tissueOf(balanced, isEnoughBalanced);
    if (!isEnough || !isEnoughBalanced) return std::nullopt;
    return gainsFor({mine[0] / other[0], mine[1] / other[1], mine[2] / other[2]});
}

} // namespace esm
