#include "core/exchange/project/accuracy_json.h"
#include "core/exchange/project/content_entries.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/network_reader.h"
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

/// Rows are all there was before files said so.
template<class Table> AtlasOptions readOptions(const JsonReader& reader, const Table& table) {
    AtlasOptions options;
    options.layout = AtlasLayout::Rows;
    readFields(reader, options, PlainForms(), table);
    return options;
}

std::shared_ptr<const Atlas> readAtlas(const JsonReader& reader, const JsonReader& arrays,
                                       ContentEntries& source) {
    auto atlas = std::make_shared<Atlas>();
    atlas->options = readOptions(reader, atlasFields(layout::askedOfAtlas));
    readFields(reader, *atlas);
    atlas->corners = flatTriangles(source.numbers(arrays, layout::atlasCorners, 6));
    const auto pages = static_cast<std::size_t>(atlas->options.pages);
    for (const std::uint32_t page : source.indices(arrays, layout::atlasPages, 1, pages))
        atlas->page.push_back(static_cast<std::uint16_t>(page));
    return atlas;
}

std::shared_ptr<const Photo> readPhotoFile(const JsonReader& reader, ContentEntries& source) {
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

std::vector<TextureLayer> readLayers(const JsonReader& reader, const JsonReader& arrays,
                                     ContentEntries& source) {
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

std::shared_ptr<const RepairReport> readReport(const JsonReader& reader, ContentEntries& source) {
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

Project readContent(const JsonReader& manifest, ContentEntries& source) {
    Project project;
    const JsonReader arrays = manifest.member("arrays");
    project.name = manifest.member("name").text();
    project.mesh = readMesh(arrays, source);
    project.network = readNetwork(manifest, source);
    project.importReport = readReport(manifest.member("importReport"), source);
    if (manifest.has("source")) project.source = valueFrom<MeshSource>(manifest.member("source"));
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
    ContentEntries source(entries, shared, progress, stepsOf(reader), problems);
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
