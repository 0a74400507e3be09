#include "core/exchange/project/rigid_pose.h"

#include <Eigen/SVD>

namespace esm {

namespace {

/// Largest deviation of the axes' lengths and right angles; numbers of five digits keep within it.
constexpr double poseTolerance = 1e-4;

/// Below this a deviation is rounding in double precision.
constexpr double poseRounding = 1e-9;

double deviationFromRigid(const Eigen::Matrix3d& turn) {
    return (turn.transpose() * turn - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

bool isNearlyRigid(const Eigen::Matrix4d& pose) {
    const Eigen::Matrix3d turn = pose.topLeftCorner<3, 3>();
    return pose.allFinite() && deviationFromRigid(turn) <= poseTolerance && turn.determinant() > 0 &&
           pose.row(3) == Eigen::RowVector4d(0, 0, 0, 1);
}

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d& turn) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.matrixV().transpose();
}

} // namespace

nlohmann::ordered_json toJson(const Pose& pose) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (int i = 0; i < 16; ++i)
        json.push_back(pose.matrix()(i / 4, i % 4));
    return json;
}

void fromJson(const JsonReader& reader, Pose& pose) {
    const std::vector<double> numbers = reader.numbers(16);
    pose = Pose::Identity();
    if (!reader.json().is_array() || reader.json().size() != numbers.size()) return;
    const Eigen::Matrix4d matrix =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
    if (!isNearlyRigid(matrix)) {
        reader.addProblem(
            "must be a rotation and a shift, without scaling, shearing or mirroring and with 0 0 0 1 "
            "as its last row");
        return;
    }
    pose.matrix() = matrix;
    if (deviationFromRigid(pose.linear()) > poseRounding) pose.linear() = nearestRotation(pose.linear());
}

} // namespace esm
