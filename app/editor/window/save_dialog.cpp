#include "app/editor/window/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace esm {

namespace {

bool mayReplace(QWidget* window, const QString& file) {
    QMessageBox box(QMessageBox::Question, QObject::tr("Replace file"),
                    QObject::tr("Replace %1?").arg(QFileInfo(file).fileName()), QMessageBox::Cancel, window);
    box.setObjectName(QStringLiteral("replaceBox"));
    box.setInformativeText(QObject::tr("It exists already. What it holds now would be lost."));
    QPushButton* replace = box.addButton(QObject::tr("&Replace"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == replace;
}

} // namespace

std::optional<std::filesystem::path> chooseNewFile(QWidget* window, const NewFile& wanted) {
    QFileDialog dialog(window, wanted.title, QFileInfo(wanted.suggestedPath).path(), wanted.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    // The dialog would ask about the name as it was typed, without its ending.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    dialog.selectFile(QFileInfo(wanted.suggestedPath).fileName());
    while (dialog.exec() == QDialog::Accepted) {
        QString file = dialog.selectedFiles().value(0);
        if (!file.endsWith(wanted.ending, Qt::CaseInsensitive)) file += wanted.ending;
        if (!QFileInfo::exists(file) || mayReplace(window, file))
            return std::filesystem::path(file.toStdString());
    }
    return std::nullopt;
}

} // namespace esm
