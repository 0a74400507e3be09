#pragma once

#include "app/editor/document/document.h"
#include "core/exchange/journal/journal_facts.h"
#include "core/support/progress.h"

#include <QDateTime>
#include <QLockFile>

#include <memory>

namespace esm {

inline constexpr const char* journalEnding = ".journal";

/// Unsaved work of a program that ended before it could remove it: a journal, or a copy of a project that an
/// earlier version left. No other program takes it while this one looks at it.
struct LeftBehind {
    std::filesystem::path place;
    Former former; ///< of the document; empty where it is not known
    QDateTime written;
    std::shared_ptr<QLockFile> lock;
};

/// The latest first. Journals whose work was saved are removed. @throws Cancelled
std::vector<LeftBehind> leftBehindIn(const std::filesystem::path& folder, const Progress& progress = {});

void discard(const LeftBehind& left);

/// What comes back of it.
struct BroughtBack {
    DocumentState state;
    JournalView view;
    std::vector<std::string> warnings;
};

/// The latest state that can be read, with the steps around it that can be; a word tells of what is lost. A
/// file that has changed since is not the document's any more.
/// @throws FileError where nothing can be read, Cancelled
BroughtBack bringBack(const LeftBehind& left, const Progress& progress = {});

} // namespace esm
