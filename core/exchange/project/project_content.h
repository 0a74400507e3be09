#pragma once

#include "core/project/project.h"
#include "core/support/file_io.h"
#include "core/support/progress.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

/// A project as a manifest, and the arrays and pictures beside it, wherever these are kept: in the archive of
/// a project file, or as files of a journal.
namespace esm {

/// All of an entry, or one part of it that follows the one before.
struct ContentPiece {
    std::string entry;
    /// Never changes, and is, with the entry's name, all that the bytes depend on.
    std::shared_ptr<const void> source;
    std::function<Bytes()> bytes; ///< @throws InvalidModel for a number that is not finite
    bool isPacked = false;        ///< compressed already, as photos are
};

// NOLINTNEXTLINE(bugprone-exception-escape): nlohmann-json is not seen to move without throwing
struct ProjectContent {
    nlohmann::ordered_json manifest;
    std::vector<ContentPiece> pieces; ///< in the order of their entries
};

/// What a project is stored as. Pieces are made when they are asked for.
ProjectContent contentOf(const Project& project);

/// What would make a manifest that cannot be read again.
std::vector<std::string> manifestProblems(const Project& project, const nlohmann::ordered_json& manifest);

/// A manifest as text. Names may come from file names in any encoding; JSON holds UTF-8 only.
std::string manifestText(const nlohmann::ordered_json& manifest, int indent = -1);

/// What projects share that are read one after the other: the steps of an undo list have one mesh, and say so
/// by its place in memory.
struct SharedParts {
    std::map<std::string, std::shared_ptr<const void>> byContent;
    struct Preparation {
        std::shared_ptr<const Photo> photo;
        PhotoPreparation preparation;
        std::shared_ptr<const Image> prepared;
    };
    std::vector<Preparation> preparations;
};

/// Where the entries of a manifest are. None of it can be trusted.
struct ContentSource {
    /// At most `largest` bytes. @throws InvalidModel naming the entry where it cannot be had; Cancelled
    std::function<Bytes(const std::string& entry, std::uint64_t largest, const Progress&)> bytes;
    /// The same text for the same bytes. Without it nothing is shared.
    std::function<std::string(const std::string& entry)> nameOfContent{};
};

/// A project and all that is wrong with it, and with what it was read from.
struct ReadContent {
    Project project; ///< of use only without problems
    std::vector<std::string> problems, warnings;
};

/// Its parts are numbered by place. @throws InvalidModel where it is no project's manifest, or a newer one;
/// Cancelled
ReadContent projectFrom(const nlohmann::ordered_json& manifest, const ContentSource& source,
                        SharedParts& shared, const Progress& progress = {});

} // namespace esm
