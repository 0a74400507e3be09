#include "core/exchange/simulators/mujoco/mujoco_model.h"

#include "core/exchange/project/scene_file.h"
#include "core/exchange/simulators/mujoco/mujoco_skin.h"
#include "core/exchange/simulators/xml_text.h"
#include "core/support/numbers.h"

#include <array>

namespace esm {

namespace {

constexpr std::array axisNames{"x", "y", "z"};

std::string jointName(std::uint32_t node, const char* axis) {
    return mujocoBodyName(node) + axis;
}

void addIfAny(XmlAttributes& attributes, const char* name, double value) {
    if (value != 0) attributes.emplace_back(name, exactText(value));
}

/// m, that springs and nodes are drawn with.
double drawnWidth(const SpringNetwork& network) {
    if (network.springs.empty()) return 0.001;
    double sum = 0;
    for (const Spring& spring : network.springs)
        sum += (network.restPositions[spring.first] - network.restPositions[spring.second]).norm();
    constexpr double share = 0.05, least = 1e-6;
    return std::max(least, share * sum / static_cast<double>(network.springs.size()));
}

/// Springs are drawn where there is no surface; beneath one, the viewer has them in a group that is hidden.
void addMujocoDefaults(const MujocoSubject& subject, XmlText& xml) {
    const std::string width = exactText(drawnWidth(*subject.handover.tissue.network));
    const char* group = subject.handover.project.mesh->triangles.empty() ? "0" : "3";
    xml.open("default", {});
    xml.add("joint", {{"type", "slide"}});
    xml.add("site", {{"group", group}, {"size", width}});
    xml.add("tendon", {{"group", group}, {"width", width}});
    for (std::size_t axis = 0; axis < axisNames.size(); ++axis) {
        const Eigen::Vector3d direction = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis));
        xml.open("default", {{"class", axisNames[axis]}});
        xml.add("joint", {{"axis", spaced(direction)}});
        xml.close();
    }
    xml.close();
}

/// By node, what all its tethers come to.
std::vector<Tether> tetherSums(const SpringSystem& system) {
    std::vector<Tether> sums(system.mass.size(), Tether{});
    for (const Tether& tether : system.tethers) {
        sums[tether.node].springConstant += tether.springConstant;
        sums[tether.node].viscosity += tether.viscosity;
    }
    return sums;
}

void addSlideJoints(const MujocoSubject& subject, std::uint32_t node, const Tether& tether, XmlText& xml) {
    for (const char* axis : axisNames) {
        XmlAttributes attributes{{"name", jointName(node, axis)}, {"class", axis}};
        addIfAny(attributes, "armature", subject.step.armature[node]);
        addIfAny(attributes, "stiffness", tether.springConstant);
        addIfAny(attributes, "damping", tether.viscosity);
        xml.add("joint", attributes);
    }
}

/// A body must resist turning, though one that only slides never turns.
void addNodeBody(const MujocoSubject& subject, std::uint32_t node, const Tether& tether, XmlText& xml) {
    constexpr const char* anyInertia = "1e-9 1e-9 1e-9";
    XmlAttributes body{{"name", mujocoBodyName(node)},
                       {"pos", spaced(subject.system.network->restPositions[node])}};
    if (subject.led[node]) body.emplace_back("mocap", "true");
    xml.open("body", body);
    xml.add("inertial",
            {{"pos", "0 0 0"}, {"mass", exactText(subject.system.mass[node])}, {"diaginertia", anyInertia}});
    if (!subject.still[node]) addSlideJoints(subject, node, tether, xml);
    xml.add("site", {{"name", mujocoBodyName(node)}});
    xml.close();
}

void addNodeBodies(const MujocoSubject& subject, XmlText& xml) {
    const std::vector<Tether> tethers = tetherSums(subject.system);
    xml.open("worldbody", {});
    for (std::uint32_t node = 0; node < tethers.size(); ++node)
        addNodeBody(subject, node, tethers[node], xml);
    xml.close();
}

void addSpatialTendon(const SpringSystem::Element& spring, const XmlAttributes& attributes, XmlText& xml) {
    xml.open("spatial", attributes);
    for (const std::uint32_t node : {spring.first, spring.second})
        xml.add("site", {{"site", mujocoBodyName(node)}});
    xml.close();
}

/// Beyond its strain a biphasic spring has another one beside it, which is slack until then.
void addSpringTendons(const MujocoSubject& subject, std::size_t number, XmlText& xml) {
    const SpringSystem::Element& spring = subject.system.springs[number];
    const std::string name = "spring" + std::to_string(number);
    XmlAttributes attributes{{"name", name}, {"springlength", exactText(spring.restLength)}};
    addIfAny(attributes, "stiffness", spring.springConstant);
    if (subject.damping == Damping::Axial) addIfAny(attributes, "damping", spring.viscosity);
    addSpatialTendon(spring, attributes, xml);
    if (spring.secondPhase.isLinear()) return;
    const double slackUntil = (1 + spring.secondPhase.strain) * spring.restLength;
    addSpatialTendon(spring,
                     {{"name", name + "beyond"},
                      {"springlength", "0 " + exactText(slackUntil)},
                      {"stiffness", exactText(spring.secondPhase.springConstant - spring.springConstant)}},
                     xml);
}

void addTendonTerm(const MujocoSubject& subject, std::uint32_t node, double coefficient, const char* axis,
                   XmlText& xml) {
    if (!subject.still[node] && coefficient != 0)
        xml.add("joint", {{"joint", jointName(node, axis)}, {"coef", exactText(coefficient)}});
}

void addDampingRow(const MujocoSubject& subject, const DampingRow& row, XmlText& xml) {
    for (const char* axis : axisNames) {
        xml.open("fixed", {{"damping", exactText(row.viscosity)}});
        for (std::size_t i = 0; i < row.nodes.size(); ++i)
            addTendonTerm(subject, row.nodes[i], row.coefficients[i], axis, xml);
        xml.close();
    }
}

/// A hinge that is flat at rest, exactly: the weighted sum of its nodes' displacements is its strain.
void addHingeTendons(const MujocoSubject& subject, const SpringSystem::HingeElement& hinge, XmlText& xml) {
    for (const char* axis : axisNames) {
        XmlAttributes attributes{{"springlength", "0"}};
        addIfAny(attributes, "stiffness", hinge.springConstant);
        addIfAny(attributes, "damping", hinge.viscosity);
        xml.open("fixed", attributes);
        for (std::size_t i = 0; i < hinge.nodes.size(); ++i)
            addTendonTerm(subject, hinge.nodes[i], hinge.weights[i], axis, xml);
        xml.close();
    }
}

void addTendons(const MujocoSubject& subject, XmlText& xml) {
    const SpringSystem& system = subject.system;
    xml.open("tendon", {});
    for (std::size_t number = 0; number < system.springs.size(); ++number)
        if (isMovable(subject, system.springs[number])) addSpringTendons(subject, number, xml);
    for (const DampingRow& row : subject.rows)
        addDampingRow(subject, row, xml);
    for (const auto& hinge : system.hinges)
        if (isMovable(subject, hinge)) addHingeTendons(subject, hinge, xml);
    xml.close();
}

void addSceneText(const Scene& scene, XmlText& xml) {
    xml.open("custom", {});
    xml.add("text", {{"name", "scene"}, {"data", toJson(scene).dump()}});
    xml.close();
}

} // namespace

std::string mujocoModelText(const MujocoSubject& subject) {
    const Project& project = subject.handover.project;
    XmlText xml("For MuJoCo from 2.2 on; in m, kg, s and N.");
    xml.open("mujoco", {{"model", project.name}});
    xml.add("option", {{"timestep", exactText(subject.step.timeStep)},
                       {"gravity", spaced(project.scene.gravity)},
                       {"integrator", "Euler"},
                       {"jacobian", "sparse"}});
    addMujocoDefaults(subject, xml);
    addMujocoSkins(subject.handover, xml);
    addNodeBodies(subject, xml);
    addTendons(subject, xml);
    addSceneText(project.scene, xml);
    xml.close();
    return xml.text();
}

} // namespace esm
