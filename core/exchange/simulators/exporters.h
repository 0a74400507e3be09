#pragma once

#include "core/exchange/simulators/difference.h"
#include "core/exchange/simulators/handover.h"

#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// One way to hand an organ over. Command line and window list what there is from `exporters()`.
struct Exporter {
    std::string name;    ///< on the command line: "glb"
    std::string ending;  ///< ".glb"
    std::string title;   ///< of its files, in a dialog: "Model packages"
    std::string purpose; ///< what it is for, in half a sentence
    /// Writes the file, or the folder, whole or not at all. @throws InvalidModel for what the format cannot
    /// hold, FileError, Cancelled
    std::function<void(const Handover& handover, const std::filesystem::path& file,
                       const HandoverMeans& means)>
        write;
    bool holdsPictures = false;   ///< of the texture
    bool holdsAuthorship = false; ///< title, author, date and licence
    bool isFolder = false;        ///< of several files; there must be none of its name yet, or an empty one
    bool isStepped = false;       ///< says how to step the organ, by `HandoverMeans::engine`
    bool hasReleases = false;     ///< of SOFA, which load other files: `EngineSettings::sofaVersion`
    bool canBeTried = false;      ///< by `tryInSofa()`, where SOFA is installed
    /// What of the organ will differ in the program that it is written for. Empty: nothing. @throws Cancelled
    std::function<Differences(const Handover& handover, const HandoverMeans& means)> differences = {};
    std::string otherName = {}; ///< on the command line as well; empty without
};

const std::vector<Exporter>& exporters();

/// The one whose ending a file has, in letters of any size; the first there is where it has none at all.
/// @throws FileError for another ending
const Exporter& exporterFor(const std::filesystem::path& file);

/// @throws FileError where a folder stands at the file's place that is not empty, or a file where a folder is
/// to be: for who asks before long work
void requireFree(const std::filesystem::path& file, const Exporter& exporter);

/// What a project comes to, for a file that is to be written. @throws FileError of that file for a project
/// with problems, Cancelled
Handover handoverFor(const std::filesystem::path& file, const Project& project,
                     const Progress& progress = {});

/// What of it will differ. @throws Cancelled
Differences differencesOf(const Handover& handover, const Exporter& exporter,
                          const HandoverMeans& means = {});

/// @throws FileError, also for what the format cannot hold; Cancelled; what drawing throws
void exportHandover(const Handover& handover, const Exporter& exporter, const std::filesystem::path& file,
                    const HandoverMeans& means = {});

/// All that an export has written, by name: the file, or the files in the folder.
std::vector<std::filesystem::path> exportedFiles(const std::filesystem::path& file);

/// Evaluates the project and writes it, for who asks nobody in between. Throws what both do.
void exportProject(const Project& project, const Exporter& exporter, const std::filesystem::path& file,
                   const HandoverMeans& means = {});

} // namespace esm
