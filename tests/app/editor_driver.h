#pragma once

#include "app/editor/document/document.h"
#include "app/editor/edits/system_reach.h"
#include "app/editor/window/main_window.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "tests/support/eventually.h"
#include "widgets/inputs/number_field.h"
#include "widgets/view/organ_view.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTest>
#include <QTimer>

#include <deque>
#include <functional>

/// The height of a widget once its layout has come to rest: what changes a layout is put in the queue of
/// events, and may put more there.
inline int settledHeight(const QWidget* widget) {
    int height = -1;
    for (int same = 0; same < 5;) {
        QTest::qWait(0);
        same = widget->height() == height ? same + 1 : 0;
        height = widget->height();
    }
    return height;
}

/// Answers modal dialogs in the order in which they are expected, as a user would.
class DialogScript : public QObject {
public:
    DialogScript() {
        QObject::connect(&m_timer, &QTimer::timeout, this, [this] { answerNext(); });
        m_timer.start(20);
    }

    /// The next dialog that `is` recognises is answered.
    void expect(const std::function<bool(QWidget*)>& is, const std::function<void(QDialog*)>& answer) {
        m_steps.push_back({is, answer});
    }
    void expectNamed(const QString& name, const std::function<void(QDialog*)>& answer) {
        expect([name](QWidget* dialog) { return dialog->objectName() == name; }, answer);
    }
    void expectFile(const std::filesystem::path& file) {
        expect([](QWidget* dialog) { return qobject_cast<QFileDialog*>(dialog) != nullptr; },
               [file](QDialog* dialog) {
                   auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
                   ASSERT_NE(name, nullptr);
                   name->setText(QString::fromStdString(file.string()));
                   QTest::keyClick(name, Qt::Key_Return);
               });
    }
    void expectButton(const QString& name, QMessageBox::StandardButton button) {
        expectNamed(name, [=](QDialog* box) { qobject_cast<QMessageBox*>(box)->button(button)->click(); });
    }
    bool isDone() const { return m_steps.empty(); }

private:
    struct Step {
        std::function<bool(QWidget*)> is;
        std::function<void(QDialog*)> answer;
    };

    void answerNext() {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (m_steps.empty() || !dialog || !dialog->isVisible() || !m_steps.front().is(dialog)) return;
        const Step step = m_steps.front();
        m_steps.pop_front();
        step.answer(dialog);
    }

    std::deque<Step> m_steps;
    QTimer m_timer;
};

/// The editor's window on a display, with keys and mouse.
class EditorTest : public testing::Test {
protected:
    void open(esm::Project project) {
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        window = std::make_unique<esm::MainWindow>(std::move(project));
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), patience));
        QApplication::setActiveWindow(window.get());
    }
    /// A key as a keyboard sends it: to the widget that has the focus.
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QApplication::setActiveWindow(window.get());
        QWidget* focus = window->focusWidget();
        QTest::keyClick(focus ? focus : window.get(), Qt::Key(key), modifiers);
    }
    /// A region whose tissue is said in the words of a published system, which has sliders for its outputs.
    void addPublishedRegion() {
        press(Qt::Key_R, Qt::ControlModifier);
        window->document().edit("system", [](esm::Project& project) {
            esm::Region& added = project.regions.back();
            added.system = std::make_shared<const esm::FuzzySystem>(esm::fuzzyPreset("susilap-g"));
            added.inputs = {{"consistency", 6}};
        });
    }
    /// Types into a number field and leaves the cursor in it.
    void typeInto(esm::NumberField* field, const QString& text) {
        QApplication::setActiveWindow(window.get());
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        ASSERT_TRUE(field->isModified());
    }
    /// Whoever edits a fuzzy system that several regions use means all of them, and is not asked.
    void meanEveryRegion() const {
        window->findChild<esm::SystemReach*>()->setQuestion(
            [](const auto&, const auto&) { return esm::Reach::EveryRegion; });
    }
    esm::NumberField* massField() const {
        for (auto* field : window->findChildren<esm::NumberField*>())
            if (field->accessibleName() == QLatin1String("Base mass")) return field;
        return nullptr;
    }
    /// Its name in the table.
    QString toolInHand() const { return window->view().tool().objectName(); }
    const esm::Project& project() const { return window->document().project(); }
    template<typename Widget> Widget* child(const char* name) const {
        return window->findChild<Widget*>(name);
    }
    /// A way to look at the fuzzy system.
    void chooseTab(const QString& name) const {
        auto* tabs = child<QTabBar>("workbenchTabs");
        for (int tab = 0; tab < tabs->count(); ++tab)
            if (tabs->tabText(tab) == name) tabs->setCurrentIndex(tab);
        ASSERT_EQ(tabs->tabText(tabs->currentIndex()), name);
    }
    /// Where a point of the organ's space is seen in the view.
    QPoint placeOf(const Eigen::Vector3d& point) const {
        const QSize size = window->view().size();
        const auto place =
            esm::picturePoint(window->view().camera(), point, double(size.width()) / size.height());
        return place ? QPoint(qRound(place->x() * size.width()), qRound(place->y() * size.height()))
                     : QPoint(-1, -1);
    }
    void drag(const QPoint& from, const QPoint& by) {
        QTest::mousePress(&window->view(), Qt::LeftButton, {}, from);
        moveMouse(from + by / 2);
        moveMouse(from + by);
        QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, from + by);
    }
    void moveMouse(const QPoint& at) {
        QMouseEvent event(QEvent::MouseMove, at, window->view().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QApplication::sendEvent(&window->view(), &event);
    }

    DialogScript dialogs;
    std::unique_ptr<esm::MainWindow> window;
};
