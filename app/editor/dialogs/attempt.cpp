#include "app/editor/dialogs/attempt.h"

#include "app/editor/dialogs/box_setup.h"
#include "core/support/errors.h"

#include <QMessageBox>

namespace esm {

namespace {

void showProblem(QWidget* window, const QString& title, const QString& problem) {
    QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, window);
    setUpBox(box, "problemBox");
    box.setInformativeText(problem);
    box.exec();
}

} // namespace

bool attempt(QWidget* window, const QString& title, const std::function<void()>& action) {
    try {
        action();
        return true;
    } catch (const Cancelled&) {
        return false;
    } catch (const InvalidModel& error) {
        QStringList problems;
        for (const auto& problem : error.problems())
            problems << QString::fromStdString(problem);
        showProblem(window, title, problems.join('\n'));
    } catch (const std::exception& error) {
        showProblem(window, title, QString::fromStdString(reasonOf(error)));
    }
    return false;
}

void tell(QWidget* window, const QString& title, const std::vector<std::string>& remarks) {
    if (remarks.empty()) return;
    constexpr int mostLines = 10; // of what does not fit a box, the whole can be unfolded
    QStringList lines;
    for (const std::string& remark : remarks)
        lines << QString::fromStdString(remark);
    QMessageBox box(QMessageBox::Information, title, title, QMessageBox::Ok, window);
    setUpBox(box, "remarkBox");
    QStringList shown = lines.mid(0, mostLines);
    if (lines.size() > mostLines) {
        shown << QObject::tr("… and %n more", nullptr, lines.size() - mostLines);
        box.setDetailedText(lines.join('\n'));
    }
    box.setInformativeText(shown.join('\n'));
    box.exec();
}

} // namespace esm
