#include "app/esmc/opened_file.h"

#include "core/exchange/project/project_file.h"

namespace esm {

namespace {

void warnOf(const std::vector<std::string>& found, const std::filesystem::path& file, Context& context) {
    for (const std::string& warning : found)
        context.warnings.push_back(file.string() + ": " + warning);
}

} // namespace

Project openedProject(const std::filesystem::path& file, Context& context) {
    OpenedProject opened = openProject(file);
    warnOf(opened.warnings, file, context);
    return std::move(opened.project);
}

ModelPackage openedPackage(const std::filesystem::path& file, Context& context) {
    OpenedPackage opened = openPackage(file);
    warnOf(opened.warnings, file, context);
    return std::move(opened.package);
}

} // namespace esm
