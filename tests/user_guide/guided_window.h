#pragma once

#include "app/editor/window/main_window.h"

#include <QTabBar>

#include <memory>

namespace guide {

/// The program's window, used as a reader of the guide uses it, and pictures of it.
class GuidedWindow {
public:
    /// @param folder where pictures are written
    GuidedWindow(esm::Project project, std::filesystem::path folder);

    esm::MainWindow& window() { return *m_window; }
    QAction* tool(const char* name) { return m_window->windowActions().tool(QString::fromLatin1(name)); }
    template<class Widget> Widget& part(const char* name) {
        return *m_window->findChild<Widget*>(QString::fromLatin1(name));
    }

    /// Brings a column or a tab of this name to the front.
    void raise(const QString& name);
    /// At a place of the view, from 0 to 1 each way.
    void press(double x, double y);
    void drag(double x, double y);
    void release(double x, double y);

    /// Until the picture of the organ shows what there is to show.
    void settle();
    void take(const char* name);
    /// Of the dialog that a task opens, before it is closed again.
    void takeDialog(const char* name, const std::function<void()>& task,
                    const std::function<void(QDialog&)>& prepare = {});

private:
    QPoint placeAt(double x, double y);
    void save(QWidget& shown, const char* name);

    std::filesystem::path m_folder;
    std::unique_ptr<esm::MainWindow> m_window;
};

/// Ends the program where it does not come about.
void waitFor(const char* what, const std::function<bool()>& condition);

} // namespace guide
