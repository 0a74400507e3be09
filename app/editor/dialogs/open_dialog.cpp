#include "app/editor/dialogs/open_dialog.h"

#include "app/editor/dialogs/ask.h"

#include <QFileDialog>

namespace esm {

QString fileName(const std::filesystem::path& file) {
    return QString::fromStdString(file.filename().string());
}

QString fileFilter(const QString& name, const std::vector<std::string>& endings) {
    QStringList patterns;
    for (const std::string& ending : endings)
        patterns << QStringLiteral("*.%1").arg(QString::fromStdString(ending));
    return QStringLiteral("%1 (%2)").arg(name, patterns.join(' '));
}

std::optional<std::filesystem::path> chooseFile(QWidget* window, const QString& title, FileKind kind,
                                                const QString& filter,
                                                const std::optional<std::filesystem::path>& project) {
    const QString chosen = ask(*window, [&] {
        return QFileDialog::getOpenFileName(window, title, startFolder(kind, project), filter);
    });
    if (chosen.isEmpty()) return std::nullopt;
    const std::filesystem::path file = chosen.toStdString();
    rememberFolder(kind, file);
    return file;
}

std::vector<std::filesystem::path> chooseFiles(QWidget* window, const QString& title, FileKind kind,
                                               const QString& filter,
                                               const std::optional<std::filesystem::path>& project) {
    const QStringList chosen = ask(*window, [&] {
        return QFileDialog::getOpenFileNames(window, title, startFolder(kind, project), filter);
    });
    std::vector<std::filesystem::path> files;
    files.reserve(static_cast<std::size_t>(chosen.size()));
    for (const QString& file : chosen)
        files.emplace_back(file.toStdString());
    if (!files.empty()) rememberFolder(kind, files.front());
    return files;
}

} // namespace esm
