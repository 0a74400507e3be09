#include "core/exchange/project/project_content.h"

#include "core/exchange/project/accuracy_json.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/painting_json.h"
#include "core/exchange/project/preparation_json.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/project_version.h"
#include "core/exchange/project/projector_file.h"
#include "core/exchange/project/region_json.h"
#include "core/exchange/project/scene_file.h"
#include "core/support/byte_order.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace esm {

using Json = nlohmann::ordered_json;
namespace layout = project_layout;

namespace {

template<typename T> Bytes bytesOf(const std::string& entry, const std::vector<T>& values) {
    if constexpr (std::is_floating_point_v<T>)
        if (std::any_of(values.begin(), values.end(), [](T value) { return !std::isfinite(value); }))
            throw InvalidModel(entry + " would hold a number that is not finite");
    Bytes bytes;
    bytes.reserve(values.size() * sizeof(T));
    for (const T value : values)
        appendLittleEndian(bytes, value);
    return bytes;
}

/// Pieces that keep alive what they are made of, and how many numbers each entry has.
struct Arrays {
    Json counts = Json::object();
    std::vector<ContentPiece>& pieces;

    /// @param numbers makes the numbers of a source, all of an entry or more of it
    template<typename Source, typename Numbers>
    void add(const char* entry, const std::shared_ptr<const Source>& source, std::size_t count,
             const Numbers& numbers) {
        counts[entry] = counts.value(entry, std::size_t{0}) + count;
        pieces.push_back(
            {entry, source, [=, name = std::string(entry)] { return bytesOf(name, numbers(*source)); }});
    }
};

std::vector<double> numbersOf(const std::vector<std::array<Eigen::Vector2d, 3>>& triangles) {
    std::vector<double> numbers;
    numbers.reserve(6 * triangles.size());
    for (const auto& triangle : triangles)
        for (const Eigen::Vector2d& corner : triangle)
            numbers.insert(numbers.end(), {corner.x(), corner.y()});
    return numbers;
}

void addMesh(const std::shared_ptr<const TriangleMesh>& mesh, Arrays& arrays) {
    arrays.add(layout::meshVertices, mesh, 3 * mesh->vertices.size(),
               [](const TriangleMesh& m) { return coordinatesOf(m.vertices); });
    arrays.add(layout::meshTriangles, mesh, 3 * mesh->triangles.size(),
               [](const TriangleMesh& m) { return cornersOf(m.triangles); });
    if (!mesh->textureCoordinates.empty())
        arrays.add(layout::meshTextureCoordinates, mesh, 6 * mesh->textureCoordinates.size(),
                   [](const TriangleMesh& m) { return numbersOf(m.textureCoordinates); });
}

std::vector<std::uint32_t> endsOf(const SpringNetwork& network) {
    std::vector<std::uint32_t> ends;
    for (const Spring& spring : network.springs)
        ends.insert(ends.end(), {spring.first, spring.second});
    return ends;
}

std::vector<double> restLengthsOf(const SpringNetwork& network) {
    std::vector<double> lengths;
    for (const Spring& spring : network.springs)
        lengths.push_back(spring.restLength);
    return lengths;
}

using Network = std::shared_ptr<const SpringNetwork>;

void addNetwork(const Network& network, Arrays& arrays) {
    arrays.add(layout::networkNodes, network, 3 * network->restPositions.size(),
               [](const SpringNetwork& n) { return coordinatesOf(n.restPositions); });
    arrays.add(layout::networkSprings, network, 2 * network->springs.size(), endsOf);
    arrays.add(layout::networkRestLengths, network, network->springs.size(), restLengthsOf);
    arrays.add(layout::networkVertexNodes, network, network->vertexNodes.size(),
               [](const SpringNetwork& n) { return n.vertexNodes; });
}

void addBinding(const Network& network, Arrays& arrays) {
    const Binding& binding = *network->binding;
    const BindingRows& rows = binding.vertices;
    const bool isWide = needsStarts(binding);
    const std::size_t shares = isWide ? rows.nodes.size() : 3 * rows.size();
    if (isWide)
        arrays.add(layout::bindingStarts, network, rows.starts.size(),
                   [](const SpringNetwork& n) { return *numbersOf(*n.binding).starts; });
    arrays.add(layout::bindingNodes, network, shares,
               [](const SpringNetwork& n) { return numbersOf(*n.binding).nodes; });
    arrays.add(layout::bindingShares, network, shares,
               [](const SpringNetwork& n) { return numbersOf(*n.binding).shares; });
    arrays.add(layout::bindingSurface, network, 3 * binding.surface.size(),
               [](const SpringNetwork& n) { return cornersOf(n.binding->surface); });
    arrays.add(layout::bindingLines, network, 2 * binding.lines.size(),
               [](const SpringNetwork& n) { return numbersOf(*n.binding).lines; });
}

void addLattice(const Network& network, Arrays& arrays) {
    arrays.add(layout::latticeTetrahedra, network, 4 * network->lattice->tetrahedra.size(),
               [](const SpringNetwork& n) { return cornersOf(n.lattice->tetrahedra); });
    arrays.add(layout::latticeSpringShares, network, network->lattice->springShares.size(),
               [](const SpringNetwork& n) { return n.lattice->springShares; });
}

void addSheet(const Network& network, Arrays& arrays) {
    arrays.add(layout::sheetSpringShares, network, network->sheet->springs.size(),
               [](const SpringNetwork& n) { return n.sheet->springs; });
    arrays.add(layout::sheetNodeShares, network, network->sheet->nodes.size(),
               [](const SpringNetwork& n) { return n.sheet->nodes; });
}

Json addAtlas(const std::shared_ptr<const Atlas>& atlas, Arrays& arrays) {
    arrays.add(layout::atlasCorners, atlas, 6 * atlas->corners.size(),
               [](const Atlas& a) { return numbersOf(a.corners); });
    arrays.add(layout::atlasPages, atlas, atlas->page.size(),
               [](const Atlas& a) { return std::vector<std::uint32_t>(a.page.begin(), a.page.end()); });
    Json json = writtenFields(atlas->options, PlainForms(), atlasFields(layout::askedOfAtlas));
    json.update(writtenFields(*atlas));
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
    Json& files;
    std::vector<ContentPiece>& pieces;
    std::vector<const Photo*>& added;

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
        pieces.push_back({entry, photo, [photo] { return photo->encoded; }, true});
        return place;
    }

    Json write(const BrushStrokes& strokes) const { return toJson(strokes); }
};

Json addPhotos(const std::vector<TextureLayer>& layers, Arrays& arrays) {
    Json files = Json::array();
    std::vector<const Photo*> added;
    Json list = written(layers, LayerWriting{files, arrays.pieces, added});
    for (const TextureLayer& layer : layers)
        for (const std::shared_ptr<const BrushStroke>& stroke : layer.strokes)
            arrays.add(layout::brushPoints, stroke, numbersPerBrushPoint * stroke->path.size(), pointNumbers);
    for (const TextureLayer& layer : layers)
        for (const std::shared_ptr<const BrushStroke>& stroke : layer.strokes)
            if (!stroke->shares.empty())
                arrays.add(layout::brushShares, stroke, numbersPerBrushShares * stroke->shares.size(),
                           shareNumbers);
    return {{"files", std::move(files)}, {"layers", std::move(list)}};
}

} // namespace

ProjectContent contentOf(const Project& project) {
    ProjectContent content;
    Arrays arrays{Json::object(), content.pieces};
    addMesh(project.mesh, arrays);
    addNetwork(project.network, arrays);
    if (project.network->binding) addBinding(project.network, arrays);
    if (project.network->lattice) addLattice(project.network, arrays);
    if (project.network->sheet) addSheet(project.network, arrays);
    RegionsJson regions = toJson(project.regions, project.spareSystems);
    Json texture = writtenFields(project.texture.atlas);
    texture.update(writtenFields(project.texture));
    content.manifest = {{"format", layout::format},
                        {"version", projectVersionOf(project)},
                        {"program", ESM_VERSION},
                        {"name", project.name},
                        {"importReport", writtenFields(*project.importReport)},
                        {"base", writtenFields(project.base)},
                        {"fuzzySystems", std::move(regions.systems)},
                        {"regions", std::move(regions.regions)},
                        {"scene", toJson(project.scene)},
                        {"photos", addPhotos(project.layers, arrays)},
                        {"texture", std::move(texture)}};
    if (project.source) content.manifest["source"] = writtenFields(*project.source);
    if (project.stepping) content.manifest["stepping"] = toJson(*project.stepping);
    if (project.accuracy) content.manifest["accuracy"] = toJson(*project.accuracy);
    if (project.editor) content.manifest["editor"] = writtenFields(*project.editor);
    if (project.atlas) content.manifest["atlas"] = addAtlas(project.atlas, arrays);
    if (project.network->lattice)
        content.manifest["lattice"] = writtenFields(project.network->lattice->filling);
    content.manifest["arrays"] = std::move(arrays.counts);
    return content;
}

std::vector<std::string> manifestProblems(const Project& project, const Json& manifest) {
    std::vector<std::string> problems;
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
    return problems;
}

std::string manifestText(const Json& manifest, int indent) {
    return manifest.dump(indent, ' ', false, Json::error_handler_t::replace);
}

} // namespace esm
