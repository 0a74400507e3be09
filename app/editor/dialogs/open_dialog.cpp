#include "app/editor/dialogs/open_dialog.h"

#include "app/editor/dialogs/ask.h"

#include <QFileDialog>

namespace esm {

std::optional<std::filesystem::path> chooseFile(QWidget* window, const QString& title, FileKind kind,
                                                const QString& filter) {
    const QString chosen = ask(*window, [&] {
        return QFileDialog::getOpenFileName(window, title, startFolder(kind, std::nullopt), filter);
    });
    if (chosen.isEmpty()) return std::nullopt;
    const std::filesystem::path file = chosen.toStdString();
    rememberFolder(kind, file);
    return file;
}

} // namespace esm
