#include "tests/support/colour_difference.h"

#include <cmath>

namespace esm {

namespace {

double square(double value) {
    return value * value;
}

double inRadians(double degrees) {
    return degrees * M_PI / 180;
}

double linear(std::uint8_t stored) {
    const double value = stored / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// Chroma and hue, degrees, with a* stretched as the formula asks for near grey.
struct ChromaHue {
    double chroma, hue;
};

ChromaHue chromaHue(const LabColour& lab, double stretch) {
    const double a = (1 + stretch) * lab[1];
    const double hue = a == 0 && lab[2] == 0 ? 0 : std::atan2(lab[2], a) * 180 / M_PI;
    return {std::hypot(a, lab[2]), hue < 0 ? hue + 360 : hue};
}

/// √(C⁷ / (C⁷ + 25⁷))
double greyShare(double chroma) {
    const double power = std::pow(chroma, 7);
    return std::sqrt(power / (power + std::pow(25.0, 7)));
}

/// The shorter way round.
double hueStep(const ChromaHue& first, const ChromaHue& second) {
    if (first.chroma * second.chroma == 0) return 0;
    return std::remainder(second.hue - first.hue, 360.0);
}

double meanHue(const ChromaHue& first, const ChromaHue& second) {
    if (first.chroma * second.chroma == 0) return first.hue + second.hue;
    const double mean = first.hue + hueStep(first, second) / 2;
    return mean < 0 ? mean + 360 : mean >= 360 ? mean - 360 : mean;
}

} // namespace

LabColour labOf(const std::uint8_t* srgb) {
    const double r = linear(srgb[0]), g = linear(srgb[1]), b = linear(srgb[2]);
    const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16 / 116.0; };
    const double x = root((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = root(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = root((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double colourDifference(const LabColour& first, const LabColour& second) {
    const double plain = (std::hypot(first[1], first[2]) + std::hypot(second[1], second[2])) / 2;
    const double stretch = 0.5 * (1 - greyShare(plain));
    const ChromaHue one = chromaHue(first, stretch), other = chromaHue(second, stretch);
    const double chroma = (one.chroma + other.chroma) / 2, hue = meanHue(one, other);
    const double lightness = square((first[0] + second[0]) / 2 - 50);
    const double byHue = 1 - 0.17 * std::cos(inRadians(hue - 30)) + 0.24 * std::cos(inRadians(2 * hue)) +
                         0.32 * std::cos(inRadians(3 * hue + 6)) - 0.20 * std::cos(inRadians(4 * hue - 63));
    const double turn =
        -std::sin(inRadians(60 * std::exp(-square((hue - 275) / 25)))) * 2 * greyShare(chroma);
    const double inLightness = (second[0] - first[0]) / (1 + 0.015 * lightness / std::sqrt(20 + lightness));
    const double inChroma = (other.chroma - one.chroma) / (1 + 0.045 * chroma);
    const double inHue = 2 * std::sqrt(one.chroma * other.chroma) *
                         std::sin(inRadians(hueStep(one, other) / 2)) / (1 + 0.015 * chroma * byHue);
    return std::sqrt(square(inLightness) + square(inChroma) + square(inHue) + turn * inChroma * inHue);
}

} // namespace esm
