#pragma once

#include "core/project/region.h"
#include "core/texture/layers/texture_layer.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What a recovery journal tells beside projects.
namespace esm {

/// Bytes of a journal's records that are read.
inline constexpr std::uint64_t largestRecords = std::uint64_t{1} << 30;

/// What the window shows and no file holds.
struct JournalView {
    std::string workspace;
    std::optional<RegionId> region;
    std::optional<LayerId> photo;

    bool operator==(const JournalView&) const = default;
};

/// The document's file, and what is known of unsaved work from before.
struct JournalFile {
    std::string path;        ///< empty where it has none
    std::string formerTitle; ///< empty where there is none
    std::string formerPath;
    std::vector<std::int64_t>
        version; ///< that tells the file from what takes its place; empty when not known
    std::optional<std::uint64_t> clean; ///< the place in the undo list that lies in the file

    bool operator==(const JournalFile&) const = default;
};

/// Places in the undo list count all steps from the journal's beginning; 0 is the project before the first.
struct JournalStep {
    std::uint64_t place = 0;
    std::string text;
    std::optional<RegionId> systemOf;
};

} // namespace esm
