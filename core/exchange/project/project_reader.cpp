#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/zip_archive.h"
#include "core/support/errors.h"
#include "core/support/json_reader.h"

namespace esm {

using Json = nlohmann::ordered_json;
namespace layout = project_layout;

namespace {

Json readManifest(const ZipReader& archive) {
    const Bytes text = archive.read(layout::manifest, layout::largestManifest);
    const char* begin = reinterpret_cast<const char*>(text.data());
    try {
        return parseJson(begin, begin + text.size());
    } catch (const InvalidModel& error) {
        throw InvalidModel("the entry " + std::string(layout::manifest) + ": " + error.what());
    }
}

/// What every zip archive begins with, an empty or a cut one too.
bool beginsAsZip(const Bytes& content) {
    return content.size() >= 2 && content[0] == 'P' && content[1] == 'K';
}

bool beginsAsPackage(const Bytes& content) {
    constexpr std::string_view magic = "glTF";
    return content.size() >= magic.size() && std::equal(magic.begin(), magic.end(), content.begin());
}

ReadContent readProject(const std::filesystem::path& file, const Progress& progress) {
    ProgressParts parts(progress);
    const Bytes content = readFile(file, largestFile, parts.next(0.05));
    try {
        if (content.empty()) throw InvalidModel("is empty; choose another file");
        if (beginsAsPackage(content))
            throw InvalidModel("is a model package; open the project that it was exported from (.esm)");
        if (!beginsAsZip(content))
            throw InvalidModel("is not a project of this program, but another kind of file, or damaged");
        const ZipReader archive(content);
        SharedParts none;
        return projectFrom(readManifest(archive),
                           {[&](const std::string& entry, std::uint64_t largest, const Progress& reading) {
                               return archive.read(entry, largest, reading);
                           }},
                           none, parts.rest());
    } catch (const InvalidModel& error) {
        return {{}, error.problems(), {}};
    }
}

} // namespace

OpenedProject openProject(const std::filesystem::path& file, const Progress& progress) {
    ReadContent read = readProject(file, progress);
    if (!read.problems.empty()) throw FileError(file, InvalidModel(read.problems).what());
    return {std::move(read.project), std::move(read.warnings)};
}

Project loadProject(const std::filesystem::path& file, const Progress& progress) {
    return openProject(file, progress).project;
}

std::vector<std::string> validateProjectFile(const std::filesystem::path& file) {
    ReadContent read = readProject(file, {});
    read.problems.insert(read.problems.end(), read.warnings.begin(), read.warnings.end());
    return read.problems;
}

} // namespace esm
