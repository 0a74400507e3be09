#include "app/esmc/camera_file.h"

#include "core/exchange/json_reader.h"
#include "core/support/angles.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"

namespace esm {

namespace {

using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

/// @param numbers 16, row-major
Eigen::Matrix4d poseFrom(const JsonReader& place, const std::vector<double>& numbers) {
    const Eigen::Matrix4d pose = Eigen::Map<const RowMajor>(numbers.data());
    const Eigen::Matrix3d turn = pose.topLeftCorner<3, 3>();
    if (!(turn * turn.transpose()).isIdentity(1e-4) || turn.determinant() < 0)
        place.addProblem("must turn without mirroring, stretching or shearing");
    if (pose.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) place.addProblem("must end with the row 0, 0, 0, 1");
    return pose;
}

double fieldOfViewFrom(const JsonReader& place) {
    const double degrees = place.number();
    if (degrees < 0.1 || degrees > 170) place.addProblem("must lie between 0.1 and 170 degrees");
    return toRadians(degrees);
}

Camera cameraFrom(const nlohmann::ordered_json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    if (reader.has("kind") && reader.member("kind").text() != "perspective")
        reader.member("kind").addProblem("must be \"perspective\" for a camera");
    const Eigen::Matrix4d pose = poseFrom(reader.member("pose"), reader.member("pose").numbers(16));
    Camera camera;
    camera.verticalFieldOfView = fieldOfViewFrom(reader.member("fov"));
    camera.eye = pose.topRightCorner<3, 1>();
    camera.target = camera.eye - pose.block<3, 1>(0, 2);
    camera.up = pose.block<3, 1>(0, 1);
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    return camera;
}

} // namespace

Camera readCameraFile(const std::filesystem::path& file) {
    const Bytes bytes = readFile(file);
    try {
        const char* begin = reinterpret_cast<const char*>(bytes.data());
        return cameraFrom(parseJson(begin, begin + bytes.size()));
    } catch (const InvalidModel& problem) {
        throw FileError(file, problem.what());
    }
}

} // namespace esm
