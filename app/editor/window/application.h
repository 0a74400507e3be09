#pragma once

#include <QApplication>

namespace esm {

/// The program. What goes wrong in answering an event is shown, and the program lives on with the unsaved
/// work in it.
class Application : public QApplication {
    Q_OBJECT

public:
    Application(int& argc, char** argv);

    bool notify(QObject* receiver, QEvent* event) override;

private:
    void tell(const std::exception_ptr& problem);

    bool m_telling = false;
};

} // namespace esm
