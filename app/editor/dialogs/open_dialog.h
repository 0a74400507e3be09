#pragma once

#include "app/editor/document/file_memory.h"

class QWidget;

namespace esm {

/// Asks for a file that exists, in the folder last used for its kind; nothing when the user decides against
/// it.
std::optional<std::filesystem::path> chooseFile(QWidget* window, const QString& title, FileKind kind,
                                                const QString& filter);

} // namespace esm
