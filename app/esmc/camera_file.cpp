#include "app/esmc/camera_file.h"

#include "core/exchange/project/projector_file.h"
#include "core/support/errors.h"

namespace esm {

namespace {

/// A camera is perspective without saying so.
Projector perspectiveFrom(const nlohmann::ordered_json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    nlohmann::ordered_json asProjector = json;
    if (json.is_object() && reader.has("kind") && json["kind"] != "perspective")
        reader.member("kind").addProblem("must be \"perspective\" for a camera");
    if (json.is_object()) asProjector["kind"] = "perspective";
    Projector projector = projectorFromJson(JsonReader(asProjector, "", problems));
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    return projector;
}

} // namespace

Camera readCameraFile(const std::filesystem::path& file, PhotoSize picture) {
    const nlohmann::ordered_json json = readJsonFile(file);
    try {
        return cameraOf(perspectiveFrom(json), picture);
    } catch (const InvalidModel& problem) {
        throw FileError(file, problem.what());
    }
}

} // namespace esm
