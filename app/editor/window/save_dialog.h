#pragma once

#include <QString>
#include <QWidget>

#include <filesystem>
#include <optional>

namespace esm {

struct NewFile {
    QString title, suggestedPath, filter;
    QString ending; ///< ".esm"; added to a name that does not end so
};

/// Asks where to write. The name is complete before the question whether an existing file may be replaced,
/// so that the file asked about is the file written. Nothing when the user gives up.
std::optional<std::filesystem::path> chooseNewFile(QWidget* window, const NewFile& wanted);

} // namespace esm
