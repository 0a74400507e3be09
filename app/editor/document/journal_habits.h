#pragma once

#include "core/exchange/journal/journal_facts.h"

#include <chrono>
#include <cstdint>
#include <functional>

namespace esm {

/// How large a journal may become beside what it needs.
struct JournalBounds {
    /// Bytes of records, and of blobs, that may always be added, however little was last written as a whole.
    std::uint64_t leastGrowth = 32 << 20;
    /// Bytes of records; the first steps are left out where all would take more than half of it.
    std::uint64_t mostRecords = largestRecords / 2;
};

/// When a journal is written, and who watches it.
struct JournalHabits {
    /// Between two writings while a drag goes on, whose edits replace each other.
    std::chrono::milliseconds dragPause{250};
    /// After which it is tried again where it could not be written.
    std::chrono::milliseconds retryPause{10000};
    JournalBounds bounds{};
    /// Called on the writer's thread before tasks are written, and once they are on the disk, with the number
    /// of the last of them.
    std::function<void(std::uint64_t)> begins{}, synced{};
};

} // namespace esm
