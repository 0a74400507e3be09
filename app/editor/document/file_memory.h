#pragma once

#include <QStringList>

#include <filesystem>
#include <optional>

namespace esm {

/// The kinds of files that the user keeps in folders of their own.
enum class FileKind { Project, Mesh, Photo, Package, FuzzySystem, Landmarks, Lens };

/// Where the dialog for files of this kind starts: the folder last used for it, else the project's, else the
/// user's documents.
QString startFolder(FileKind kind, const std::optional<std::filesystem::path>& project);
void rememberFolder(FileKind kind, const std::filesystem::path& file);

/// Full paths of the projects and meshes that were opened last, the latest first. Kept in the settings.
QStringList recentFiles();
void addRecentFile(const std::filesystem::path& file);
void clearRecentFiles();

} // namespace esm
