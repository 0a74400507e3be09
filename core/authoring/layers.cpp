#include "core/authoring/layers.h"

#include "core/authoring/move_item.h"
#include "core/authoring/packing.h"

#include <algorithm>
#include <filesystem>

namespace esm {

namespace {

bool hasName(const Project& project, const std::string& name) {
    return std::any_of(project.layers.begin(), project.layers.end(),
                       [&](const TextureLayer& layer) { return layer.name == name; });
}

/// "Paint 3", the first that no layer is called.
std::string freePaintName(const Project& project) {
    for (int number = 1;; ++number) {
        std::string name = "Paint " + std::to_string(number);
        if (!hasName(project, name)) return name;
    }
}

/// "Polyp copy", "Polyp copy 2", the first that no layer is called.
std::string freeCopyName(const Project& project, const std::string& original) {
    std::string name = original + " copy";
    for (int number = 2; hasName(project, name); ++number)
        name = original + " copy " + std::to_string(number);
    return name;
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

void duplicateLayer(Project& project, LayerId layer, LayerId copy) {
    const std::size_t place = placeOf(project.layers, layer).value();
    TextureLayer made = project.layers[place];
    made.id = copy;
    made.name = freeCopyName(project, made.name);
    project.layers.insert(project.layers.begin() + static_cast<std::ptrdiff_t>(place) + 1, std::move(made));
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
