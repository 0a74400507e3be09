#include "core/exchange/project/rigid_pose.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct ReadPose {
    Pose pose;
    std::vector<std::string> problems;
};

ReadPose poseFrom(const Eigen::Matrix4d& matrix) {
    nlohmann::ordered_json json;
    for (int i = 0; i < 16; ++i)
        json.push_back(matrix(i / 4, i % 4));
    ReadPose result;
    fromJson({json, "pose", result.problems}, result.pose);
    return result;
}

Eigen::Isometry3d somePose() {
    return Eigen::Translation3d(0.1, -0.2, 1.0 / 3) *
           Eigen::AngleAxisd(1.234, Eigen::Vector3d(1, 2, 3).normalized());
}

TEST(RigidPose, StaysBitByBitWhereItIsARotationButForRounding) {
    const ReadPose read = poseFrom(somePose().matrix());
    EXPECT_THAT(read.problems, ElementsAre());
    EXPECT_EQ(read.pose.matrix(), somePose().matrix());
}

TEST(RigidPose, OfFiveDigitsIsTurnedToTheNearestRotation) {
    const Eigen::Matrix4d typed = (somePose().matrix() * 1e5).array().round() / 1e5;
    const ReadPose read = poseFrom(typed);
    EXPECT_THAT(read.problems, ElementsAre());
    EXPECT_TRUE(read.pose.linear().isUnitary(1e-14));
    EXPECT_LT((read.pose.matrix() - somePose().matrix()).cwiseAbs().maxCoeff(), 2e-5);
    EXPECT_EQ(read.pose.translation(), Eigen::Vector3d(typed.topRightCorner<3, 1>()));
}

TEST(RigidPose, ThatIsNoneIsAProblem) {
    Eigen::Matrix4d pose = somePose().matrix();
    pose.topLeftCorner<3, 3>() *= 1.001;
    EXPECT_THAT(poseFrom(pose).problems, ElementsAre(HasSubstr("scaling")));
    pose = somePose().matrix();
    pose.col(1) += 0.01 * pose.col(0);
    EXPECT_THAT(poseFrom(pose).problems, ElementsAre(HasSubstr("shearing")));
    pose = somePose().matrix();
    pose.col(2) *= -1;
    EXPECT_THAT(poseFrom(pose).problems, ElementsAre(HasSubstr("mirroring")));
    pose = somePose().matrix();
    pose(3, 3) = 2;
    EXPECT_THAT(poseFrom(pose).problems, ElementsAre(HasSubstr("last row")));
    EXPECT_TRUE(poseFrom(pose).pose.isApprox(Eigen::Isometry3d::Identity()));
}

} // namespace
} // namespace esm
