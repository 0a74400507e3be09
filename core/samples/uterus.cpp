#include "core/model/motion_model.h"
#include "core/samples/organs.h"

namespace esm {

Project makeUterus() {
    Project project = makeProject("Uterus", asImported({}), 0.500);
    project.network = std::make_shared<const SpringNetwork>(
        motionModel(Eigen::Vector3d::Zero(), 0.07 * Eigen::Vector3d::UnitY()));
    project.regions = {fuzzyRegion("Uterus", "susilap-g", {{"consistency", 10.1}})};
    project.scene.duration = 1.5;
    project.scene.fixed.push_back({{motionModelFixed.begin(), motionModelFixed.end()}, std::nullopt});
    project.scene.forces.push_back({0, {0, 0, -0.3}, 0, 0.5});
    return project;
}

} // namespace esm
