#pragma once

#include "app/editor/document/journal.h"

#include <QWidget>

#include <optional>

namespace esm {

/// Offers the latest unsaved work that a sudden end of the program left behind, and brings it back where the
/// user wants it. Gives what the window showed of it then; none where nothing came back.
std::optional<JournalView> offerLeftBehind(QWidget& window, Document& document, Journal& journal);

} // namespace esm
