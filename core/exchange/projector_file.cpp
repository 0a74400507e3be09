#include "core/exchange/projector_file.h"

#include "core/exchange/json_reader.h"
#include "core/exchange/rigid_pose.h"
#include "core/support/errors.h"
#include "core/texture/texture_limits.h"

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

/// A perspective projector has no width and height to ask for.
bool isPerspective(const JsonReader& reader) {
    const bool named = reader.has("kind") && reader.member("kind").json() == "perspective";
    return named || reader.has("fov") || reader.has("intrinsics");
}

void requireParallel(const JsonReader& reader) {
    if (isPerspective(reader))
        reader.addProblem("places a photo in perspective; this version places photos by parallel projection "
                          "only; give \"kind\": \"parallel\" with width and height");
    else if (reader.has("kind") && reader.member("kind").json() != "parallel")
        reader.member("kind").addProblem("must be \"parallel\"");
}

} // namespace

Projector projectorFromJson(const JsonReader& reader) {
    reader.allowOnly({"pose", "width", "height", "kind", "fov", "intrinsics", "occlusion"});
    Projector projector;
    if (!reader.json().is_object()) return projector;
    projector.pose = rigidPoseFromJson(reader.member("pose"));
    requireParallel(reader);
    if (!isPerspective(reader)) {
        projector.width = photoLengthFromJson(reader.member("width"));
        projector.height = photoLengthFromJson(reader.member("height"));
    }
    if (reader.has("occlusion")) projector.occlusion = reader.member("occlusion").flag();
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
    return {{"pose", pose},
            {"width", projector.width},
            {"height", projector.height},
            {"kind", "parallel"},
            {"occlusion", projector.occlusion}};
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
