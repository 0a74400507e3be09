#include "core/dynamics/given_loads.h"

#include "core/support/errors.h"

#include <cmath>
#include <string>

namespace esm {

namespace {

bool isLength(double length) {
    return length >= 0 && std::isfinite(length);
}

Eigen::Quaterniond quaternionOf(const std::array<double, 4>& numbers) {
    const auto& [w, x, y, z] = numbers;
    if (w == 0 && x == 0 && y == 0 && z == 0) return Eigen::Quaterniond::Identity();
    return {w, x, y, z};
}

} // namespace

Eigen::Vector3d givenVector(const char* what, std::int64_t node, const Eigen::Vector3d& vector,
                            std::size_t nodeCount) {
    if (node < 0 || static_cast<std::uint64_t>(node) >= nodeCount)
        throw InvalidModel(std::string("a ") + what + " is for node " + std::to_string(node) +
                           ", but there are " + std::to_string(nodeCount));
    if (!vector.allFinite())
        throw InvalidModel(std::string("the ") + what + " for node " + std::to_string(node) +
                           " is not finite");
    return vector;
}

Eigen::Vector3d givenGravity(const Eigen::Vector3d& gravity) {
    if (!gravity.allFinite()) throw InvalidModel("gravity is not finite");
    return gravity;
}

PlacedCollider givenInstrument(std::size_t number, const GivenInstrument& instrument) {
    const auto require = [&](bool isMet, const char* need) {
        if (!isMet) throw InvalidModel("instrument " + std::to_string(number) + ": " + need);
    };
    const Eigen::Quaterniond turn = quaternionOf(instrument.orientation);
    require(isLength(instrument.radius) && instrument.radius > 0, "its radius must be above 0, and finite");
    require(isLength(instrument.length), "its length must be 0 or more, and finite");
    require(instrument.place.allFinite(), "its place must be finite");
    require(std::isnormal(turn.squaredNorm()), "its orientation must be a quaternion of finite numbers");
    const ColliderPose pose{instrument.place, turn.normalized()};
    if (instrument.length > 0) return {Capsule{instrument.radius, instrument.length}, pose};
    return {Sphere{instrument.radius}, pose};
}

} // namespace esm
