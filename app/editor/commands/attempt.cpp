#include "app/editor/commands/attempt.h"

#include "core/support/errors.h"

#include <QMessageBox>

namespace esm {

namespace {

void showProblem(QWidget* window, const QString& title, const QString& problem) {
    QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, window);
    box.setObjectName(QStringLiteral("problemBox"));
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
    } catch (const std::bad_alloc&) {
        showProblem(window, title, QObject::tr("There is not enough memory for this."));
    } catch (const std::exception& error) {
        showProblem(window, title, QString::fromStdString(error.what()));
    }
    return false;
}

} // namespace esm
