#include "tests/benchmarks/layer_composition.h"

#include "core/texture/layers/composite.h"
#include "tests/benchmarks/bare_composition.h"
#include "tests/benchmarks/memory_peak.h"
#include "tests/support/test_surfaces.h"

#include <cmath>
#include <tbb/global_control.h>

namespace benchmarks {

namespace {

using namespace esm;

constexpr int compositions = 5, layerCount = 8, pageSize = 4096;
constexpr std::array<std::uint8_t, 3> base{186, 92, 84};

/// Noise, in which no neighbouring pixels are the same.
std::shared_ptr<const Photo> noisePhoto() {
    auto photo = std::make_shared<Photo>();
    photo->image.width = 1920;
    photo->image.height = 1080;
    photo->image.pixels.reserve(4UL * 1920 * 1080);
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
        layer.projector.width = 0.17;
        layer.projector.height = 0.096;
        layers.push_back(layer);
    }
    return layers;
}

/// The same photos by eyes that see as much of the organ's middle.
std::vector<TextureLayer> perspectiveOf(std::vector<TextureLayer> layers, bool falloff) {
    for (TextureLayer& layer : layers) {
        layer.projector.kind = ProjectorKind::Perspective;
        layer.projector.falloff = falloff;
    }
    return layers;
}

/// Every second of them, blended in bands.
std::vector<TextureLayer> bandedOf(const std::vector<TextureLayer>& layers) {
    std::vector<TextureLayer> banded;
    for (std::size_t i = 0; i < layers.size(); i += 2) {
        banded.push_back(layers[i]);
        banded.back().blending = Blending::MultiBand;
    }
    return banded;
}

/// An organ of 20 k triangles and what is laid on it, the same for all that is measured.
struct Work {
    TriangleMesh mesh = lumpySurface(100, 100);
    Atlas atlas = packAtlas(mesh, {pageSize, 1, 2, AtlasLayout::UnfoldedGroups});
    std::vector<TextureLayer> layers = layersAround(), single{layers[0]}, translucent = layers,
                              moved = layers, fainter = layers, perspective = perspectiveOf(layers, false),
                              falloff = perspectiveOf(layers, true), banded = bandedOf(layers);
    std::vector<BarePyramid> pyramids;
    Composition before;
    CompositionCache cache;

    Work() {
        for (TextureLayer& layer : translucent)
            layer.opacity = 0.5;
        moved[3].projector.pose.translation().y() += 0.01;
        fainter[3].opacity = 0.5;
        for (const TextureLayer& layer : layers)
            pyramids.push_back(barePyramid(layer.photo->image));
        before = {layers, base,
                  std::make_shared<const TiledPages>(recomposite(mesh, atlas, {}, layers, base, cache))};
    }
};

Work& sharedWork() {
    static Work work;
    return work;
}

using Layers = std::vector<TextureLayer> Work::*;

void registerComposition(const std::string& name, Layers layers, std::size_t threads) {
    registerWork(name, compositions, [layers, threads] {
        const auto cache = std::make_shared<CompositionCache>();
        return [layers, threads, cache] {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const Work& work = sharedWork();
            benchmark::DoNotOptimize(composite(work.mesh, work.atlas, work.*layers, base, *cache));
        };
    });
}

void registerFromNothing(const std::string& name, Layers layers) {
    registerWork(name, compositions, [layers] {
        sharedWork();
        return [layers] {
            const Work& work = sharedWork();
            benchmark::DoNotOptimize(composite(work.mesh, work.atlas, work.*layers, base));
        };
    });
}

void registerRecomposition(const std::string& name, Layers layers) {
    registerWork(name, compositions, [layers] {
        sharedWork();
        return [layers] {
            Work& work = sharedWork();
            benchmark::DoNotOptimize(
                recomposite(work.mesh, work.atlas, work.before, work.*layers, base, work.cache));
        };
    });
}

void registerBareLoop(const std::string& name, Layers layers) {
    registerWork(name, compositions, [layers] {
        sharedWork();
        return [layers] {
            const Work& work = sharedWork();
            Image page{pageSize, pageSize, std::vector<std::uint8_t>(4UL * pageSize * pageSize, 120)};
            for (std::size_t i = 0; i < (work.*layers).size(); ++i)
                layBare(work.mesh, work.atlas, (work.*layers)[i], work.pyramids[i], page);
            benchmark::DoNotOptimize(page);
        };
    });
}

/// Bytes beside the photos to the bytes of the page: from nothing, or with the pages before it that the next
/// ones are made from.
Ratio memoryRatio(const std::string& name, bool again) {
    const auto ratio = std::make_shared<double>(0);
    registerWork(name, 1, [ratio, again] {
        sharedWork();
        return [ratio, again] {
            const Work& work = sharedWork();
            const MemoryPeak peak;
            CompositionCache cache;
            Composition before{work.layers, base, nullptr};
            before.pages = std::make_shared<const TiledPages>(
                recomposite(work.mesh, work.atlas, {}, work.layers, base, cache));
            if (again)
                benchmark::DoNotOptimize(recomposite(work.mesh, work.atlas, before, work.moved, base, cache));
            *ratio = static_cast<double>(peak.bytes()) / (4.0 * pageSize * pageSize);
        };
    });
    Ratio measured{name + ": to the page", name, name, Clock::Wall, 0, 3};
    measured.measured = ratio;
    return measured;
}

} // namespace

std::vector<Ratio> registerLayerComposition() {
    registerComposition("composing 1 layer, 1 thread", &Work::single, 1);
    registerComposition("composing 1 layer, 2 threads", &Work::single, 2);
    registerComposition("composing 8 layers, 1 thread", &Work::layers, 1);
    registerComposition("composing 8 layers, 2 threads", &Work::layers, 2);
    registerComposition("composing 8 half opaque layers, 1 thread", &Work::translucent, 1);
    registerFromNothing("composing 8 layers from nothing", &Work::layers);
    registerFromNothing("composing 8 perspective layers from nothing", &Work::perspective);
    registerFromNothing("composing 8 perspective layers with falloff from nothing", &Work::falloff);
    registerFromNothing("composing 4 banded layers from nothing", &Work::banded);
    registerRecomposition("moving 1 of 8 layers", &Work::moved);
    registerRecomposition("making 1 of 8 layers fainter", &Work::fainter);
    registerBareLoop("bare loop, 1 layer", &Work::single);
    registerBareLoop("bare loop, 8 layers", &Work::layers);
    return {
        {"1 layer, 1 thread: to the bare loop", "composing 1 layer, 1 thread", "bare loop, 1 layer",
         Clock::Wall, 0, 1.3},
        {"1 layer: 1 thread to 2", "composing 1 layer, 1 thread", "composing 1 layer, 2 threads", Clock::Wall,
         1.6},
        {"8 layers, 1 thread: to the bare loop", "composing 8 layers, 1 thread", "bare loop, 8 layers",
         Clock::Wall, 0, 1.3},
        {"8 half opaque layers: to the bare loop", "composing 8 half opaque layers, 1 thread",
         "bare loop, 8 layers", Clock::Wall, 0, 1.3},
        {"8 layers: 1 thread to 2", "composing 8 layers, 1 thread", "composing 8 layers, 2 threads",
         Clock::Wall, 1.6},
        {"8 layers from nothing: to the bare loop", "composing 8 layers from nothing", "bare loop, 8 layers",
         Clock::Wall},
        {"8 perspective layers from nothing: to the bare loop", "composing 8 perspective layers from nothing",
         "bare loop, 8 layers", Clock::Wall},
        {"8 perspective layers with falloff from nothing: to the bare loop",
         "composing 8 perspective layers with falloff from nothing", "bare loop, 8 layers", Clock::Wall},
        {"4 banded layers from nothing: to the bare loop", "composing 4 banded layers from nothing",
         "bare loop, 8 layers", Clock::Wall},
        {"1 of 8 layers moved: to all", "moving 1 of 8 layers", "composing 8 layers, 2 threads", Clock::Wall},
        {"1 of 8 layers fainter: to all", "making 1 of 8 layers fainter", "composing 8 layers, 2 threads",
         Clock::Wall},
        memoryRatio("memory of composing 8 layers", false),
        memoryRatio("memory of composing them again", true),
    };
}

} // namespace benchmarks
