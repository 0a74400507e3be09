#include "tests/benchmarks/layer_composition.h"

#include "core/texture/layers/composite.h"
#include "tests/support/test_surfaces.h"

#include <cmath>

namespace benchmarks {

namespace {

using namespace esm;

constexpr int compositions = 3, layerCount = 8, pageSize = 4096;
constexpr std::array<std::uint8_t, 3> base{186, 92, 84};

/// Noise, in which no neighbouring pixels are the same.
std::shared_ptr<const Photo> noisePhoto() {
    auto photo = std::make_shared<Photo>();
    photo->image.width = 1920;
    photo->image.height = 1080;
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < 4 * 1920 * 1080; ++i) {
        state = state * 1664525U + 1013904223U;
        photo->image.pixels.push_back(i % 4 == 3 ? 255 : static_cast<std::uint8_t>(state >> 24U));
    }
    return photo;
}

/// From all around, each onto about a third of the organ.
std::vector<TextureLayer> layersAround() {
    std::vector<TextureLayer> layers;
    for (int i = 0; i < layerCount; ++i) {
        TextureLayer layer;
        layer.photo = noisePhoto();
        const Eigen::AngleAxisd turn(2 * M_PI * i / layerCount, Eigen::Vector3d::UnitY());
        layer.projector.pose = turn * Eigen::Translation3d(0, 0, 0.3);
        layer.projector.width = 0.16;
        layer.projector.height = 0.09;
        layers.push_back(layer);
    }
    return layers;
}

struct Work {
    TriangleMesh mesh = lumpySurface(100, 100);
    Atlas atlas = packAtlas(mesh, {pageSize, 1, 2, AtlasLayout::UnfoldedGroups});
    std::vector<TextureLayer> layers = layersAround(), moved = layers;
    Composition before;
    CompositionCache cache;

    Work() {
        moved[3].projector.pose.translation().y() += 0.01;
        before = {layers, base,
                  std::make_shared<const std::vector<Image>>(composite(mesh, atlas, layers, base, cache))};
    }
};

/// Reads as many photos per texel as the layers do on average, at the next pixel, by one thread.
void plainLoop(const std::vector<TextureLayer>& layers, Image& page) {
    constexpr std::size_t perTexel = layerCount / 3 + 1;
    for (std::size_t i = 0; i < page.pixels.size(); i += 4) {
        std::array<float, 3> colour{186, 92, 84};
        for (std::size_t layer = 0; layer < perTexel; ++layer) {
            const Image& photo = layers[layer].photo->image;
            const std::uint8_t* pixel = &photo.pixels[i % photo.pixels.size()];
            for (std::size_t channel = 0; channel < 3; ++channel)
                colour[channel] += 0.5F * (static_cast<float>(pixel[channel]) - colour[channel]);
        }
        for (std::size_t channel = 0; channel < 3; ++channel)
            page.pixels[i + channel] = static_cast<std::uint8_t>(colour[channel]);
    }
}

} // namespace

std::vector<Ratio> registerLayerComposition() {
    registerWork("composing 8 layers", compositions, [] {
        const auto work = std::make_shared<Work>();
        return [work] {
            benchmark::DoNotOptimize(composite(work->mesh, work->atlas, work->layers, base, work->cache));
        };
    });
    registerWork("composing 1 of 8 layers anew", compositions, [] {
        const auto work = std::make_shared<Work>();
        return [work] {
            benchmark::DoNotOptimize(
                recomposite(work->mesh, work->atlas, work->before, work->moved, base, work->cache));
        };
    });
    registerWork("plain loop over texels", compositions, [] {
        const auto layers = std::make_shared<const std::vector<TextureLayer>>(layersAround());
        const auto page = std::make_shared<Image>(
            Image{pageSize, pageSize, std::vector<std::uint8_t>(4UL * pageSize * pageSize)});
        return [layers, page] {
            plainLoop(*layers, *page);
            benchmark::ClobberMemory();
        };
    });
    return {
        {"8 layers composed to a plain loop", "composing 8 layers", "plain loop over texels", Clock::Wall},
        {"1 of 8 layers composed anew to all of them", "composing 1 of 8 layers anew", "composing 8 layers",
         Clock::Wall}};
}

} // namespace benchmarks
