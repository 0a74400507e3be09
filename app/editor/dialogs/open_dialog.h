#pragma once

#include "app/editor/document/file_memory.h"

#include <string>
#include <vector>

class QWidget;

namespace esm {

/// How texts call a file: without its folder.
QString fileName(const std::filesystem::path& file);

/// "Photos (*.png *.jpg)". @param endings without the dot
QString fileFilter(const QString& name, const std::vector<std::string>& endings);

/// Asks for a file that exists, in the folder last used for its kind, else the project's; nothing when the
/// user decides against it.
std::optional<std::filesystem::path> chooseFile(QWidget* window, const QString& title, FileKind kind,
                                                const QString& filter,
                                                const std::optional<std::filesystem::path>& project = {});
/// The same for any number of files; none when the user decides against it.
std::vector<std::filesystem::path> chooseFiles(QWidget* window, const QString& title, FileKind kind,
                                               const QString& filter,
                                               const std::optional<std::filesystem::path>& project = {});

} // namespace esm
