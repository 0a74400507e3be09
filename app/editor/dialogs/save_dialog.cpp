#include "app/editor/dialogs/save_dialog.h"

#include "app/editor/dialogs/box_setup.h"
#include "app/editor/document/file_memory.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace esm {

namespace {

bool mayReplace(QWidget* window, const QString& file) {
    QMessageBox box(QMessageBox::Question, QObject::tr("Replace file"),
                    QObject::tr("Replace %1?").arg(QFileInfo(file).fileName()), QMessageBox::Cancel, window);
    setUpBox(box, "replaceBox");
    box.setInformativeText(QObject::tr("It exists already. What it holds now would be lost."));
    QPushButton* replace = box.addButton(QObject::tr("&Replace"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == replace;
}

bool hasEnding(const QString& file, const QStringList& endings) {
    return std::any_of(endings.begin(), endings.end(),
                       [&](const QString& ending) { return file.endsWith(ending, Qt::CaseInsensitive); });
}

QString withEnding(const QString& file, const QStringList& endings, int chosen) {
    return hasEnding(file, endings) ? file : file + endings.value(std::max(chosen, 0));
}

/// Without one of these; as it is where it has none.
QString withoutEnding(const QString& name, const QStringList& endings) {
    for (const QString& ending : endings)
        if (name.endsWith(ending, Qt::CaseInsensitive)) return name.chopped(ending.size());
    return name;
}

/// Takes the name of a folder that was written before for a name, where Qt's would step into it.
class NewFileDialog : public QFileDialog {
public:
    NewFileDialog(QWidget* window, const NewFile& wanted)
        : QFileDialog(window, wanted.title, QFileInfo(wanted.suggestedPath).path(), wanted.filter),
          m_endings(wanted.endings) {}

    void accept() override {
        const QString typed = selectedFiles().value(0);
        if (QFileInfo(typed).isDir() && hasEnding(typed, m_endings)) return done(QDialog::Accepted);
        QFileDialog::accept();
    }

private:
    QStringList m_endings;
};

} // namespace

QString suggestedPath(const Document& document, const QString& folder, const QString& ending) {
    return QDir(folder).filePath(QFileInfo(document.title()).completeBaseName() + ending);
}

NewFile fileForOthers(const Document& document, const QString& title, const QString& filter,
                      const QStringList& endings) {
    const QString folder = startFolder(FileKind::Package, document.path());
    return {title, suggestedPath(document, folder, endings.front()), filter, endings};
}

std::optional<ChosenFile> chooseNewFileAndKind(QWidget* window, const NewFile& wanted) {
    NewFileDialog dialog(window, wanted);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    // The dialog would ask about the name as it was typed, without its ending.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    dialog.selectFile(QFileInfo(wanted.suggestedPath).fileName());
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        const QString name = QFileInfo(dialog.selectedFiles().value(0)).fileName();
        dialog.selectFile(withoutEnding(name, wanted.endings) +
                          wanted.endings.value(dialog.nameFilters().indexOf(filter)));
    });
    while (dialog.exec() == QDialog::Accepted) {
        const int filter = dialog.nameFilters().indexOf(dialog.selectedNameFilter());
        const QString file = withEnding(dialog.selectedFiles().value(0), wanted.endings, filter);
        if (!QFileInfo(file).isFile() || mayReplace(window, file))
            return ChosenFile{std::filesystem::path(file.toStdString()), filter};
    }
    return std::nullopt;
}

std::optional<std::filesystem::path> chooseNewFile(QWidget* window, const NewFile& wanted) {
    const auto chosen = chooseNewFileAndKind(window, wanted);
    return chosen ? std::optional(chosen->path) : std::nullopt;
}

} // namespace esm
