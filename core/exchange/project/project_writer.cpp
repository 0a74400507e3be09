#include "core/exchange/project/model_json.h"
#include "core/exchange/project/painting_json.h"
#include "core/exchange/project/preparation_json.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/project_version.h"
#include "core/exchange/project/projector_file.h"
#include "core/exchange/project/region_json.h"
#include "core/exchange/project/scene_file.h"
#include "core/exchange/project/zip_archive.h"
#include "core/support/byte_order.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace esm {

using Json = nlohmann::ordered_json;
namespace layout = project_layout;

namespace {

struct Content {
    Json arrays = Json::object(); ///< number of elements by entry
    std::vector<ZipEntry> entries;
    std::vector<std::string> problems;

    template<typename T> void add(const char* name, const std::vector<T>& values) {
        if constexpr (std::is_floating_point_v<T>)
            if (std::any_of(values.begin(), values.end(), [](T value) { return !std::isfinite(value); }))
                problems.push_back(std::string(name) + " would hold a number that is not finite");
        arrays[name] = values.size();
        ZipEntry entry{name, {}, true};
        entry.content.reserve(values.size() * sizeof(T));
        for (const T value : values)
            appendLittleEndian(entry.content, value);
        entries.push_back(std::move(entry));
    }
};

void addMesh(const TriangleMesh& mesh, Content& content) {
    content.add(layout::meshVertices, coordinatesOf(mesh.vertices));
    content.add(layout::meshTriangles, cornersOf(mesh.triangles));
}

void addNetwork(const SpringNetwork& network, Content& content) {
    std::vector<std::uint32_t> ends;
    std::vector<double> restLengths;
    for (const Spring& spring : network.springs) {
        ends.insert(ends.end(), {spring.first, spring.second});
        restLengths.push_back(spring.restLength);
    }
    content.add(layout::networkNodes, coordinatesOf(network.restPositions));
    content.add(layout::networkSprings, ends);
    content.add(layout::networkRestLengths, restLengths);
    content.add(layout::networkVertexNodes, network.vertexNodes);
}

void addBinding(const Binding& binding, Content& content) {
    const BindingNumbers numbers = numbersOf(binding);
    if (numbers.starts) content.add(layout::bindingStarts, *numbers.starts);
    content.add(layout::bindingNodes, numbers.nodes);
    content.add(layout::bindingShares, numbers.shares);
    content.add(layout::bindingSurface, cornersOf(binding.surface));
    content.add(layout::bindingLines, numbers.lines);
}

Json addAtlas(const Atlas& atlas, Content& content) {
    std::vector<double> corners;
    for (const auto& triangle : atlas.corners)
        for (const Eigen::Vector2d& corner : triangle)
            corners.insert(corners.end(), {corner.x(), corner.y()});
    content.add(layout::atlasCorners, corners);
    content.add(layout::atlasPages, std::vector<std::uint32_t>(atlas.page.begin(), atlas.page.end()));
    Json json = writtenFields(atlas.options, PlainForms(), atlasFields(layout::askedOfAtlas));
    json.update(writtenFields(atlas));
    return json;
}

/// A name inside the archive that any tool unpacks, with the photo's own ending so that a viewer opens it.
std::string entryOfPhoto(std::size_t number, const std::string& fileName) {
    std::string ending = std::filesystem::path(fileName).extension().string();
    const bool plain =
        ending.size() <= 6 && std::all_of(ending.begin() + (ending.empty() ? 0 : 1), ending.end(),
                                          [](unsigned char c) { return c < 128 && std::isalnum(c); });
    return "photos/" + std::to_string(number) + (plain ? ending : "");
}

/// What of layers stands elsewhere in the file.
struct LayerWriting {
    Content& content;
    Json& files;
    std::vector<const Photo*>& added;
    std::vector<double>& brushPoints;

    /// The place of a photo's file, added where it is not there yet: layers may share one.
    Json write(const std::shared_ptr<const Photo>& photo) const {
        const auto same = [&](const Photo* other) {
            return other == photo.get() ||
                   (other->fileName == photo->fileName && other->encoded == photo->encoded);
        };
        const auto found = std::find_if(added.begin(), added.end(), same);
        const auto place = static_cast<std::size_t>(found - added.begin());
        if (found != added.end()) return place;
        added.push_back(photo.get());
        const std::string entry = entryOfPhoto(place, photo->fileName);
        files.push_back({{"entry", entry}, {"fileName", photo->fileName}, {"bytes", photo->encoded.size()}});
        content.entries.push_back({entry, photo->encoded, false});
        return place;
    }

    Json write(const BrushStrokes& strokes) const { return toJson(strokes, brushPoints); }
};

Json addPhotos(const std::vector<TextureLayer>& layers, Content& content) {
    Json files = Json::array();
    std::vector<const Photo*> added;
    std::vector<double> points;
    Json list = written(layers, LayerWriting{content, files, added, points});
    if (!points.empty()) content.add(layout::brushPoints, points);
    return {{"files", std::move(files)}, {"layers", std::move(list)}};
}

Json manifestOf(const Project& project, Content& content) {
    addMesh(*project.mesh, content);
    addNetwork(*project.network, content);
    if (project.network->binding) addBinding(*project.network->binding, content);
    RegionsJson regions = toJson(project.regions);
    Json texture = writtenFields(project.texture.atlas);
    texture.update(writtenFields(project.texture));
    Json manifest{{"format", layout::format},
                  {"version", projectVersionOf(project)},
                  {"program", ESM_VERSION},
                  {"name", project.name},
                  {"importReport", writtenFields(*project.importReport)},
                  {"base", writtenFields(project.base)},
                  {"fuzzySystems", std::move(regions.systems)},
                  {"regions", std::move(regions.regions)},
                  {"scene", toJson(project.scene)},
                  {"photos", addPhotos(project.layers, content)},
                  {"texture", std::move(texture)}};
    if (project.stepping) manifest["stepping"] = toJson(*project.stepping);
    if (project.atlas) manifest["atlas"] = addAtlas(*project.atlas, content);
    manifest["arrays"] = content.arrays;
    return manifest;
}

/// What would make a file that cannot be loaded again.
std::vector<std::string> problemsOf(const Project& project, const Json& manifest, const Content& content) {
    std::vector<std::string> problems = content.problems;
    for (const TextureLayer& layer : project.layers) {
        if (layer.photo && layer.photo->encoded.empty())
            problems.push_back("the photo " + layer.name + " has no file");
        try {
            projectorFromJson(toJson(layer.projector));
        } catch (const InvalidModel& error) {
            problems.push_back("the projector of the photo " + layer.name + ": " + error.what());
        }
    }
    for (const std::string& place : nonFiniteNumbers(manifest))
        problems.push_back(place + " is not a finite number");
    std::uint64_t size = 0;
    for (const ZipEntry& entry : content.entries)
        size += entry.content.size();
    if (content.entries.front().content.size() > layout::largestManifest)
        problems.push_back("its lists are longer than a project file can hold; shorten the scene's paths");
    if (size > layout::largestProject)
        problems.push_back("it is larger than 2 GiB; use fewer or smaller photos");
    return problems;
}

void refuse(const std::filesystem::path& file, const std::vector<std::string>& problems) {
    if (!problems.empty())
        throw FileError(file, "was not saved: " + std::string(InvalidModel(problems).what()));
}

/// Names that differ only in bytes that are no Unicode, for example, would become one key.
void requireParsable(const std::filesystem::path& file, const std::string& manifest) {
    try {
        guardJson(manifest.data(), manifest.data() + manifest.size());
    } catch (const InvalidModel& error) {
        refuse(file, error.problems());
    }
}

} // namespace

void saveProject(const Project& project, const std::filesystem::path& file) {
    refuse(file, validate(project));
    Content content;
    content.entries.push_back({layout::manifest, {}, true});
    const Json manifest = manifestOf(project, content);
    // Names may come from file names in any encoding; JSON holds UTF-8 only.
    const std::string text = manifest.dump(1, ' ', false, Json::error_handler_t::replace);
    content.entries.front().content.assign(text.begin(), text.end());
    refuse(file, problemsOf(project, manifest, content));
    requireParsable(file, text);
    writeFileAtomically(file, makeZip(content.entries));
}

} // namespace esm
