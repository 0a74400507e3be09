#include "app/esmc/project_output.h"

#include "core/exchange/project/project_file.h"

namespace esm {

ProjectOutput::ProjectOutput(const std::filesystem::path& file) : m_file(file), m_lock(file) {}

void ProjectOutput::save(const Project& project) const {
    m_lock.requireUnchanged();
    saveProject(project, m_file);
}

} // namespace esm
