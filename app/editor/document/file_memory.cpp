#include "app/editor/document/file_memory.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <array>

namespace esm {

namespace {

constexpr int mostRecentFiles = 8;

QString folderKey(FileKind kind) {
    constexpr std::array<const char*, 7> names{"project",     "mesh",      "photo", "package",
                                               "fuzzySystem", "landmarks", "lens"};
    return QStringLiteral("folders/") + QLatin1String(names[static_cast<std::size_t>(kind)]);
}

QString recentKey() {
    return QStringLiteral("recentFiles");
}

QFileInfo infoOf(const std::filesystem::path& file) {
    return QFileInfo(QString::fromStdString(file.string()));
}

} // namespace

QString startFolder(FileKind kind, const std::optional<std::filesystem::path>& project) {
    QString remembered = QSettings().value(folderKey(kind)).toString();
    // A stick or a share may be gone.
    if (!remembered.isEmpty() && QDir(remembered).exists()) return remembered;
    if (project) return infoOf(*project).absolutePath();
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents).exists() ? documents : QDir::homePath();
}

void rememberFolder(FileKind kind, const std::filesystem::path& file) {
    QSettings().setValue(folderKey(kind), infoOf(file).absolutePath());
}

QStringList recentFiles() {
    return QSettings().value(recentKey()).toStringList();
}

void addRecentFile(const std::filesystem::path& file) {
    const QString path = infoOf(file).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(recentKey(), QStringList(files.mid(0, mostRecentFiles)));
}

void clearRecentFiles() {
    QSettings().remove(recentKey());
}

} // namespace esm
