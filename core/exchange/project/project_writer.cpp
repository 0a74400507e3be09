#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/zip_archive.h"
#include "core/support/errors.h"
#include "core/support/json_reader.h"

namespace esm {

namespace layout = project_layout;

namespace {

/// The archive's entries, the manifest the first of them.
std::vector<ZipEntry> entriesOf(const ProjectContent& content, std::vector<std::string>& problems,
                                const Progress& progress) {
    const std::string manifest = manifestText(content.manifest, 1);
    std::vector<ZipEntry> entries{{layout::manifest, Bytes(manifest.begin(), manifest.end()), true}};
    double made = 0;
    for (const ContentPiece& piece : content.pieces) {
        reportProgress(progress, made++ / static_cast<double>(content.pieces.size()));
        if (piece.entry != entries.back().name) entries.push_back({piece.entry, {}, !piece.isPacked});
        try {
            const Bytes bytes = piece.bytes();
            entries.back().content.insert(entries.back().content.end(), bytes.begin(), bytes.end());
        } catch (const InvalidModel& error) {
            problems.push_back(error.what());
        }
    }
    return entries;
}

/// What is larger than a reader takes.
std::vector<std::string> sizeProblems(const std::vector<ZipEntry>& entries) {
    std::vector<std::string> problems;
    std::uint64_t size = 0;
    for (const ZipEntry& entry : entries)
        size += entry.content.size();
    if (entries.front().content.size() > layout::largestManifest)
        problems.push_back("its lists are longer than a project file can hold; shorten the scene's paths");
    if (size > layout::largestProject)
        problems.push_back("it is larger than 2 GiB; use fewer or smaller photos");
    return problems;
}

void refuse(const std::filesystem::path& file, const std::vector<std::string>& problems) {
    if (!problems.empty())
        throw FileError(file, "was not saved: " + std::string(InvalidModel(problems).what()));
}

/// Names that differ only in bytes that are no Unicode, for example, would become one key.
void requireParsable(const std::filesystem::path& file, const Bytes& manifest) {
    const char* text = reinterpret_cast<const char*>(manifest.data());
    try {
        guardJson(text, text + manifest.size());
    } catch (const InvalidModel& error) {
        refuse(file, error.problems());
    }
}

void append(std::vector<std::string>& problems, const std::vector<std::string>& more) {
    problems.insert(problems.end(), more.begin(), more.end());
}

} // namespace

void saveProject(const Project& project, const std::filesystem::path& file, const Progress& progress) {
    ProgressParts parts(progress);
    reportProgress(progress, 0);
    refuse(file, validate(project));
    const ProjectContent content = contentOf(project);
    std::vector<std::string> problems;
    const std::vector<ZipEntry> entries = entriesOf(content, problems, parts.next(0.2));
    append(problems, manifestProblems(project, content.manifest));
    append(problems, sizeProblems(entries));
    refuse(file, problems);
    requireParsable(file, entries.front().content);
    const Bytes archive = makeZip(entries, parts.next(0.6));
    writeFileAtomically(file, archive, parts.rest());
}

} // namespace esm
