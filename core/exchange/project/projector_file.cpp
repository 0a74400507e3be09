#include "core/exchange/project/projector_file.h"

#include "core/exchange/project/rigid_pose.h"
#include "core/support/errors.h"
#include "core/support/json_reader.h"
#include "core/texture/texture_limits.h"

#include <cmath>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

double photoLengthFromJson(const JsonReader& reader) {
    const double length = reader.number();
    const bool possible = length >= texture_limits::shortestPhoto && length <= texture_limits::longestPhoto;
    if (reader.json().is_number() && !possible)
        reader.addProblem("must be a length from 1e-6 to 1000 metres");
    return length;
}

/// Perspective is a matter of course where a field of view or intrinsics are given.
ProjectorKind kindFromJson(const JsonReader& reader) {
    const bool isSeen = reader.has("fov") || reader.has("intrinsics");
    if (!reader.has("kind")) return isSeen ? ProjectorKind::Perspective : ProjectorKind::Parallel;
    const JsonReader kind = reader.member("kind");
    if (kind.json() == "perspective") return ProjectorKind::Perspective;
    if (kind.json() != "parallel")
        kind.addProblem("must be \"parallel\" or \"perspective\"");
    else
        for (const char* key : {"fov", "intrinsics"})
            if (reader.has(key))
                reader.member(key).addProblem("belongs to a perspective projector; leave it away");
    return ProjectorKind::Parallel;
}

double fieldOfViewFromJson(const JsonReader& reader) {
    const double degrees = reader.number();
    const bool possible = degrees >= texture_limits::narrowestView && degrees <= texture_limits::widestView;
    if (reader.json().is_number() && !possible) reader.addProblem("must lie between 0.1 and 170 degrees");
    return degrees;
}

double focalLengthFromJson(const JsonReader& reader) {
    const double length = reader.number();
    const bool possible = length > 0 && length <= texture_limits::longestFocalLength;
    if (reader.json().is_number() && !possible)
        reader.addProblem("must be above 0 and at most 1e7 photo pixels");
    return length;
}

double principalPointFromJson(const JsonReader& reader) {
    const double place = reader.number();
    if (std::abs(place) > texture_limits::longestFocalLength)
        reader.addProblem("must be within 1e7 photo pixels");
    return place;
}

Intrinsics intrinsicsFromJson(const JsonReader& reader) {
    reader.allowOnly({"fx", "fy", "cx", "cy"});
    if (!reader.json().is_object()) return {1, 1, 0, 0};
    return {focalLengthFromJson(reader.member("fx")), focalLengthFromJson(reader.member("fy")),
            principalPointFromJson(reader.member("cx")), principalPointFromJson(reader.member("cy"))};
}

void readCamera(const JsonReader& reader, Projector& projector) {
    const bool hasIntrinsics = reader.has("intrinsics");
    if (hasIntrinsics && reader.has("fov"))
        reader.member("intrinsics").addProblem("stands in place of a field of view; leave one of them away");
    else if (hasIntrinsics)
        projector.intrinsics = intrinsicsFromJson(reader.member("intrinsics"));
    else
        projector.fieldOfView = fieldOfViewFromJson(reader.member("fov"));
}

Json toJson(const Intrinsics& camera) {
    return {{"fx", camera.fx}, {"fy", camera.fy}, {"cx", camera.cx}, {"cy", camera.cy}};
}

} // namespace

Projector projectorFromJson(const JsonReader& reader) {
    reader.allowOnly({"pose", "width", "height", "kind", "fov", "intrinsics", "occlusion", "falloff"});
    Projector projector;
    if (!reader.json().is_object()) return projector;
    projector.pose = rigidPoseFromJson(reader.member("pose"));
    projector.kind = kindFromJson(reader);
    if (projector.kind == ProjectorKind::Perspective) {
        readCamera(reader, projector);
    } else if (!reader.has("fov") && !reader.has("intrinsics")) {
        projector.width = photoLengthFromJson(reader.member("width"));
        projector.height = photoLengthFromJson(reader.member("height"));
    }
    if (reader.has("occlusion")) projector.occlusion = reader.member("occlusion").flag();
    if (reader.has("falloff")) projector.falloff = reader.member("falloff").flag();
    return projector;
}

Projector projectorFromJson(const Json& json) {
    std::vector<std::string> problems;
    Projector projector = projectorFromJson(JsonReader(json, "", problems));
    if (!problems.empty()) throw InvalidModel(problems);
    return projector;
}

Json toJson(const Projector& projector) {
    Json pose = Json::array();
    for (int i = 0; i < 16; ++i)
        pose.push_back(projector.pose.matrix()(i / 4, i % 4));
    Json json{{"pose", pose}};
    if (projector.kind == ProjectorKind::Parallel) {
        json["width"] = projector.width;
        json["height"] = projector.height;
        json["kind"] = "parallel";
    } else {
        json["kind"] = "perspective";
        if (projector.intrinsics)
            json["intrinsics"] = toJson(*projector.intrinsics);
        else
            json["fov"] = projector.fieldOfView;
    }
    json["occlusion"] = projector.occlusion;
    if (projector.falloff) json["falloff"] = true;
    return json;
}

Projector readProjectorFile(const std::filesystem::path& file) {
    const Json json = readJsonFile(file);
    try {
        return projectorFromJson(json);
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
}

} // namespace esm
