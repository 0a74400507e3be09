#pragma once

#include <QStringList>
#include <QWidget>

#include <filesystem>
#include <optional>

namespace esm {

struct NewFile {
    QString title, suggestedPath;
    /// "Projects (*.esm)", parted by ";;" where the user may choose.
    QString filter;
    /// ".esm"; of each filter, in the same order. A name that ends in none gets the chosen filter's.
    QStringList endings;
};

/// Asks where to write. The name is complete before the question whether an existing file may be replaced,
/// so that the file asked about is the file written. Nothing when the user gives up.
std::optional<std::filesystem::path> chooseNewFile(QWidget* window, const NewFile& wanted);

} // namespace esm
