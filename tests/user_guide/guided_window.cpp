#include "tests/user_guide/guided_window.h"
#include "app/editor/workers/preview.h"
#include "core/project/project.h"
#include "widgets/view/organ_view.h"

#include <QApplication>
#include <QDockWidget>
#include <QTest>
#include <QTimer>

#include <cstdio>
#include <cstdlib>

namespace guide {

namespace {

constexpr int patience = 600'000; // ms
constexpr int calm = 1500;        // ms, in which layouts, numbers and the texture come to rest
constexpr QSize windowSize(1280, 800);

} // namespace

void waitFor(const char* what, const std::function<bool()>& condition) {
    if (QTest::qWaitFor(condition, patience)) return;
    std::fprintf(stderr, "Waited in vain for %s.\n", what);
    std::exit(1);
}

GuidedWindow::GuidedWindow(esm::Project project, std::filesystem::path folder)
    : m_folder(std::move(folder)), m_window(std::make_unique<esm::MainWindow>(std::move(project))) {
    m_window->resize(windowSize);
    m_window->show();
    settle();
}

void GuidedWindow::raise(const QString& name) {
    for (QTabBar* tabs : m_window->findChildren<QTabBar*>())
        for (int i = 0; i < tabs->count(); ++i)
            if (tabs->tabText(i) == name) tabs->setCurrentIndex(i);
    settle();
}

QPoint GuidedWindow::placeAt(double x, double y) {
    const QSize size = m_window->view().size();
    return {qRound(x * size.width()), qRound(y * size.height())};
}

void GuidedWindow::press(double x, double y) {
    QTest::mouseMove(&m_window->view(), placeAt(x, y));
    QTest::mousePress(&m_window->view(), Qt::LeftButton, {}, placeAt(x, y));
}

void GuidedWindow::drag(double x, double y) {
    QMouseEvent move(QEvent::MouseMove, placeAt(x, y), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&m_window->view(), &move);
    QTest::qWait(calm);
}

void GuidedWindow::release(double x, double y) {
    QTest::mouseRelease(&m_window->view(), Qt::LeftButton, {}, placeAt(x, y));
}

void GuidedWindow::settle() {
    QTest::qWait(calm);
    if (m_window->view().isVisible() && !m_window->preview().status().playing)
        waitFor("the picture of the organ", [this] { return m_window->view().isUpToDate(); });
}

void GuidedWindow::take(const char* name) {
    settle();
    save(*m_window, name);
}

void GuidedWindow::takeDialog(const char* name, const std::function<void()>& task,
                              const std::function<void(QDialog&)>& prepare) {
    QTimer looks;
    QObject::connect(&looks, &QTimer::timeout, [&] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (!dialog || dialog->objectName() == QLatin1String("progressDialog")) return;
        looks.stop();
        if (prepare) prepare(*dialog);
        QTest::qWait(calm);
        save(*dialog, name);
        dialog->reject();
    });
    looks.start(200);
    task();
}

void GuidedWindow::save(QWidget& shown, const char* name) {
    const QString file = QString::fromStdString((m_folder / name).string()) + QStringLiteral(".png");
    if (shown.grab().toImage().convertToFormat(QImage::Format_RGB888).save(file)) return;
    std::fprintf(stderr, "%s cannot be written.\n", qPrintable(file));
    std::exit(1);
}

} // namespace guide
