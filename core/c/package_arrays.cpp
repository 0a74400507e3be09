#include "core/c/package_arrays.h"

#include "core/support/words.h"

namespace esm {

namespace {

EsmNodes nodesOf(const TissueModel& tissue) {
    return {tissue.mass.size(), numbersIn(tissue.network->restPositions), tissue.mass.data(),
            tissue.springConstant.data(), tissue.viscosity.data()};
}

EsmLattice latticeOf(const SpringNetwork& network) {
    if (!network.lattice) return {};
    const Lattice& lattice = *network.lattice;
    return {wordOf(lattice.filling.kind), lattice.tetrahedra.size(), numbersIn(lattice.tetrahedra),
            lattice.surface.size(), numbersIn(lattice.surface)};
}

EsmStiffening stiffeningOf(const TissueModel& tissue) {
    if (!tissue.stiffening) return {0, 1};
    return {tissue.stiffening->strain, tissue.stiffening->factor};
}

EsmStepping steppingOf(const std::optional<MeasuredStepping>& measured) {
    if (!measured) return {};
    const Stepping& stepping = measured->stepping;
    return {integratorName(stepping.integrator), stepping.timeStep, stepping.precision == Precision::Float,
            measured->error, measured->wallPerSimulatedSecond};
}

} // namespace

PackageArrays::PackageArrays(std::shared_ptr<const PackagedTissue> package) : m_package(std::move(package)) {
    const TissueModel& tissue = m_package->tissue;
    m_model.name = m_package->name.c_str();
    m_model.nodes = nodesOf(tissue);
    m_model.fixedNodes = {tissue.fixedNodes.size(), tissue.fixedNodes.data()};
    m_model.stiffening = stiffeningOf(tissue);
    m_model.lattice = latticeOf(*tissue.network);
    m_model.stepping = steppingOf(m_package->stepping);
    addSprings();
    addTethers();
    addHinges();
    addSurface();
    addBinding();
    addFillings();
}

void PackageArrays::addSprings() {
    const TissueModel& tissue = m_package->tissue;
    for (const Spring& spring : tissue.network->springs) {
        m_springs.nodes.insert(m_springs.nodes.end(), {spring.first, spring.second});
        m_springs.lengths.push_back(spring.restLength);
    }
    for (const auto& [springConstant, viscosity] : springValues(tissue)) {
        m_springs.constants.push_back(springConstant);
        m_springs.viscosities.push_back(viscosity);
    }
    m_model.springs = {m_springs.lengths.size(), m_springs.nodes.data(), m_springs.lengths.data(),
                       m_springs.constants.data(), m_springs.viscosities.data()};
}

void PackageArrays::addTethers() {
    for (const auto& [node, springConstant, viscosity] : m_package->tissue.tethers) {
        m_tethers.nodes.push_back(node);
        m_tethers.constants.push_back(springConstant);
        m_tethers.viscosities.push_back(viscosity);
    }
    m_model.tethers = {m_tethers.nodes.size(), m_tethers.nodes.data(), m_tethers.constants.data(),
                       m_tethers.viscosities.data()};
}

void PackageArrays::addHinges() {
    for (const auto& [nodes, stiffness, viscosity] : m_package->tissue.hinges) {
        m_hinges.nodes.insert(m_hinges.nodes.end(), nodes.begin(), nodes.end());
        m_hinges.constants.push_back(stiffness);
        m_hinges.viscosities.push_back(viscosity);
    }
    m_model.hinges = {m_hinges.constants.size(), m_hinges.nodes.data(), m_hinges.constants.data(),
                      m_hinges.viscosities.data()};
}

void PackageArrays::addSurface() {
    const TriangleMesh& mesh = m_package->mesh;
    m_model.surface = {mesh.vertices.size(), numbersIn(mesh.vertices),
                       m_package->tissue.network->vertexNodes.data(), mesh.triangles.size(),
                       numbersIn(mesh.triangles)};
}

void PackageArrays::addBinding() {
    if (!m_package->tissue.network->binding) return;
    const Binding& binding = *m_package->tissue.network->binding;
    for (const auto& [first, second] : binding.lines)
        m_lines.insert(m_lines.end(), {first, second});
    m_model.binding = {binding.vertices.size(),       binding.vertices.starts.data(),
                       binding.vertices.nodes.data(), binding.vertices.shares.data(),
                       binding.surface.size(),        numbersIn(binding.surface),
                       binding.lines.size(),          m_lines.data()};
}

void PackageArrays::addFillings() {
    for (const Cavity& cavity : m_package->tissue.cavities) {
        if (cavity.stiffness == 0) continue; // only pressed on from within
        m_filledParts.push_back(cavity.part);
        m_fillingStiffnesses.push_back(cavity.stiffness);
    }
    m_model.fillings = {m_filledParts.size(), m_filledParts.data(), m_fillingStiffnesses.data()};
}

} // namespace esm
