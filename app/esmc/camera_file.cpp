#include "app/esmc/camera_file.h"

#include "core/exchange/json_reader.h"
#include "core/exchange/rigid_pose.h"
#include "core/support/angles.h"
#include "core/support/errors.h"

namespace esm {

namespace {

double fieldOfViewFrom(const JsonReader& place) {
    const double degrees = place.number();
    const bool isNumber = place.json().is_number();
    if (isNumber && (degrees < 0.1 || degrees > 170))
        place.addProblem("must lie between 0.1 and 170 degrees");
    return toRadians(degrees);
}

void requirePerspective(const JsonReader& reader) {
    // Width, height and occlusion belong to a projector; they say nothing of a camera.
    reader.allowOnly({"pose", "kind", "fov", "intrinsics", "width", "height", "occlusion"});
    if (reader.has("kind") && reader.member("kind").text() != "perspective")
        reader.member("kind").addProblem("must be \"perspective\" for a camera");
    if (reader.has("intrinsics"))
        reader.member("intrinsics").addProblem("is not read yet; give fov, the vertical degrees, alone");
}

Camera cameraFrom(const nlohmann::ordered_json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    requirePerspective(reader);
    const Eigen::Isometry3d pose = rigidPoseFromJson(reader.member("pose"));
    Camera camera;
    if (reader.has("fov") || !reader.has("intrinsics"))
        camera.verticalFieldOfView = fieldOfViewFrom(reader.member("fov"));
    camera.eye = pose.translation();
    camera.target = camera.eye - pose.linear().col(2);
    camera.up = pose.linear().col(1);
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    return camera;
}

} // namespace

Camera readCameraFile(const std::filesystem::path& file) {
    const nlohmann::ordered_json json = readJsonFile(file);
    try {
        return cameraFrom(json);
    } catch (const InvalidModel& problem) {
        throw FileError(file, problem.what());
    }
}

} // namespace esm
