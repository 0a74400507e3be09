#include "core/exchange/simulators/sofa/sofa_scene.h"

#include "core/dynamics/stability/stability.h"
#include "core/exchange/simulators/obj_surface.h"
#include "core/exchange/simulators/sofa/sofa_loads.h"
#include "core/exchange/simulators/xml_text.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

/// s, Rayleigh damping of fields that damp and hold nothing, see SofaSubject.
constexpr double rayleighTime = 1e9;

/// The parts of SOFA that the scene's components come from.
void addPlugins(const SofaSubject& subject, XmlText& xml) {
    std::vector<std::string> names{"Constraint.Projective",
                                   "Mapping.Linear",
                                   "Mass",
                                   "MechanicalLoad",
                                   "SolidMechanics.Spring",
                                   "StateContainer",
                                   "Topology.Container.Dynamic"};
    names.emplace_back(subject.isImplicit() ? "ODESolver.Backward" : "ODESolver.Forward");
    if (subject.isImplicit()) names.emplace_back("LinearSolver.Iterative");
    const bool hasSurface = isDrawn(subject);
    if (hasSurface) names.emplace_back("IO.Mesh");
    if (subject.recording) names.emplace_back("Playback");
    for (const std::string& name : names)
        xml.add("RequiredPlugin", {{"pluginName", "Sofa.Component." + name}});
    if (hasSurface) xml.add("RequiredPlugin", {{"pluginName", "Sofa.GL.Component.Rendering3D"}});
}

/// Conjugate gradients end at a residue, not at a number of iterations, so that the motion is the tissue's
/// and not the solver's. The tolerance is of its square.
void addSolver(const SofaSubject& subject, XmlText& xml) {
    if (!subject.isImplicit()) return xml.add("EulerExplicitSolver", {{"symplectic", "true"}});
    xml.add("EulerImplicitSolver");
    xml.add("CGLinearSolver", {{"iterations", "1000"}, {"tolerance", "1e-12"}, {"threshold", "1e-40"}});
}

template<typename Cells> std::string cornersOf(const Cells& cells) {
    std::vector<std::uint32_t> corners;
    for (const auto& cell : cells)
        corners.insert(corners.end(), cell.begin(), cell.end());
    return spaced(corners);
}

std::string endsOf(const std::vector<Spring>& springs) {
    std::vector<std::uint32_t> ends;
    for (const Spring& spring : springs)
        ends.insert(ends.end(), {spring.first, spring.second});
    return spaced(ends);
}

/// What the drawn surface is carried by, and the springs where nothing is: a mass in SOFA calls nodes by
/// themselves an error.
void addTopology(const Handover& handover, XmlText& xml) {
    const SpringNetwork& network = *handover.tissue.network;
    const XmlAttributes nodes{{"name", "topology"}, {"position", spaced(network.restPositions)}};
    const auto with = [&](const std::string& kind, const std::string& cells) {
        XmlAttributes attributes = nodes;
        attributes.emplace_back(kind, cells);
        return attributes;
    };
    const std::vector<Triangle> surface = simulatedSurface(*handover.project.mesh, network);
    if (network.lattice)
        xml.add("TetrahedronSetTopologyContainer",
                with("tetrahedra", cornersOf(network.lattice->tetrahedra)));
    else if (!surface.empty())
        xml.add("TriangleSetTopologyContainer", with("triangles", cornersOf(surface)));
    else
        xml.add("EdgeSetTopologyContainer", with("edges", endsOf(network.springs)));
}

std::string springList(const SofaSubject& subject) {
    std::string text;
    for (const SpringSystem::Element& spring : subject.system.springs) {
        if (!text.empty()) text += ' ';
        const double viscosity = subject.isImplicit() ? 0 : spring.viscosity;
        text += std::to_string(spring.first) + ' ' + std::to_string(spring.second) + ' ' +
                exactText(spring.springConstant) + ' ' + exactText(viscosity) + ' ' +
                exactText(spring.restLength);
    }
    return text;
}

/// A biphasic spring is its linear one and a second one beside it, of the difference of both constants, which
/// is there only beyond the length at which the first phase ends.
void addSecondPhase(const SpringSystem& system, XmlText& xml) {
    std::vector<std::uint32_t> firsts, seconds;
    std::vector<double> constants, lengths;
    for (const SpringSystem::Element& spring : system.springs) {
        if (spring.secondPhase.isLinear()) continue;
        firsts.push_back(spring.first);
        seconds.push_back(spring.second);
        constants.push_back(spring.secondPhase.springConstant - spring.springConstant);
        lengths.push_back((1 + spring.secondPhase.strain) * spring.restLength);
    }
    if (firsts.empty()) return;
    const std::vector<std::uint32_t> onlyPulling(firsts.size(), 1);
    xml.add("SpringForceField", {{"name", "beyondFirstPhase"},
                                 {"indices1", spaced(firsts)},
                                 {"indices2", spaced(seconds)},
                                 {"stiffness", spaced(constants)},
                                 {"damping", spaced(std::vector<double>(firsts.size(), 0))},
                                 {"lengths", spaced(lengths)},
                                 {"elongationOnly", spaced(onlyPulling)}});
}

void addSprings(const SofaSubject& subject, XmlText& xml) {
    if (!subject.system.springs.empty())
        xml.add(subject.release.springField, {{"name", "springs"}, {"spring", springList(subject)}});
    if (subject.release.knowsPullingSprings) addSecondPhase(subject.system, xml);
    if (!subject.bending.empty())
        xml.add("VectorSpringForceField", {{"name", "bending"}, {"filename", hingeFile}});
    if (!subject.viscous.empty())
        xml.add(
            "VectorSpringForceField",
            {{"name", "damping"}, {"filename", dampingFile}, {"rayleighStiffness", exactText(rayleighTime)}});
}

void addRestShapeSprings(const std::string& name, const std::vector<Tether>& tethers, double factor,
                         double Tether::*constant, double rayleigh, XmlText& xml) {
    std::vector<std::uint32_t> nodes;
    std::vector<double> constants;
    for (const Tether& tether : tethers) {
        if (!(tether.*constant > 0)) continue;
        nodes.push_back(tether.node);
        constants.push_back(factor * tether.*constant);
    }
    if (nodes.empty()) return;
    XmlAttributes attributes{{"name", name}, {"points", spaced(nodes)}, {"stiffness", spaced(constants)}};
    if (rayleigh > 0) attributes.emplace_back("rayleighStiffness", exactText(rayleigh));
    xml.add("RestShapeSpringsForceField", attributes);
}

/// Per node, in all three directions.
void addTetherViscosities(const SpringSystem& system, XmlText& xml) {
    std::vector<Eigen::Vector3d> viscosities(system.mass.size(), Eigen::Vector3d::Zero());
    bool isAny = false;
    for (const Tether& tether : system.tethers) {
        viscosities[tether.node].array() += tether.viscosity;
        isAny |= tether.viscosity > 0;
    }
    if (isAny)
        xml.add("DiagonalVelocityDampingForceField",
                {{"name", "tetherDamping"}, {"dampingCoefficient", spaced(viscosities)}});
}

/// A spring field gives no force to a spring without length, so tethers are springs to the shape at rest.
void addTethers(const SofaSubject& subject, XmlText& xml) {
    const std::vector<Tether>& tethers = subject.system.tethers;
    addRestShapeSprings("tethers", tethers, 1, &Tether::springConstant, 0, xml);
    if (subject.isImplicit() && subject.release.solverAddsDamping)
        addRestShapeSprings("tetherDamping", tethers, 1 / rayleighTime, &Tether::viscosity, rayleighTime,
                            xml);
    else
        addTetherViscosities(subject.system, xml);
}

void addFixedNodes(const SofaSubject& subject, XmlText& xml) {
    const std::vector<std::uint32_t>& fixed = subject.handover.tissue.fixedNodes;
    if (!fixed.empty())
        xml.add(subject.release.fixedConstraint, {{"name", "fixed"}, {"indices", spaced(fixed)}});
}

/// The organ as it is drawn. It finds its place among the nodes by where both are at rest.
void addSurface(const SofaSubject& subject, XmlText& xml) {
    if (!isDrawn(subject)) return;
    XmlAttributes model{{"src", "@mesh"}};
    if (texturePages(subject.handover.project) == 1)
        model.emplace_back("texturename", textureName(0, subject.pictures));
    xml.open("Node", {{"name", "surface"}});
    xml.add("MeshOBJLoader", {{"name", "mesh"}, {"filename", "surface.obj"}, {"handleSeams", "1"}});
    xml.add("OglModel", model);
    xml.add("BarycentricMapping");
    xml.close();
}

std::vector<VectorSpring> dampingOf(const SpringSystem& system, const SofaRelease& release) {
    std::vector<VectorSpring> springs = viscousSprings(system);
    for (const VectorSpring& spring : hingeSprings(system))
        if (spring.viscosity != 0) springs.push_back(spring);
    for (VectorSpring& spring : springs) {
        spring.springConstant = spring.viscosity / rayleighTime;
        if (release.solverAddsDamping) spring.viscosity = 0;
    }
    return springs;
}

std::vector<VectorSpring> undamped(std::vector<VectorSpring> springs) {
    for (VectorSpring& spring : springs)
        spring.viscosity = 0;
    return springs;
}

/// The recorder begins at the start by itself, and writes as a step begins.
void addRecorder(const SofaSubject& subject, XmlText& xml) {
    if (!subject.recording) return;
    xml.add("WriteState", {{"filename", subject.recording->file.string()},
                           {"time", "0"},
                           {"period", exactText(subject.recording->every)},
                           {"writeX", "1"}});
}

} // namespace

Scene sceneInSofa(Scene scene) {
    scene.instruments.clear();
    scene.splits.clear();
    scene.fillings.clear();
    scene.pressures.clear();
    return scene;
}

double largestSofaStep(const TissueModel& tissue, Damping damping, const Progress& progress) {
    if (damping == Damping::Isotropic) return noStepLimit;
    return criticalStep(tissue, Integrator::Euler, {.progress = progress}, damping).value();
}

double usualSofaStepFor(Damping damping, double largestStep) {
    constexpr double ofImplicitEuler = 0.005, margin = 0.9;
    return damping == Damping::Isotropic ? ofImplicitEuler : std::min(ofImplicitEuler, margin * largestStep);
}

double sofaStep(const TissueModel& tissue, const EngineSettings& engine, const Progress& progress) {
    if (engine.timeStep) return *engine.timeStep;
    return usualSofaStepFor(engine.damping, largestSofaStep(tissue, engine.damping, progress));
}

SofaSubject sofaSubject(const Handover& handover, const SpringSystem& system, const HandoverMeans& means) {
    const SofaRelease release = releaseOf(means.engine.sofaVersion);
    const bool isImplicit = means.engine.damping == Damping::Isotropic;
    const std::vector<VectorSpring> hinges = hingeSprings(system);
    return {.handover = handover,
            .system = system,
            .release = release,
            .damping = means.engine.damping,
            .timeStep = sofaStep(handover.tissue, means.engine, means.progress),
            .pictures = means.pictures.format,
            .viscous = isImplicit ? dampingOf(system, release) : std::vector<VectorSpring>{},
            .bending = isImplicit ? undamped(hinges) : hinges};
}

bool isDrawnInSofa(const Handover& handover) {
    const SpringNetwork& network = *handover.tissue.network;
    return !handover.project.mesh->triangles.empty() &&
           !simulatedSurface(*handover.project.mesh, network).empty();
}

bool isDrawn(const SofaSubject& subject) {
    return !subject.recording && isDrawnInSofa(subject.handover);
}

std::string sofaSceneText(const SofaSubject& subject) {
    XmlText xml(std::string("For SOFA ") + wordOf(subject.release.version) + "; in m, kg, s and N.");
    xml.open("Node", {{"name", "root"},
                      {"dt", exactText(subject.timeStep)},
                      {"gravity", spaced(subject.handover.project.scene.gravity)}});
    addPlugins(subject, xml);
    xml.add("DefaultAnimationLoop");
    xml.open("Node", {{"name", "organ"}});
    addSolver(subject, xml);
    addTopology(subject.handover, xml);
    xml.add("MechanicalObject",
            {{"name", "nodes"}, {"template", "Vec3"}, {"position", "@topology.position"}});
    xml.add("DiagonalMass", {{"name", "mass"}, {"vertexMass", spaced(subject.system.mass)}});
    addSprings(subject, xml);
    addTethers(subject, xml);
    addFixedNodes(subject, xml);
    addSofaLoads(subject, xml);
    addRecorder(subject, xml);
    addSurface(subject, xml);
    xml.close();
    xml.close();
    return xml.text();
}

} // namespace esm
