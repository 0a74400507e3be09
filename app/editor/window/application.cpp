#include "app/editor/window/application.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/screen_room.h"

#include <QThread>

#include <exception>

namespace esm {

Application::Application(int& argc, char** argv) : QApplication(argc, argv) {
    keepWindowsOnScreen(*this);
}

bool Application::notify(QObject* receiver, QEvent* event) {
    if (QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception&) {
        tell(std::current_exception());
        return false;
    }
}

void Application::tell(const std::exception_ptr& problem) {
    // Drawing may fail again and again beneath the message.
    if (m_telling) return;
    m_telling = true;
    attempt(activeWindow(), tr("This could not be done"), [&] { std::rethrow_exception(problem); });
    m_telling = false;
}

} // namespace esm
