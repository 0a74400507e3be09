#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/repair.h"
#include "core/offscreen/offscreen.h"
#include "core/texture/layers/composite.h"
#include "tests/support/known_camera.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace esm;

namespace {

struct Difference {
    double mean;             ///< of colour, inside the mask, 0 to 255
    double sharedOverEither; ///< what is covered against the mask
};

/// @param covered what the photo covers, in green
Difference compare(const Image& picture, const Image& photo, const Image& mask, const Image& covered) {
    double sum = 0;
    long inside = 0, both = 0, either = 0;
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const bool isMasked = mask.at(x, y)[0] > 127;
            const bool isCovered = covered.at(x, y)[1] > 127 && covered.at(x, y)[0] < 64;
            both += isMasked && isCovered ? 1 : 0;
            either += isMasked || isCovered ? 1 : 0;
            if (!isMasked) continue;
            ++inside;
            for (int channel = 0; channel < 3; ++channel)
                sum += std::abs(int(picture.at(x, y)[channel]) - int(photo.at(x, y)[channel])) / 3.0;
        }
    return {sum / double(inside), double(both) / double(either)};
}

} // namespace

TEST(KnownCamera, GivesItsPictureBackFromTheOrgan) {
    ESM_SKIP_WITHOUT(knownCameraFolder());
    PolygonSoup soup = readMeshFile(sharedData("meshes/sks-liver-H07.ply"));
    convertToMetres(soup, LengthUnit::Millimetre, UpAxis::Y);
    const auto mesh = std::make_shared<const TriangleMesh>(repair(soup).mesh);
    const auto atlas = std::make_shared<const Atlas>(packAtlas(*mesh, {4096, 1, 2}));
    TextureLayer layer;
    layer.photo = loadPhoto(knownCameraFolder() / "synthetic-left.png");
    layer.projector = knownCamera();
    layer.blendPixels = 0;
    const Image& photo = layer.photo->image;
    const PhotoSize size{photo.width, photo.height};

    RenderScene scene;
    scene.mesh = mesh;
    scene.atlas = atlas;
    scene.unlit = true;
    scene.baseColour = {255, 0, 0};
    scene.backgroundTop = scene.backgroundBottom = {255, 0, 0};
    const auto drawn = [&](const TextureLayer& shown) {
        scene.texturePages =
            std::make_shared<const TiledPages>(tiled(composite(*mesh, *atlas, {shown}, scene.baseColour)));
        return renderOffscreen(scene, cameraOf(layer.projector, size), size.width, size.height);
    };
    auto green = std::make_shared<Photo>(*layer.photo);
    for (std::size_t i = 0; i < green->image.pixels.size(); ++i)
        green->image.pixels[i] = i % 4 == 1 || i % 4 == 3 ? 255 : 0;
    TextureLayer plain = layer;
    plain.photo = green;
    const Image mask = loadPhoto(knownCameraFolder() / "mask-left.png")->image;
    const Difference found = compare(drawn(layer), photo, mask, drawn(plain));
    EXPECT_LE(found.mean, 3);
    EXPECT_GE(found.sharedOverEither, 0.99);
}
