#include "app/esmc/run_files.h"

#include "core/support/errors.h"

#include <numeric>

namespace esm {

namespace {

std::vector<std::uint32_t> firstNumbers(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
}

std::filesystem::path placeOf(const std::string& file) {
    std::error_code error;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
}

} // namespace

void requireTwoFiles(const RunOutputs& outputs) {
    if (!outputs.surface.empty() && placeOf(outputs.surface) == placeOf(outputs.nodes))
        throw UsageError("--surface: '" + outputs.surface +
                         "' is the file that the nodes go to; name another one");
}

void requireSurface(const RunOutputs& outputs, const RunnableModel& model) {
    if (outputs.surface.empty()) return;
    if (model.mesh->triangles.empty()) throw InvalidModel("there is no surface for --surface to write");
    if (model.scene.record.nodes)
        throw InvalidModel("--surface takes the places of all nodes: leave record.nodes out of the scene");
}

RunFiles::RunFiles(const RunOutputs& outputs, const RunnableModel& model)
    : m_model(model), m_nodes(outputs.nodes, "node",
                              model.scene.record.nodes.value_or(firstNumbers(model.tissue.mass.size()))) {
    if (!outputs.surface.empty())
        m_surface.emplace(outputs.surface, "vertex", firstNumbers(model.mesh->vertices.size()));
}

void RunFiles::add(double time, const std::vector<Eigen::Vector3d>& positions) {
    m_nodes.add(time, positions);
    if (m_surface) m_surface->add(time, drawnPositions(*m_model.mesh, *m_model.tissue.network, positions));
}

void RunFiles::commit(Interruption& interruption) {
    interruption.disarm();
    m_nodes.commit();
    if (m_surface) m_surface->commit();
}

} // namespace esm
