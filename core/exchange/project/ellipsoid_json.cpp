#include "core/exchange/project/ellipsoid_json.h"

#include "core/support/angles.h"

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

Eigen::Quaterniond orientationFromJson(const JsonReader& reader) {
    if (reader.has("orientation")) {
        if (reader.has("axis") || reader.has("degrees"))
            reader.addProblem("has an orientation and axis with degrees too; leave one out");
        const std::vector<double> q = reader.member("orientation").numbers(4);
        return {q[0], q[1], q[2], q[3]};
    }
    if (!reader.has("axis") && !reader.has("degrees")) return Eigen::Quaterniond::Identity();
    const Eigen::Vector3d axis = reader.member("axis").vector();
    const double degrees = reader.member("degrees").number();
    if (degrees == 0) return Eigen::Quaterniond::Identity();
    if (axis.norm() > 0)
        return Eigen::Quaterniond(Eigen::AngleAxisd(toRadians(degrees), axis.stableNormalized()));
    if (reader.has("axis")) reader.member("axis").addProblem("must have a length, or degrees be 0");
    return Eigen::Quaterniond::Identity();
}

} // namespace

Json vectorToJson(const Eigen::Vector3d& vector) {
    return {vector.x(), vector.y(), vector.z()};
}

Json toJson(const Ellipsoid& ellipsoid) {
    const Eigen::Quaterniond& q = ellipsoid.orientation;
    return {{"centre", vectorToJson(ellipsoid.centre)},
            {"radii", vectorToJson(ellipsoid.radii)},
            {"orientation", {q.w(), q.x(), q.y(), q.z()}}};
}

Ellipsoid ellipsoidFromJson(const JsonReader& reader) {
    reader.allowOnly({"centre", "radii", "axis", "degrees", "orientation"});
    if (!reader.json().is_object()) return {};
    return {reader.member("centre").vector(), reader.member("radii").vector(), orientationFromJson(reader)};
}

} // namespace esm
