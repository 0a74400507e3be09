#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/picture_options.h"
#include "core/authoring/packing.h"
#include "core/exchange/image_file.h"
#include "core/exchange/project/project_file.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"
#include "core/texture/maps/ambient_occlusion.h"
#include "core/texture/maps/finish_pages.h"
#include "core/texture/photo/photo_format.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <list>
#include <regex>
#include <set>

namespace esm {

namespace {

namespace fs = std::filesystem;

struct BakeOptions {
    std::string project, folder;
    bool deep = false;    ///< 16 bits a channel
    bool smaller = false; ///< as well
    PictureOptions pictures;
};

void declareBake(CLI::App& command, BakeOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.folder, "Folder for the pictures; made when it is missing")
        ->required()
        ->check(namedFolder());
    addChoice(command, "--bits", options.deep, {{"8", false}, {"16", true}}, "Bits of each channel (8)");
    command.add_flag("--smaller", options.smaller,
                     "Each page as well at half its size, a quarter and so on, as far as the gap allows");
    declarePictures(command, options.pictures);
}

/// @throws UsageError
void checkUse(const BakeOptions& options) {
    checkPictures(options.pictures);
    if (options.deep && options.pictures.encoding.format == PictureFormat::Jpeg)
        throw UsageError("--bits: a JPEG has 8 bits a channel; 16 go with --pictures png");
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

struct EncodedPage {
    fs::path file;
    Bytes bytes;
};

/// Where pages are written, and as what.
struct PageFiles {
    fs::path folder;
    PictureEncoding encoding;
    double texelsPerMetre;

    /// @param part of the name: "-1024" of a smaller size, "-normals" of what is no colour
    fs::path of(std::size_t page, const std::string& part = "") const {
        return folder / ("texture-" + std::to_string(page + 1) + part + endingOf(encoding.format));
    }
    EncodedPage encoded(const Image& picture, std::size_t page, const std::string& part) const {
        return {of(page, part), encodePicture(picture, encoding, texelsPerMetre)};
    }
};

Bytes encodedPage(const Image& page, const PageFiles& files) {
    return encodePicture(page, files.encoding, files.texelsPerMetre);
}

Bytes encodedPage(const DeepImage& page, const PageFiles& files) {
    return encodePng(page, files.texelsPerMetre);
}

template<typename Channel>
std::vector<EncodedPage> encoded(const std::vector<ImageOf<Channel>>& pages, const PageFiles& where,
                                 const Progress& progress) {
    std::vector<EncodedPage> files;
    for (const ImageOf<Channel>& page : pages) {
        reportProgress(progress, static_cast<double>(files.size()) / static_cast<double>(pages.size()));
        files.push_back({where.of(files.size()), encodedPage(page, where)});
    }
    return files;
}

/// Sizes of a page are told apart by their width in pixels.
std::vector<EncodedPage> encoded(const SmallerPages& pages, const PageFiles& where) {
    std::vector<EncodedPage> files;
    for (std::size_t page = 0; page < pages.size(); ++page)
        for (std::size_t i = 0; i < pages[page].size(); ++i) {
            const Image smaller = pages[page][i].image();
            const double density = std::ldexp(where.texelsPerMetre, -static_cast<int>(i) - 1);
            files.push_back({where.of(page, "-" + std::to_string(smaller.width)),
                             encodePicture(smaller, where.encoding, density)});
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
void writePages(const std::vector<EncodedPage>& pages, const fs::path& folder, Interruption& interruption) {
    const fs::path existing = existingPartOf(folder);
    std::list<AtomicFile> files;
    for (const EncodedPage& page : pages) {
        files.emplace_back(page.file, existing);
        files.back().write({reinterpret_cast<const char*>(page.bytes.data()), page.bytes.size()});
        files.back().sync();
    }
    interruption.disarm();
    commit(files, folder, existing);
}

/// Pages that an earlier bake left in the folder would be taken for pages of this one.
std::vector<std::string> staleWarnings(const fs::path& folder, const std::vector<EncodedPage>& written) {
    static const std::regex isPage(
        "texture-[0-9]+(-([0-9]+|wetness-roughness|normals|occlusion))?\\.(png|jpg)");
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (std::regex_match(entry.path().filename().string(), isPage)) found.insert(entry.path().string());
    for (const EncodedPage& page : written)
        found.erase(page.file.string());
    const std::vector<std::string> stale(found.begin(), found.end());
    if (stale.empty()) return {};
    return {joined(stale) + (stale.size() == 1 ? " is" : " are") +
            " of an earlier bake and no part of this texture; remove or rename"};
}

/// As whoever reads the file sees it.
Image asStored(Image page, const PictureEncoding& encoding) {
    if (encoding.format == PictureFormat::Png) return page;
    return decodePhoto("the texture", encodePicture(page, encoding))->image;
}

/// Of the pages, and of each size to which a renderer may halve them.
std::vector<double> seamErrors(const Project& project, const std::vector<Image>& pages,
                               const SmallerPages& smaller, const PictureEncoding& encoding) {
    std::vector<Image> stored;
    stored.reserve(pages.size());
    for (const Image& page : pages)
        stored.push_back(asStored(page, encoding));
    std::vector<double> errors{seamError(*project.mesh, *project.atlas, stored)};
    for (int halvings = 1; halvings <= usableLevels(project.atlas->options); ++halvings) {
        for (std::size_t page = 0; page < smaller.size(); ++page)
            stored[page] = asStored(smaller[page][static_cast<std::size_t>(halvings - 1)].image(), encoding);
        errors.push_back(seamError(*project.mesh, *project.atlas, stored, halvings));
    }
    return errors;
}

std::string seamText(const std::vector<double>& errors) {
    std::string text = "largest difference of colour across an edge: " + inText(errors.front()) + " of 255";
    for (std::size_t halvings = 1; halvings < errors.size(); ++halvings)
        text += ", at 1/" + std::to_string(1 << halvings) + " of the size " + inText(errors[halvings]);
    return text;
}

/// As far as 8 bits tell them apart.
Image rounded(const DeepImage& page) {
    constexpr int steps = 257;
    Image image{page.width, page.height, std::vector<std::uint8_t>(page.pixels.size())};
    std::transform(page.pixels.begin(), page.pixels.end(), image.pixels.begin(), [](std::uint16_t value) {
        return static_cast<std::uint8_t>((value + steps / 2) / steps);
    });
    return image;
}

struct Baked {
    std::vector<EncodedPage> files; ///< of the pages, of smaller ones, of what is no colour
    std::vector<double> seamErrors;
};

SmallerPages halved(const Project& project, const std::vector<Image>& pages, CompositionCache& cache,
                    const Progress& progress) {
    const Atlas& atlas = *project.atlas;
    if (usableLevels(atlas.options) == 0) return SmallerPages(pages.size());
    ProgressParts parts(progress);
    const auto owners = cache.ownersOf(*project.mesh, atlas, parts.next(0.5));
    return smallerPages(atlas, *owners, tiled(pages), {}, parts.rest());
}

Baked bake(const Project& project, const BakeOptions& options, const Context& context) {
    const Progress baking = progressOf(context, "baking");
    const PageFiles files{options.folder, options.pictures.encoding, project.atlas->texelsPerMetre};
    CompositionCache cache;
    std::vector<Image> pages;
    std::vector<DeepImage> deep;
    if (options.deep) {
        deep = compositeDeep(*project.mesh, *project.atlas, project.layers, project.texture.baseColour, cache,
                             baking);
        std::transform(deep.begin(), deep.end(), std::back_inserter(pages), rounded);
    } else {
        pages = composite(*project.mesh, *project.atlas, project.layers, project.texture.baseColour, cache,
                          baking);
    }
    const SmallerPages smaller = halved(project, pages, cache, progressOf(context, "halving"));
    const Progress writing = progressOf(context, "writing");
    Baked baked{options.deep ? encoded(deep, files, writing) : encoded(pages, files, writing),
                seamErrors(project, pages, smaller, options.pictures.encoding)};
    if (!options.smaller) return baked;
    for (EncodedPage& file : encoded(smaller, files))
        baked.files.push_back(std::move(file));
    return baked;
}

/// What is no colour, as the package has it: exact, whatever the colours are stored as.
std::vector<EncodedPage> bakedMaterials(const Project& project, const BakeOptions& options,
                                        const Context& context) {
    const PageFiles files{options.folder, {}, project.atlas->texelsPerMetre};
    const TextureSettings& settings = project.texture;
    std::vector<EncodedPage> made;
    const auto finish = finishPages(*project.mesh, *project.atlas, project.layers, settings.finish,
                                    progressOf(context, "baking the finish"));
    for (std::size_t page = 0; finish && page < finish->size(); ++page) {
        const MaterialPage material = materialPage((*finish)[page]);
        made.push_back(files.encoded(material.wetnessAndRoughness, page, "-wetness-roughness"));
        if (!material.normals.empty()) made.push_back(files.encoded(material.normals, page, "-normals"));
    }
    if (!(settings.occlusionReach > 0)) return made;
    const std::vector<Image> occlusion = occlusionPages(
        *project.mesh, *project.atlas, settings.occlusionReach, progressOf(context, "baking the occlusion"));
    for (std::size_t page = 0; page < occlusion.size(); ++page)
        made.push_back(files.encoded(occlusion[page], page, "-occlusion"));
    return made;
}

Report runBake(const BakeOptions& options, Context& context) {
    checkUse(options);
    existingPartOf(options.folder); // refused now rather than after the work
    context.subject = options.project;
    Project project = openedProject(options.project, context);
    packIfNeeded(project);
    Baked baked = bake(project, options, context);
    for (EncodedPage& file : bakedMaterials(project, options, context))
        baked.files.push_back(std::move(file));
    writePages(baked.files, options.folder, context.interruption);
    Report report;
    report.json["files"] = Json::array();
    for (const EncodedPage& page : baked.files) {
        report.json["files"].push_back(page.file.string());
        addWritten(report, page.file);
    }
    report.json["seam_error"] = baked.seamErrors.front();
    report.json["seam_errors"] = baked.seamErrors;
    report.text.push_back(seamText(baked.seamErrors));
    addWarnings(report, staleWarnings(options.folder, baked.files));
    return report;
}

} // namespace

void addBakeCommand(CLI::App& texture, Context& context) {
    addCommand(texture, context,
               Command<BakeOptions>{"bake", "Write the textures as PNG or JPEG", declareBake, runBake});
}

} // namespace esm
