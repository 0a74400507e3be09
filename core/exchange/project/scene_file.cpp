#include "core/exchange/project/scene_file.h"

#include "core/exchange/project/ellipsoid_json.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

std::uint32_t nodeFromJson(const JsonReader& reader) {
    return static_cast<std::uint32_t>(reader.integer(0, std::numeric_limits<std::uint32_t>::max()));
}

std::vector<std::uint32_t> nodesFromJson(const JsonReader& reader) {
    std::vector<std::uint32_t> nodes;
    for (const JsonReader& node : reader.elements())
        nodes.push_back(nodeFromJson(node));
    return nodes;
}

Path pathFromJson(const JsonReader& reader) {
    Path path;
    for (const JsonReader& point : reader.elements()) {
        const std::vector<double> txyz = point.numbers(4);
        path.push_back({txyz[0], {txyz[1], txyz[2], txyz[3]}});
    }
    return path;
}

NodeSelection selectionFromJson(const JsonReader& reader) {
    reader.allowOnly({"nodes", "ellipsoid"});
    NodeSelection selection;
    if (!reader.json().is_object()) return selection;
    if (!reader.has("nodes") && !reader.has("ellipsoid"))
        reader.addProblem("must name nodes, an ellipsoid or both");
    if (reader.has("nodes")) selection.nodes = nodesFromJson(reader.member("nodes"));
    if (reader.has("ellipsoid")) selection.ellipsoid = ellipsoidFromJson(reader.member("ellipsoid"));
    return selection;
}

TetherRule tetherFromJson(const JsonReader& reader) {
    reader.allowOnly({"every", "spring_constant", "viscosity"});
    if (!reader.json().is_object()) return {};
    return {nodeFromJson(reader.member("every")), reader.member("spring_constant").number(),
            reader.member("viscosity").number()};
}

NodeForce forceFromJson(const JsonReader& reader, double duration) {
    reader.allowOnly({"node", "force", "from", "to"});
    if (!reader.json().is_object()) return {0, Eigen::Vector3d::Zero(), 0, 0};
    return {nodeFromJson(reader.member("node")), reader.member("force").vector(),
            reader.has("from") ? reader.member("from").number() : 0,
            reader.has("to") ? reader.member("to").number() : duration};
}

NodeMove moveFromJson(const JsonReader& reader) {
    reader.allowOnly({"node", "path"});
    if (!reader.json().is_object()) return {};
    return {nodeFromJson(reader.member("node")), pathFromJson(reader.member("path"))};
}

Collider colliderFromJson(const JsonReader& reader) {
    const JsonReader shape = reader.member("shape");
    const Json& named = shape.json();
    if (named == "capsule")
        return Capsule{reader.member("radius").number(), reader.member("length").number()};
    if (named == "jaws" || named == "mesh")
        shape.addProblem(named.dump() + " is not offered yet; use \"sphere\" or \"capsule\"");
    else if (!named.is_null() && named != "sphere")
        shape.addProblem("must be \"sphere\" or \"capsule\"");
    if (named == "sphere" && reader.has("length"))
        reader.member("length").addProblem("is for a capsule; leave it out of a sphere");
    return Sphere{reader.member("radius").number()};
}

/// A quaternion w, x, y, z of any length, of length 1; one that is so already keeps its bits.
Eigen::Quaterniond turnFromJson(const JsonReader& row, const std::vector<double>& numbers) {
    constexpr double rounding = 1e-15;
    const Eigen::Vector4d wxyz(numbers[4], numbers[5], numbers[6], numbers[7]);
    const double length = wxyz.stableNorm();
    if (!(length > 0)) {
        if (row.json().is_array() && row.json().size() == numbers.size())
            row.addProblem("has a zero quaternion, which turns nowhere; give 1, 0, 0, 0 for no turn");
        return Eigen::Quaterniond::Identity();
    }
    const Eigen::Vector4d unit = std::abs(length - 1) <= rounding ? wxyz : Eigen::Vector4d(wxyz / length);
    return {unit[0], unit[1], unit[2], unit[3]};
}

/// Rows of four or of eight numbers. What the first row has, all must have.
void posesFromJson(const JsonReader& reader, InstrumentMotion& instrument) {
    constexpr std::size_t turned = 8;
    const std::vector<JsonReader> rows = reader.elements();
    const bool turns = !rows.empty() && rows.front().json().size() == turned;
    for (const JsonReader& row : rows) {
        if (row.json().is_array() && (row.json().size() == turned) != turns &&
            (row.json().size() == turned || row.json().size() == 4)) {
            row.addProblem(turns ? "has no orientation, but the path's first row has one; give all or none"
                                 : "has an orientation, but the path's first row has none; give all or none");
            continue;
        }
        const std::vector<double> numbers = row.numbers(turns ? turned : 4);
        instrument.path.push_back({numbers[0], {numbers[1], numbers[2], numbers[3]}});
        if (turns) instrument.orientations.push_back(turnFromJson(row, numbers));
    }
}

InstrumentMotion instrumentFromJson(const JsonReader& reader) {
    reader.allowOnly({"name", "shape", "radius", "length", "path"});
    if (!reader.json().is_object()) return {};
    InstrumentMotion instrument{colliderFromJson(reader), {}, {}, {}};
    posesFromJson(reader.member("path"), instrument);
    if (!reader.has("name")) return instrument;
    instrument.name = reader.member("name").text();
    if (instrument.name.empty() && reader.member("name").json().is_string())
        reader.member("name").addProblem("is empty; leave it out for \"instrument 0\" and so on");
    return instrument;
}

Recording recordingFromJson(const JsonReader& reader) {
    reader.allowOnly({"every", "nodes"});
    Recording record;
    if (reader.has("every")) record.every = reader.member("every").number();
    if (!reader.has("nodes") || reader.member("nodes").json() == "all") return record;
    if (reader.member("nodes").json().is_string())
        reader.member("nodes").addProblem("must be \"all\" or a list of nodes");
    else
        record.nodes = nodesFromJson(reader.member("nodes"));
    return record;
}

template<class Entry, class Read>
std::vector<Entry> list(const JsonReader& reader, const char* key, Read read) {
    std::vector<Entry> entries;
    if (reader.has(key))
        for (const JsonReader& element : reader.member(key).elements())
            entries.push_back(read(element));
    return entries;
}

Scene sceneFromMembers(const JsonReader& reader) {
    Scene scene;
    scene.duration = reader.member("duration").number();
    if (reader.has("gravity")) scene.gravity = reader.member("gravity").vector();
    scene.fixed = list<NodeSelection>(reader, "fixed", selectionFromJson);
    scene.tethers = list<TetherRule>(reader, "tethers", tetherFromJson);
    scene.forces = list<NodeForce>(
        reader, "forces", [&](const JsonReader& force) { return forceFromJson(force, scene.duration); });
    scene.moves = list<NodeMove>(reader, "moves", moveFromJson);
    if (reader.has("instrument") && reader.has("instruments"))
        reader.member("instrument").addProblem("and instruments are there; put all into instruments");
    if (reader.has("instrument"))
        scene.instruments = {instrumentFromJson(reader.member("instrument"))};
    else
        scene.instruments = list<InstrumentMotion>(reader, "instruments", instrumentFromJson);
    if (reader.has("record")) scene.record = recordingFromJson(reader.member("record"));
    return scene;
}

/// A value that could not be read stands in the scene as a harmless default, of which nothing more is said.
bool speaksOfUnread(const std::string& problem, const std::vector<std::string>& unread) {
    const std::string place = problem.substr(0, problem.find(": "));
    return std::any_of(unread.begin(), unread.end(),
                       [&](const std::string& text) { return text.compare(0, place.size(), place) == 0; });
}

Json toJson(const Path& path) {
    Json json = Json::array();
    for (const PathPoint& point : path)
        json.push_back({point.time, point.value.x(), point.value.y(), point.value.z()});
    return json;
}

Json toJson(const NodeSelection& selection) {
    Json json{{"nodes", selection.nodes}};
    if (selection.ellipsoid) json["ellipsoid"] = toJson(*selection.ellipsoid);
    return json;
}

Json toJson(const TetherRule& rule) {
    return {{"every", rule.every}, {"spring_constant", rule.springConstant}, {"viscosity", rule.viscosity}};
}

Json toJson(const NodeForce& force) {
    return {
        {"node", force.node}, {"force", vectorToJson(force.force)}, {"from", force.from}, {"to", force.to}};
}

Json toJson(const NodeMove& move) {
    return {{"node", move.node}, {"path", toJson(move.path)}};
}

Json toJson(const InstrumentMotion& instrument) {
    const auto* capsule = std::get_if<Capsule>(&instrument.shape);
    Json json = Json::object();
    if (!instrument.name.empty()) json["name"] = instrument.name;
    json["shape"] = capsule ? "capsule" : "sphere";
    json["radius"] = radiusOf(instrument.shape);
    if (capsule) json["length"] = capsule->length;
    json["path"] = toJson(instrument.path);
    for (std::size_t i = 0; i < instrument.orientations.size(); ++i)
        for (const double number : {instrument.orientations[i].w(), instrument.orientations[i].x(),
                                    instrument.orientations[i].y(), instrument.orientations[i].z()})
            json["path"][i].push_back(number);
    return json;
}

template<class Entry> void addList(Json& json, const char* key, const std::vector<Entry>& entries) {
    for (const Entry& entry : entries)
        json[key].push_back(toJson(entry));
}

} // namespace

Scene sceneFromJson(const Json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    reader.allowOnly({"duration", "gravity", "fixed", "tethers", "forces", "moves", "instrument",
                      "instruments", "record"});
    if (!json.is_object()) throw InvalidModel(problems);
    Scene scene = sceneFromMembers(reader);

    const std::vector<std::string> unread = problems;
    for (const std::string& problem : validate(scene, std::numeric_limits<std::size_t>::max()))
        if (!speaksOfUnread(problem, unread)) problems.push_back(problem);
    if (!problems.empty()) throw InvalidModel(problems);
    return scene;
}

Json toJson(const Scene& scene) {
    Json json{{"duration", scene.duration}, {"gravity", vectorToJson(scene.gravity)}};
    addList(json, "fixed", scene.fixed);
    addList(json, "tethers", scene.tethers);
    addList(json, "forces", scene.forces);
    addList(json, "moves", scene.moves);
    if (!hasPlainInstrument(scene))
        addList(json, "instruments", scene.instruments);
    else if (!scene.instruments.empty())
        json["instrument"] = toJson(scene.instruments.front());
    json["record"]["every"] = scene.record.every;
    json["record"]["nodes"] = scene.record.nodes ? Json(*scene.record.nodes) : Json("all");
    return json;
}

Scene readSceneFile(const std::filesystem::path& file) {
    const Json json = readJsonFile(file);
    try {
        return sceneFromJson(json);
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
}

} // namespace esm
