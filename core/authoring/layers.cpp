#include "core/authoring/layers.h"

#include "core/authoring/move_item.h"
#include "core/authoring/packing.h"

#include <algorithm>
#include <filesystem>

namespace esm {

namespace {

/// "Paint 3", the first that no layer is called.
std::string freePaintName(const Project& project) {
    for (int number = 1;; ++number) {
        std::string name = "Paint " + std::to_string(number);
        if (std::none_of(project.layers.begin(), project.layers.end(),
                         [&](const TextureLayer& layer) { return layer.name == name; }))
            return name;
    }
}

} // namespace

void addPhoto(Project& project, LayerId id, std::shared_ptr<const Photo> photo, const Projector& projector,
              std::shared_ptr<const Atlas> atlas) {
    takeAtlas(project, std::move(atlas));
    TextureLayer layer;
    layer.id = id;
    layer.name = std::filesystem::path(photo->fileName).stem().string();
    layer.photo = std::move(photo);
    layer.projector = projector;
    layer.projector.falloff = true;
    project.layers.push_back(std::move(layer));
}

void addPaintLayer(Project& project, LayerId id, std::shared_ptr<const Atlas> atlas) {
    takeAtlas(project, std::move(atlas));
    TextureLayer layer;
    layer.id = id;
    layer.name = freePaintName(project);
    project.layers.push_back(std::move(layer));
}

void removeLayer(Project& project, LayerId layer) {
    std::erase_if(project.layers, [&](const TextureLayer& other) { return other.id == layer; });
}

bool canMoveLayer(const Project& project, LayerId layer, int above) {
    const auto place = placeOf(project.layers, layer);
    return place && canMoveItem(project.layers.size(), *place, above);
}

void moveLayer(Project& project, LayerId layer, int above) {
    if (canMoveLayer(project, layer, above)) moveItem(project.layers, *placeOf(project.layers, layer), above);
}

} // namespace esm
