#include "core/exchange/project/accuracy_json.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/painting_json.h"
#include "core/exchange/project/preparation_json.h"
#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/project_version.h"
#include "core/exchange/project/projector_file.h"
#include "core/exchange/project/region_json.h"
#include "core/exchange/project/scene_file.h"
#include "core/project/project_warnings.h"
#include "core/support/byte_order.h"
#include "core/support/errors.h"
#include "core/support/offenders.h"
#include "core/texture/photo/photo_format.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace esm {

using Json = nlohmann::ordered_json;
namespace layout = project_layout;

namespace {

/// The entries while they are read. Problems are collected, so that one pass finds all of them.
class Source {
public:
    /// @param steps entries to read, photos to decode and to prepare
    Source(const ContentSource& entries, SharedParts& shared, const Progress& progress, std::size_t steps,
           std::vector<std::string>& problems)
        : m_entries(entries), m_shared(shared), m_parts(progress), m_step(1 / static_cast<double>(steps + 1)),
          m_problems(problems) {}

    /// What another project has read from the same entries already, or else what `make` gives.
    /// @param kind with what else it depends on
    template<class Part, class Make>
    std::shared_ptr<const Part> shared(std::string kind, const std::vector<std::string>& entries,
                                       const Make& make) {
        if (!m_entries.nameOfContent) return make();
        for (const std::string& entry : entries)
            kind += '\n' + m_entries.nameOfContent(entry);
        std::shared_ptr<const void>& known = m_shared.byContent[kind];
        if (!known) {
            const std::size_t problems = m_problems.size();
            std::shared_ptr<const Part> made = make();
            if (m_problems.size() > problems) return made;
            known = made;
        }
        return std::static_pointer_cast<const Part>(known);
    }

    /// An entry of `size` bytes; empty, and a problem, where it cannot be had. What fails counts too, so that
    /// no file can have the same bytes unpacked again and again.
    Bytes bytes(const std::string& entry, std::uint64_t size) {
        try {
            if (!m_named.insert(entry).second)
                throw InvalidModel("the entry " + entry + " is named twice; leave one out");
            if (size > m_budget)
                throw InvalidModel("the entry " + entry +
                                   " would unpack to more than the 2 GiB a project may have");
            m_budget -= size;
            Bytes content = m_entries.bytes(entry, size, nextStep());
            if (content.size() == size) return content;
            m_problems.push_back(entry + " should have " + std::to_string(size) + " bytes, but has " +
                                 std::to_string(content.size()));
        } catch (const InvalidModel& error) {
            m_problems.push_back(error.what());
        }
        return {};
    }

    /// A photo, decoded only where the pixels it claims leave room for the other ones.
    std::shared_ptr<const Photo> photo(const std::string& name, Bytes encoded) {
        const PhotoFormat format = inspectPhoto(encoded);
        const std::uint64_t most = texture_limits::mostPhotoPixels;
        if (format.width > 0 && format.height > 0 && format.width <= most / format.height) {
            takePixels(format.width * format.height, name);
        }
        return decodePhoto(name, std::move(encoded), nextStep());
    }

    /// Prepares a layer's photo, where the picture has room beside the other ones.
    void prepare(const JsonReader& reader, TextureLayer& layer) {
        const PhotoPreparation preparation = std::exchange(layer.preparation, {});
        if (!layer.photo || preparation.isNothing()) return;
        try {
            takePixels(layer.photo->image.pixels.size() / 4, layer.photo->fileName);
            if (takePrepared(layer, preparation)) return;
            esm::prepare(layer, preparation, nextStep());
            m_shared.preparations.push_back({layer.photo, preparation, layer.prepared});
        } catch (const InvalidModel& error) {
            for (const std::string& problem : error.problems())
                reader.addProblem("is not usable: " + problem);
        } catch (const FileError& error) {
            reader.addProblem(std::string("is not usable: ") + error.what());
        }
    }

    /// The numbers of an array in groups of `components`.
    template<typename T>
    std::vector<T> array(const JsonReader& arrays, const char* entry, std::size_t components) {
        const JsonReader declared = arrays.member(entry);
        const std::uint64_t count = declared.integer(0, layout::largestProject / sizeof(T));
        if (count % components != 0) {
            declared.addProblem("should be a multiple of " + std::to_string(components));
            return {};
        }
        const Bytes content = bytes(entry, count * sizeof(T));
        std::vector<T> values;
        values.reserve(content.size() / sizeof(T));
        for (std::size_t i = 0; i < content.size(); i += sizeof(T))
            values.push_back(littleEndian<T>(&content[i]));
        return values;
    }

    std::vector<double> numbers(const JsonReader& arrays, const char* entry, std::size_t components) {
        std::vector<double> values = array<double>(arrays, entry, components);
        const auto bad =
            std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
        if (bad == values.end()) return values;
        m_problems.push_back(std::string(entry) + ": number " + std::to_string(bad - values.begin()) +
                             " is not finite");
        return {};
    }

    /// Whole numbers below `limit`. Any, where what they count could not be read, which is told already.
    std::vector<std::uint32_t> indices(const JsonReader& arrays, const char* entry, std::size_t components,
                                       std::size_t limit) {
        std::vector<std::uint32_t> values = array<std::uint32_t>(arrays, entry, components);
        if (limit == 0 && foundProblems()) return values;
        const auto bad =
            std::find_if(values.begin(), values.end(), [&](std::uint32_t value) { return value >= limit; });
        if (bad == values.end()) return values;
        m_problems.push_back(std::string(entry) + ": number " + std::to_string(bad - values.begin()) +
                             " is " + std::to_string(*bad) + ", but should be below " +
                             std::to_string(limit));
        return {};
    }

    bool foundProblems() const { return !m_problems.empty(); }

private:
    Progress nextStep() { return m_parts.next(m_step); }

    /// False where no project has such a picture yet.
    bool takePrepared(TextureLayer& layer, const PhotoPreparation& preparation) const {
        const auto found =
            std::find_if(m_shared.preparations.begin(), m_shared.preparations.end(),
                         [&](const SharedParts::Preparation& known) {
                             return known.photo == layer.photo && known.preparation == preparation;
                         });
        if (found == m_shared.preparations.end()) return false;
        layer.preparation = preparation;
        layer.prepared = found->prepared;
        return true;
    }

    void takePixels(std::uint64_t pixels, const std::string& name) {
        if (pixels > m_pixels)
            throw FileError(name, "has more pixels than the project's other photos leave room for; use fewer "
                                  "or smaller photos");
        m_pixels -= pixels;
    }

    const ContentSource& m_entries;
    SharedParts& m_shared;
    ProgressParts m_parts;
    double m_step; ///< share of all
    std::vector<std::string>& m_problems;
    std::set<std::string> m_named;
    std::uint64_t m_budget = layout::largestProject;
    std::uint64_t m_pixels = texture_limits::mostPixelsOfAllPhotos;
};

std::vector<std::array<Eigen::Vector2d, 3>> flatTriangles(const std::vector<double>& numbers) {
    std::vector<std::array<Eigen::Vector2d, 3>> triangles;
    triangles.reserve(numbers.size() / 6);
    for (std::size_t i = 0; i < numbers.size(); i += 6)
        triangles.push_back({Eigen::Vector2d(numbers[i], numbers[i + 1]),
                             {numbers[i + 2], numbers[i + 3]},
                             {numbers[i + 4], numbers[i + 5]}});
    return triangles;
}

std::shared_ptr<const TriangleMesh> readMesh(const JsonReader& arrays, Source& source) {
    auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = pointsOf(source.numbers(arrays, layout::meshVertices, 3));
    mesh->triangles = trianglesOf(source.indices(arrays, layout::meshTriangles, 3, mesh->vertices.size()));
    if (arrays.has(layout::meshTextureCoordinates))
        mesh->textureCoordinates = flatTriangles(source.numbers(arrays, layout::meshTextureCoordinates, 6));
    return mesh;
}

Binding readBinding(const JsonReader& arrays, Source& source, std::size_t nodes) {
    const bool hasStarts = arrays.has(layout::bindingStarts);
    const std::size_t together = hasStarts ? 1 : 3;
    BindingNumbers numbers{{},
                           source.indices(arrays, layout::bindingNodes, together, nodes),
                           source.numbers(arrays, layout::bindingShares, together),
                           source.indices(arrays, layout::bindingLines, 2, nodes)};
    if (hasStarts) numbers.starts = source.array<std::uint32_t>(arrays, layout::bindingStarts, 1);
    if (numbers.nodes.size() != numbers.shares.size() && !source.foundProblems())
        arrays.addProblem("give " + std::to_string(numbers.nodes.size()) +
                          " nodes that carry vertices, but " + std::to_string(numbers.shares.size()) +
                          " shares");
    return bindingOf(numbers, trianglesOf(source.indices(arrays, layout::bindingSurface, 3, nodes)));
}

std::shared_ptr<const SpringNetwork> readNetwork(const JsonReader& arrays, Source& source) {
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = pointsOf(source.numbers(arrays, layout::networkNodes, 3));
    const std::size_t nodes = network->restPositions.size();
    const std::vector<std::uint32_t> ends = source.indices(arrays, layout::networkSprings, 2, nodes);
    const std::vector<double> restLengths = source.numbers(arrays, layout::networkRestLengths, 1);
    if (ends.size() != 2 * restLengths.size() && !source.foundProblems())
        arrays.addProblem("give " + std::to_string(ends.size() / 2) + " springs, but " +
                          std::to_string(restLengths.size()) + " rest lengths");
    for (std::size_t i = 0; i < std::min(restLengths.size(), ends.size() / 2); ++i)
        network->springs.push_back({ends[2 * i], ends[2 * i + 1], restLengths[i]});
    network->vertexNodes = source.indices(arrays, layout::networkVertexNodes, 1, nodes);
    if (arrays.has(layout::bindingNodes)) network->binding = readBinding(arrays, source, nodes);
    return network;
}

/// Rows are all there was before files said so.
template<class Table> AtlasOptions readOptions(const JsonReader& reader, const Table& table) {
    AtlasOptions options;
    options.layout = AtlasLayout::Rows;
    readFields(reader, options, PlainForms(), table);
    return options;
}

std::shared_ptr<const Atlas> readAtlas(const JsonReader& reader, const JsonReader& arrays, Source& source) {
    auto atlas = std::make_shared<Atlas>();
    atlas->options = readOptions(reader, atlasFields(layout::askedOfAtlas));
    readFields(reader, *atlas);
    atlas->corners = flatTriangles(source.numbers(arrays, layout::atlasCorners, 6));
    const auto pages = static_cast<std::size_t>(atlas->options.pages);
    for (const std::uint32_t page : source.indices(arrays, layout::atlasPages, 1, pages))
        atlas->page.push_back(static_cast<std::uint16_t>(page));
    return atlas;
}

std::shared_ptr<const Photo> readPhotoFile(const JsonReader& reader, Source& source) {
    const std::string entry = reader.member("entry").text(), name = reader.member("fileName").text();
    const std::uint64_t size = reader.member("bytes").integer(1, layout::largestProject);
    try {
        return source.shared<Photo>(
            "photo " + name + '\n' + std::to_string(size), {entry}, [&]() -> std::shared_ptr<const Photo> {
                Bytes encoded = source.bytes(entry, size);
                return encoded.empty() ? nullptr : source.photo(name, std::move(encoded));
            });
    } catch (const FileError& error) {
        reader.addProblem("cannot be shown (entry " + entry + "): " + error.what());
        return nullptr;
    }
}

using PhotoFiles = std::vector<std::shared_ptr<const Photo>>;

/// What of layers stands elsewhere in the file.
struct LayerReading {
    const PhotoFiles& files;
    StrokeArrays& strokeArrays;

    void read(const JsonReader& reader, std::shared_ptr<const Photo>& photo) const {
        const std::size_t place = reader.count();
        if (place < files.size())
            photo = files[place];
        else
            reader.addProblem("names photo file " + std::to_string(place) + ", but there are " +
                              std::to_string(files.size()));
    }
    void read(const JsonReader& reader, BrushStrokes& strokes) const {
        strokes = strokesFromJson(reader, strokeArrays);
    }
};

std::vector<TextureLayer> readLayers(const JsonReader& reader, const JsonReader& arrays, Source& source) {
    PhotoFiles files;
    for (const JsonReader& file : reader.member("files").elements())
        files.push_back(readPhotoFile(file, source));
    StrokeArrays ofStrokes;
    if (arrays.has(layout::brushPoints))
        ofStrokes.points = source.numbers(arrays, layout::brushPoints, numbersPerBrushPoint);
    if (arrays.has(layout::brushShares))
        ofStrokes.shares = source.numbers(arrays, layout::brushShares, numbersPerBrushShares);
    std::vector<TextureLayer> layers;
    for (const JsonReader& json : reader.member("layers").elements()) {
        layers.push_back(valueFrom<TextureLayer>(json, LayerReading{files, ofStrokes}));
        if (json.has("preparation")) source.prepare(json.member("preparation"), layers.back());
    }
    return layers;
}

const std::vector<std::string> networkEntries{
    layout::networkNodes,       layout::networkSprings, layout::networkRestLengths,
    layout::networkVertexNodes, layout::bindingStarts,  layout::bindingNodes,
    layout::bindingShares,      layout::bindingSurface, layout::bindingLines};

std::shared_ptr<const RepairReport> readReport(const JsonReader& reader, Source& source) {
    return source.shared<RepairReport>("report " + manifestText(reader.json()), {}, [&] {
        return std::make_shared<const RepairReport>(valueFrom<RepairReport>(reader));
    });
}

/// One that does not know a workspace opens with the usual one: nothing else is lost by it.
EditorState readEditorState(const JsonReader& reader) {
    EditorState state;
    if (!reader.isObject()) return state;
    state.workspace = fromWord<Workspace>(reader.member("workspace").text()).value_or(state.workspace);
    state.plays = reader.member("plays").flag();
    return state;
}

Project readContent(const JsonReader& manifest, Source& source) {
    Project project;
    const JsonReader arrays = manifest.member("arrays");
    project.name = manifest.member("name").text();
    project.mesh = source.shared<TriangleMesh>(
        "mesh", {layout::meshVertices, layout::meshTriangles, layout::meshTextureCoordinates},
        [&] { return readMesh(arrays, source); });
    project.network =
        source.shared<SpringNetwork>("network", networkEntries, [&] { return readNetwork(arrays, source); });
    project.importReport = readReport(manifest.member("importReport"), source);
    project.base = valueFrom<BaseTissue>(manifest.member("base"));
    ReadRegions read = regionsFromJson(manifest.member("fuzzySystems"), manifest.member("regions"));
    project.regions = std::move(read.regions);
    project.spareSystems = std::move(read.spare);
    project.scene = readScene(manifest.member("scene"));
    if (manifest.has("stepping")) project.stepping = steppingFromJson(manifest.member("stepping"));
    if (manifest.has("accuracy"))
        project.accuracy =
            std::make_shared<const MeasuredAccuracy>(accuracyFromJson(manifest.member("accuracy")));
    if (manifest.has("editor")) project.editor = readEditorState(manifest.member("editor"));
    project.layers = readLayers(manifest.member("photos"), arrays, source);
    project.texture.atlas = readOptions(manifest.member("texture"), fieldsOf<AtlasOptions>);
    readFields(manifest.member("texture"), project.texture);
    if (manifest.has("atlas")) {
        const JsonReader atlas = manifest.member("atlas");
        project.atlas = source.shared<Atlas>("atlas " + manifestText(atlas.json()),
                                             {layout::atlasCorners, layout::atlasPages},
                                             [&] { return readAtlas(atlas, arrays, source); });
    }
    numberParts(project);
    return project;
}

std::size_t stepsOf(const JsonReader& manifest) {
    const JsonReader photos = manifest.member("photos");
    const std::size_t files = photos.member("files").elements().size();
    return manifest.member("arrays").members().size() + 2 * files + photos.member("layers").elements().size();
}

/// @throws InvalidModel for what no other version of the reader could make sense of
void requireKnownVersion(const JsonReader& manifest) {
    if (!manifest.has("format") || manifest.json()["format"] != layout::format)
        throw InvalidModel("is not a project of this program");
    refuseNewerVersion(manifest, projectFileVersion);
}

/// Programs that know only the version that the file says it is would misread it; this one does not.
std::vector<std::string> versionWarnings(const JsonReader& manifest, const Project& project) {
    const auto needed = static_cast<std::uint64_t>(projectVersionOf(project));
    if (manifest.member("version").integer(1, projectFileVersion) >= needed) return {};
    return {"version should be " + std::to_string(needed) + " for what the file holds; save it again"};
}

} // namespace

ReadContent projectFrom(const Json& manifest, const ContentSource& entries, SharedParts& shared,
                        const Progress& progress) {
    std::vector<std::string> problems;
    const JsonReader reader(manifest, "", problems);
    requireKnownVersion(reader);
    Source source(entries, shared, progress, stepsOf(reader), problems);
    Project project = readContent(reader, source);
    if (problems.empty()) problems = validate(project);
    if (!problems.empty()) return {{}, eachOnce(problems), {}};
    std::vector<std::string> warnings = versionWarnings(reader, project);
    for (std::string& warning : steppingWarnings(manifest))
        warnings.push_back(std::move(warning));
    if (project.accuracy)
        for (std::string& warning : accuracyWarnings(manifest["accuracy"], *project.accuracy))
            warnings.push_back(std::move(warning));
    for (std::string& warning : projectWarnings(project))
        warnings.push_back(std::move(warning));
    reportProgress(progress, 1);
    return {std::move(project), {}, std::move(warnings)};
}

} // namespace esm
