#include "app/esmc/run_files.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

/// CSV `time,instrument,fx,fy,fz`, numbers so that they read back exactly.
void writeForces(const std::vector<ForceRow>& rows, const Scene& scene, AtomicFile& file) {
    file.write("time,instrument,fx,fy,fz\n");
    for (const auto& [time, forces] : rows)
        for (std::size_t i = 0; i < forces.size(); ++i)
            file.write(exactText(time) + "," + nameOf(scene, i) + "," + exactText(forces[i].x()) + "," +
                       exactText(forces[i].y()) + "," + exactText(forces[i].z()) + "\n");
}

std::filesystem::path placeOf(const std::string& file) {
    std::error_code error;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
}

} // namespace

void requireDistinctFiles(const RunOutputs& outputs) {
    const auto refuseSame = [](const char* option, const std::string& file, const std::string& other,
                               const char* what) {
        if (!file.empty() && !other.empty() && placeOf(file) == placeOf(other))
            throw UsageError(std::string(option) + ": '" + file + "' is the file that the " + what +
                             " to; name another one");
    };
    refuseSame("--surface", outputs.surface, outputs.nodes, "nodes go");
    refuseSame("--forces", outputs.forces, outputs.nodes, "nodes go");
    refuseSame("--forces", outputs.forces, outputs.surface, "surface goes");
}

void requireInstruments(const RunOutputs& outputs, const Scene& scene) {
    if (!outputs.forces.empty() && scene.instruments.empty())
        throw InvalidModel("the scene has no instrument for --forces to write the forces on");
}

void requireSurface(const RunOutputs& outputs, const RunnableModel& model) {
    if (outputs.surface.empty()) return;
    if (model.mesh->triangles.empty()) throw InvalidModel("there is no surface for --surface to write");
    if (model.scene.record.nodes)
        throw InvalidModel("--surface takes the places of all nodes: leave record.nodes out of the scene");
}

RunFiles::RunFiles(const RunOutputs& outputs, const RunnableModel& model,
                   const std::vector<SceneStage>& stages)
    : m_model(model), m_stages(stages),
      m_nodes(outputs.nodes, "node", recordedNodes(model.scene, model.tissue.mass.size())) {
    if (!outputs.surface.empty()) m_surface.emplace(outputs.surface, "vertex");
    if (!outputs.forces.empty()) m_forces.emplace(outputs.forces);
}

void RunFiles::add(double time, const std::vector<Eigen::Vector3d>& positions) {
    m_nodes.add(time, positions);
    if (m_surface) m_surface->add(time, drawn(positions));
}

std::vector<Eigen::Vector3d> RunFiles::drawn(const std::vector<Eigen::Vector3d>& positions) const {
    const SceneStage* stage = stageOfNodes(m_stages, positions.size());
    if (!stage) return drawnPositions(*m_model.mesh, *m_model.tissue.network, positions);
    return drawnPositions(*stage->organ.topology.surface, *stage->organ.topology.network, positions);
}

void RunFiles::commit(const std::vector<ForceRow>& forces, Interruption& interruption) {
    interruption.disarm();
    if (m_forces) writeForces(forces, m_model.scene, *m_forces);
    m_nodes.commit();
    if (m_surface) m_surface->commit();
    if (m_forces) m_forces->commit();
}

} // namespace esm
