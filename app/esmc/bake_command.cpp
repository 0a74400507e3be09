#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "core/authoring/packing.h"
#include "core/exchange/image_file.h"
#include "core/exchange/project/project_file.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"

#include <filesystem>
#include <list>

namespace esm {

namespace {

namespace fs = std::filesystem;

struct BakeOptions {
    std::string project, folder;
    bool deep = false; ///< 16 bits a channel
};

void declareBake(CLI::App& command, BakeOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.folder, "Folder for the pictures; made when it is missing")
        ->required()
        ->check(namedFolder());
    addChoice(command, "--bits", options.deep, {{"8", false}, {"16", true}}, "Bits of each channel (8)");
}

/// The folder itself, or the nearest one above it that is there.
fs::path existingPartOf(const fs::path& folder) {
    std::error_code error;
    fs::path part = fs::absolute(folder, error);
    while (part.has_relative_path() && fs::symlink_status(part, error).type() == fs::file_type::not_found)
        part = part.parent_path();
    if (!fs::is_directory(part, error))
        throw FileError(folder, "cannot be made a folder; choose another name");
    return part;
}

/// Takes a folder away again, and those above it, as far as they are empty.
void removeEmpty(const fs::path& folder, const fs::path& below) {
    std::error_code error;
    for (fs::path part = fs::absolute(folder, error); part != below && !error; part = part.parent_path())
        fs::remove(part, error);
}

fs::path pageFile(const fs::path& folder, std::size_t page) {
    return folder / ("texture-" + std::to_string(page + 1) + ".png");
}

template<typename Channel>
std::vector<Bytes> encoded(const std::vector<ImageOf<Channel>>& pages, double texelsPerMetre,
                           const Context& context) {
    const Progress progress = progressOf(context, "writing");
    std::vector<Bytes> files;
    for (const ImageOf<Channel>& page : pages) {
        reportProgress(progress, static_cast<double>(files.size()) / static_cast<double>(pages.size()));
        files.push_back(encodePng(page, texelsPerMetre));
    }
    return files;
}

/// All together, in a folder that is made where it is missing.
void commit(std::list<AtomicFile>& files, const fs::path& folder, const fs::path& existing) {
    try {
        std::error_code error;
        fs::create_directories(folder, error);
        if (error)
            throw FileError(folder, "cannot be made a folder: " + error.message() + "; choose another name");
        for (AtomicFile& file : files)
            file.commit();
    } catch (...) {
        removeEmpty(folder, existing);
        throw;
    }
}

/// No page takes its place, and no folder is made, before all are written.
void writePages(const std::vector<Bytes>& pages, const fs::path& folder, Interruption& interruption) {
    const fs::path existing = existingPartOf(folder);
    std::list<AtomicFile> files;
    for (std::size_t page = 0; page < pages.size(); ++page) {
        files.emplace_back(pageFile(folder, page), existing);
        files.back().write({reinterpret_cast<const char*>(pages[page].data()), pages[page].size()});
        files.back().sync();
    }
    interruption.disarm();
    commit(files, folder, existing);
}

/// Pages that a bake of more of them left in the folder would be taken for pages of this one.
std::vector<std::string> staleWarnings(const fs::path& folder, std::size_t pages) {
    std::vector<std::string> stale;
    for (std::size_t page = pages; fs::exists(pageFile(folder, page)); ++page)
        stale.push_back(pageFile(folder, page).string());
    if (stale.empty()) return {};
    return {joined(stale) + (stale.size() == 1 ? " is" : " are") +
            " of an earlier bake and no part of this texture; remove or rename"};
}

/// Of the pages, and of each size to which a renderer may halve them.
std::vector<double> seamErrors(const Project& project, const std::vector<Image>& pages) {
    std::vector<double> errors{seamError(*project.mesh, *project.atlas, pages)};
    const SmallerPages smaller = smallerPages(*project.atlas, pages);
    for (int halvings = 1; halvings <= usableLevels(project.atlas->options); ++halvings) {
        std::vector<Image> level;
        for (const std::vector<Image>& page : smaller)
            level.push_back(page[static_cast<std::size_t>(halvings - 1)]);
        errors.push_back(seamError(*project.mesh, *project.atlas, level, halvings));
    }
    return errors;
}

std::string seamText(const std::vector<double>& errors) {
    std::string text = "largest difference of colour across an edge: " + inText(errors.front()) + " of 255";
    for (std::size_t halvings = 1; halvings < errors.size(); ++halvings)
        text += ", at 1/" + std::to_string(1 << halvings) + " of the size " + inText(errors[halvings]);
    return text;
}

struct Baked {
    std::vector<Bytes> files; ///< of the pages
    std::vector<double> seamErrors;
};

Baked bake(const Project& project, bool deep, const Context& context) {
    const Progress progress = progressOf(context, "baking");
    const double texelsPerMetre = project.atlas->texelsPerMetre;
    CompositionCache cache;
    const std::vector<Image> pages =
        composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour, cache, progress);
    Baked baked{{}, seamErrors(project, pages)};
    baked.files = deep ? encoded(compositeDeep(*project.mesh, *project.atlas, project.layers,
                                               project.texture.baseColour, cache, progress),
                                 texelsPerMetre, context)
                       : encoded(pages, texelsPerMetre, context);
    return baked;
}

Report runBake(const BakeOptions& options, Context& context) {
    existingPartOf(options.folder); // refused now rather than after the work
    context.subject = options.project;
    Project project = openedProject(options.project, context);
    packIfNeeded(project);
    const Baked baked = bake(project, options.deep, context);
    writePages(baked.files, options.folder, context.interruption);
    Report report;
    report.json["files"] = Json::array();
    for (std::size_t page = 0; page < baked.files.size(); ++page) {
        report.json["files"].push_back(pageFile(options.folder, page).string());
        addWritten(report, pageFile(options.folder, page));
    }
    report.json["seam_error"] = baked.seamErrors.front();
    report.json["seam_errors"] = baked.seamErrors;
    report.text.push_back(seamText(baked.seamErrors));
    addWarnings(report, staleWarnings(options.folder, baked.files.size()));
    return report;
}

} // namespace

void addBakeCommand(CLI::App& texture, Context& context) {
    addCommand(texture, context,
               Command<BakeOptions>{"bake", "Write the textures as PNG", declareBake, runBake});
}

} // namespace esm
