#pragma once

#include "app/editor/document/document.h"

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

/// A path in a folder, under the document's name.
QString suggestedPath(const Document& document, const QString& folder, const QString& ending);

/// For what others take over: where the user last wrote such a file, under the document's name.
NewFile fileForOthers(const Document& document, const QString& title, const QString& filter,
                      const QStringList& endings);

struct ChosenFile {
    std::filesystem::path path;
    int filter; ///< place of the one that was chosen in `NewFile::filter`
};

/// Asks where to write. The name is complete before the question whether an existing file may be replaced,
/// so that the file asked about is the file written. Nothing when the user gives up.
std::optional<ChosenFile> chooseNewFileAndKind(QWidget* window, const NewFile& wanted);

/// The same for who offers one kind, or tells them by their endings.
std::optional<std::filesystem::path> chooseNewFile(QWidget* window, const NewFile& wanted);

} // namespace esm
