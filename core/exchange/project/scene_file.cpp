#include "core/exchange/project/scene_file.h"

#include "core/exchange/project/ellipsoid_json.h"
#include "core/exchange/tissue_json.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

Collider colliderFromJson(const JsonReader& reader) {
    const JsonReader shape = reader.member("shape");
    const Json& named = shape.json();
    if (named == "capsule") return valueFrom<Capsule>(reader);
    if (named == "jaws" || named == "mesh")
        shape.addProblem(named.dump() + " is not offered yet; use \"sphere\" or \"capsule\"");
    else if (!named.is_null() && named != "sphere")
        shape.addProblem("must be \"sphere\" or \"capsule\"");
    if (named == "sphere" && reader.has("length"))
        reader.member("length").addProblem("is for a capsule; leave it out of a sphere");
    return valueFrom<Sphere>(reader);
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

/// What stands in a scene otherwise than as a list of members.
struct SceneForms : TypedForms {
    Json write(const PathPoint& point) const {
        return {point.time, point.value.x(), point.value.y(), point.value.z()};
    }
    void read(const JsonReader& reader, PathPoint& point) const {
        const std::vector<double> txyz = reader.numbers(4);
        point = {txyz[0], {txyz[1], txyz[2], txyz[3]}};
    }

    Json write(const std::pair<std::uint32_t, std::uint32_t>& edge) const {
        return {edge.first, edge.second};
    }
    void read(const JsonReader& reader, std::pair<std::uint32_t, std::uint32_t>& edge) const {
        std::vector<std::uint32_t> ends;
        readValue(reader, ends, *this);
        if (ends.size() == 2)
            edge = {ends[0], ends[1]};
        else if (reader.json().is_array())
            reader.addProblem("must be the two nodes of an edge");
    }

    void read(const JsonReader& reader, NodeSelection& selection) const {
        readFields(reader, selection, *this);
        if (reader.json().is_object() && !reader.has("nodes") && !reader.has("ellipsoid"))
            reader.addProblem("must name nodes, an ellipsoid or both");
    }

    Json write(const std::optional<std::vector<std::uint32_t>>& nodes) const {
        return nodes ? Json(*nodes) : Json("all");
    }
    void read(const JsonReader& reader, std::optional<std::vector<std::uint32_t>>& nodes) const {
        if (reader.json() == "all") return;
        if (reader.json().is_string())
            reader.addProblem("must be \"all\" or a list of nodes");
        else
            readValue(reader, nodes.emplace(), *this);
    }
};

/// Forces act as long as the scene lasts, unless they say otherwise.
struct SceneReading : SceneForms {
    const Scene& scene;

    using SceneForms::read;
    void read(const JsonReader& reader, NodeForce& force) const {
        force.to = scene.duration;
        readFields(reader, force, SceneForms());
    }
};

void readInstruments(const JsonReader& reader, Scene& scene) {
    if (reader.has("instrument") && reader.has("instruments"))
        reader.member("instrument").addProblem("and instruments are there; put all into instruments");
    if (reader.has("instrument"))
        scene.instruments = {instrumentFromJson(reader.member("instrument"))};
    else if (reader.has("instruments"))
        for (const JsonReader& instrument : reader.member("instruments").elements())
            scene.instruments.push_back(instrumentFromJson(instrument));
}

/// A value that could not be read stands in the scene as a harmless default, of which nothing more is said.
bool speaksOfUnread(const std::string& problem, const std::vector<std::string>& unread) {
    const std::string place = problem.substr(0, problem.find_first_of(": "));
    return std::any_of(unread.begin(), unread.end(),
                       [&](const std::string& text) { return text.compare(0, place.size(), place) == 0; });
}

Json instrumentToJson(const InstrumentMotion& instrument) {
    Json json = Json::object();
    if (!instrument.name.empty()) json["name"] = instrument.name;
    json["shape"] = std::holds_alternative<Capsule>(instrument.shape) ? "capsule" : "sphere";
    json.update(std::visit([](const auto& shape) { return writtenFields(shape); }, instrument.shape));
    json["path"] = written(instrument.path, SceneForms());
    for (std::size_t i = 0; i < instrument.orientations.size(); ++i)
        for (const double number : {instrument.orientations[i].w(), instrument.orientations[i].x(),
                                    instrument.orientations[i].y(), instrument.orientations[i].z()})
            json["path"][i].push_back(number);
    return json;
}

} // namespace

Scene sceneFromJson(const Json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    std::vector<std::string> keys = keysOf(fieldsOf<Scene>);
    keys.insert(keys.end(), {"instrument", "instruments"});
    reader.allowOnly(keys);
    if (!json.is_object()) throw InvalidModel(problems);
    Scene scene;
    readMembers(reader, scene, SceneReading{{}, scene}, fieldsOf<Scene>);
    readInstruments(reader, scene);

    const std::vector<std::string> unread = problems;
    for (const std::string& problem : validate(scene, std::numeric_limits<std::size_t>::max()))
        if (!speaksOfUnread(problem, unread)) problems.push_back(problem);
    if (!problems.empty()) throw InvalidModel(problems);
    return scene;
}

Json toJson(const Scene& scene) {
    Json json = writtenFields(scene, SceneForms());
    Json record = std::move(json["record"]);
    json.erase("record"); // it always was the last
    if (!hasPlainInstrument(scene))
        for (const InstrumentMotion& instrument : scene.instruments)
            json["instruments"].push_back(instrumentToJson(instrument));
    else if (!scene.instruments.empty())
        json["instrument"] = instrumentToJson(scene.instruments.front());
    json["record"] = std::move(record);
    return json;
}

Scene readScene(const JsonReader& reader) {
    if (reader.json().is_null()) return {};
    try {
        return sceneFromJson(reader.json());
    } catch (const InvalidModel& error) {
        for (const std::string& problem : error.problems())
            reader.addProblem("is not usable: " + problem);
        return {};
    }
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
