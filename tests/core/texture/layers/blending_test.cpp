#include "core/texture/layers/blending.h"

#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <random>

using namespace esm;
using namespace esm::test;

namespace {

using Rgb = std::array<double, 3>; ///< 0 to 1

double lum(const Rgb& c) {
    return 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
}

/// As chapter 10 of the specification words it: B(Cb, Cs), channel by channel.
double separable(Blending blending, double cb, double cs) {
    const auto multiply = [](double a, double b) { return a * b; };
    const auto screen = [](double a, double b) { return 1 - (1 - a) * (1 - b); };
    if (blending == Blending::Multiply) return multiply(cb, cs);
    if (blending == Blending::Screen) return screen(cb, cs);
    if (blending == Blending::Overlay) return cb <= 0.5 ? multiply(cs, 2 * cb) : screen(cs, 2 * cb - 1);
    return cs;
}

/// SetLum(Cs, Lum(Cb)) with its ClipColor.
Rgb colourBlend(const Rgb& cb, const Rgb& cs) {
    const double d = lum(cb) - lum(cs);
    Rgb c{cs[0] + d, cs[1] + d, cs[2] + d};
    const double l = lum(c), n = std::min({c[0], c[1], c[2]}), x = std::max({c[0], c[1], c[2]});
    for (double& channel : c) {
        if (n < 0) channel = l + (channel - l) * l / (l - n);
        if (x > 1) channel = l + (channel - l) * (1 - l) / (x - l);
    }
    return c;
}

Rgb expected(Blending blending, const Rgb& cb, const Rgb& cs) {
    if (blending == Blending::Colour) return colourBlend(cb, cs);
    return {separable(blending, cb[0], cs[0]), separable(blending, cb[1], cs[1]),
            separable(blending, cb[2], cs[2])};
}

Eigen::Array3f toArray(const Rgb& c) {
    return {float(c[0]), float(c[1]), float(c[2])};
}

/// Layers of one colour each, that cover a small square.
struct Laid {
    Blending blending;
    Colour colour;
    double opacity;
};

TextureLayer layerOf(const Laid& laid) {
    TextureLayer layer = layerFromAbove(plainPhoto(laid.colour), 0.3);
    layer.blending = laid.blending;
    layer.opacity = laid.opacity;
    return layer;
}

/// From the lowest up, as the specification composes: Cr = (1 − αs)·Cb + αs·B(Cb, Cs) over what is opaque.
Colour composedOf(const std::vector<Laid>& layers) {
    Rgb shown{baseColour[0] / 255.0, baseColour[1] / 255.0, baseColour[2] / 255.0};
    for (const auto& [blending, colour, opacity] : layers) {
        const Rgb mixed =
            expected(blending, shown, {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0});
        for (std::size_t i = 0; i < 3; ++i)
            shown[i] += opacity * (mixed[i] - shown[i]);
    }
    const auto byte = [](double value) { return static_cast<std::uint8_t>(std::lround(255 * value)); };
    return {byte(shown[0]), byte(shown[1]), byte(shown[2]), 255};
}

} // namespace

TEST(Blending, IsThatOfTheSpecification) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> byte(0, 255);
    const auto any = [&] { return Rgb{byte(random) / 255.0, byte(random) / 255.0, byte(random) / 255.0}; };
    for (int i = 0; i < 2000; ++i) {
        const Rgb beneath = any(), own = any();
        for (const Blending blending : blendings) {
            const Rgb wanted = expected(blending, beneath, own);
            const Eigen::Array3f found = blended(blending, toArray(beneath), toArray(own));
            EXPECT_LT((found - toArray(wanted)).abs().maxCoeff(), 1e-5F) << wordOf(blending);
        }
    }
}

TEST(Blending, LeavesWhatItSaysItLeaves) {
    const Eigen::Array3f tissue(0.7F, 0.36F, 0.33F),
        white = Eigen::Array3f::Ones(), black = Eigen::Array3f::Zero(), grey = Eigen::Array3f::Constant(0.5F),
        blue(0.1F, 0.2F, 0.9F);
    EXPECT_TRUE(blended(Blending::Screen, tissue, black).isApprox(tissue));
    EXPECT_TRUE(blended(Blending::Screen, tissue, white).isApprox(white));
    EXPECT_TRUE(blended(Blending::Overlay, tissue, grey).isApprox(tissue));
    EXPECT_GT(blended(Blending::Overlay, tissue, white).x(), tissue.x());
    EXPECT_LT(blended(Blending::Overlay, tissue, black).z(), tissue.z());
    const auto brightness = [](const Eigen::Array3f& c) { return lum({c.x(), c.y(), c.z()}); };
    EXPECT_NEAR(brightness(blended(Blending::Colour, tissue, blue)), brightness(tissue), 1e-5);
    const Eigen::Array3f greyed = blended(Blending::Colour, tissue, white);
    EXPECT_NEAR(greyed.maxCoeff() - greyed.minCoeff(), 0, 1e-5) << "a colour without hue leaves grey";
}

TEST(Blending, IsComposedInTheOrderOfTheLayers) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    constexpr Colour violet{140, 60, 190, 255}, pale{220, 200, 160, 255}, dark{40, 70, 30, 255};
    for (const Blending lower : blendings)
        for (const Blending middle : blendings)
            for (const Blending upper : {Blending::Multiply, Blending::Screen, Blending::Overlay}) {
                if (lower == Blending::MultiBand || middle == Blending::MultiBand) continue;
                const std::vector<Laid> laid{{lower, violet, 0.5},
                                             {middle, pale, 0.8},
                                             {upper, dark, 1},
                                             {Blending::Normal, violet, 0.25}};
                std::vector<TextureLayer> layers;
                for (const Laid& one : laid)
                    layers.push_back(layerOf(one));
                const Colour wanted = composedOf(laid);
                onPages(mesh, atlas, layers, [&](const Eigen::Vector3d&, const Colour& colour, std::size_t) {
                    ASSERT_TRUE(isNear(colour, wanted, 1))
                        << wordOf(lower) << ' ' << wordOf(middle) << ' ' << wordOf(upper);
                });
            }
}

TEST(Blending, KeepsSixteenBits) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {64, 1, 2});
    const Laid laid{Blending::Overlay, {90, 91, 92, 255}, 0.37};
    CompositionCache cache;
    const auto pages = compositeDeep(mesh, atlas, {layerOf(laid)}, baseColour, cache);
    const auto& patch = atlas.corners[0];
    const Eigen::Vector2d middle = (patch[0] + patch[1] + patch[2]) / 3;
    const std::uint16_t* pixel = pages[0].at(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
    const double beneath = baseColour[0] / 255.0;
    const double wanted = beneath + 0.37 * (separable(Blending::Overlay, beneath, 90 / 255.0) - beneath);
    EXPECT_NEAR(pixel[0], 65535 * wanted, 2);
}

TEST(Blending, MultipliesValuesFromZeroToOne) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    const TextureLayer layer = layerOf({Blending::Multiply, {128, 255, 0, 255}, 0.5});
    onPages(mesh, atlas, {layer}, [](const Eigen::Vector3d&, const Colour& colour, std::size_t) {
        ASSERT_TRUE(isNear(colour, {150, 101, 25, 255}, 1)) << int(colour[0]); // 200 · (½ + ½ · 128 / 255)
    });
}

TEST(Blending, IsFoundByItsName) {
    for (const Blending blending : blendings)
        EXPECT_EQ(fromWord<Blending>(wordOf(blending)), blending);
    EXPECT_EQ(fromWord<Blending>("lighten"), std::nullopt);
}

TEST(Blending, OfAnyGreyOverBlackAndWhiteIsThatBlackAndWhite) {
    for (int value = 0; value < 256; ++value) {
        const Eigen::Array3f grey = Eigen::Array3f::Constant(static_cast<float>(value) / 255);
        for (const float beneath : {0.0F, 1.0F}) {
            const Eigen::Array3f made = blended(Blending::Colour, Eigen::Array3f::Constant(beneath), grey);
            ASSERT_TRUE(made.allFinite()) << value;
            EXPECT_LT((made - beneath).abs().maxCoeff(), 1e-5F) << value;
        }
    }
}
