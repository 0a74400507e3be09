#include "core/exchange/projector_file.h"

#include "core/exchange/json_reader.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* parallelOnly = "this version places photos by parallel projection only; give \"kind\": "
                                     "\"parallel\" with width and height";

/// Largest deviation of a rotation's columns from unit length and right angles.
constexpr double rotationTolerance = 1e-6;

bool isFiniteNumber(const Json& value) {
    return value.is_number() && std::isfinite(value.get<double>());
}

bool isRigid(const Eigen::Matrix4d& matrix) {
    const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
    const Eigen::Matrix3d deviation = rotation.transpose() * rotation - Eigen::Matrix3d::Identity();
    return deviation.cwiseAbs().maxCoeff() <= rotationTolerance && rotation.determinant() > 0 &&
           matrix.row(3) == Eigen::RowVector4d(0, 0, 0, 1);
}

/// Reads key by key and gathers what is wrong.
struct ProjectorReader {
    const Json& json;
    std::vector<std::string> problems;

    const Json* find(const char* key) const {
        const auto found = json.find(key);
        return found == json.end() ? nullptr : &*found;
    }
    void readPose(Eigen::Isometry3d& pose);
    void readLength(const char* key, double& length);
    bool readKind(); ///< true unless it is a perspective one, which has no width and height
    void readOcclusion(bool& occlusion);
    void refuseOtherKeys();
};

void ProjectorReader::readPose(Eigen::Isometry3d& pose) {
    const Json* value = find("pose");
    bool numbers = value && value->is_array() && value->size() == 16;
    for (std::size_t i = 0; numbers && i < 16; ++i)
        numbers = isFiniteNumber((*value)[i]);
    if (!numbers) {
        problems.push_back(
            "\"pose\" must be 16 numbers, row by row, that take the projector's space to the model's");
        return;
    }
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i)
        matrix(i / 4, i % 4) = (*value)[static_cast<std::size_t>(i)].get<double>();
    if (isRigid(matrix))
        pose.matrix() = matrix;
    else
        problems.push_back(
            "\"pose\" must be a rotation and a shift, without scaling, shearing or mirroring and with "
            "0 0 0 1 as its last row; give the photo's size as width and height");
}

void ProjectorReader::readLength(const char* key, double& length) {
    const Json* value = find(key);
    if (value && isFiniteNumber(*value) && value->get<double>() > 0)
        length = value->get<double>();
    else
        problems.push_back("\"" + std::string(key) + "\" must be a length in metres above 0");
}

bool ProjectorReader::readKind() {
    const Json* kind = find("kind");
    const bool named = kind && kind->is_string();
    const bool perspective = (named && *kind == "perspective") || find("fov") || find("intrinsics");
    if (perspective)
        problems.emplace_back(parallelOnly);
    else if (kind && *kind != "parallel")
        problems.push_back("\"kind\" must be \"parallel\"");
    return !perspective;
}

void ProjectorReader::readOcclusion(bool& occlusion) {
    const Json* value = find("occlusion");
    if (!value) return;
    if (value->is_boolean())
        occlusion = value->get<bool>();
    else
        problems.push_back("\"occlusion\" must be true or false");
}

void ProjectorReader::refuseOtherKeys() {
    static const std::set<std::string> known{"pose", "width",      "height",   "kind",
                                             "fov",  "intrinsics", "occlusion"};
    for (const auto& [key, value] : json.items())
        if (known.count(key) == 0)
            problems.push_back("\"" + key + "\" is not known; remove it or correct its name");
}

} // namespace

Projector projectorFromJson(const Json& json) {
    if (!json.is_object()) throw InvalidModel("a projector must be a JSON object { … }");
    Projector projector;
    ProjectorReader reader{json, {}};
    reader.readPose(projector.pose);
    if (reader.readKind()) {
        reader.readLength("width", projector.width);
        reader.readLength("height", projector.height);
    }
    reader.readOcclusion(projector.occlusion);
    reader.refuseOtherKeys();
    if (!reader.problems.empty()) throw InvalidModel(reader.problems);
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
    const Bytes content = readFile(file);
    try {
        const char* begin = reinterpret_cast<const char*>(content.data());
        return projectorFromJson(parseJson(begin, begin + content.size()));
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
}

} // namespace esm
