#include "core/exchange/project/ellipsoid_json.h"

#include "core/support/angles.h"

namespace esm {

namespace {

struct EllipsoidForms {
    nlohmann::ordered_json write(const Eigen::Quaterniond& turn) const {
        return {turn.w(), turn.x(), turn.y(), turn.z()};
    }
    void read(const JsonReader& reader, Eigen::Quaterniond& turn) const {
        const std::vector<double> q = reader.numbers(4);
        turn = {q[0], q[1], q[2], q[3]};
    }
};

Eigen::Quaterniond turnAboutAxis(const JsonReader& reader) {
    const Eigen::Vector3d axis = reader.member("axis").vector();
    const double degrees = reader.member("degrees").number();
    if (degrees == 0) return Eigen::Quaterniond::Identity();
    if (axis.norm() > 0)
        return Eigen::Quaterniond(Eigen::AngleAxisd(toRadians(degrees), axis.stableNormalized()));
    if (reader.has("axis")) reader.member("axis").addProblem("must have a length, or degrees be 0");
    return Eigen::Quaterniond::Identity();
}

} // namespace

nlohmann::ordered_json toJson(const Ellipsoid& ellipsoid) {
    return writtenFields(ellipsoid, EllipsoidForms());
}

void fromJson(const JsonReader& reader, Ellipsoid& ellipsoid) {
    reader.allowOnly({"centre", "radii", "axis", "degrees", "orientation"});
    if (!reader.json().is_object()) return;
    readFields(reader, ellipsoid, EllipsoidForms());
    if (!reader.has("axis") && !reader.has("degrees")) return;
    if (reader.has("orientation"))
        reader.addProblem("has an orientation and axis with degrees too; leave one out");
    else
        ellipsoid.orientation = turnAboutAxis(reader);
}

} // namespace esm
