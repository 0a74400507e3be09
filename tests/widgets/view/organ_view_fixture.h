#pragma once

#include "tests/core/render/subjects.h"
#include "tests/support/eventually.h"
#include "widgets/view/organ_view.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include <optional>

namespace esm {

/// What is to be seen, once all is drawn.
inline QImage pictureOf(OrganView& view) {
    view.update();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view.isUpToDate(); }, patience));
    return view.grab().toImage();
}

/// A view of 600 × 450 pixels that shows a ball of 0.1 m.
class OrganViewTest : public testing::Test {
protected:
    void SetUp() override {
        qRegisterMetaType<Eigen::Vector3d>("Eigen::Vector3d");
        TriangleMesh mesh = ball(24, 36);
        for (Eigen::Vector3d& vertex : mesh.vertices)
            vertex *= 0.1;
        scene.network = edgeNetwork(mesh);
        scene.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
        view.resize(600, 450);
        view.setScene(scene);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view, patience));
        view.frameOrgan();
    }

    double aspect() const { return double(view.width()) / view.height(); }
    QPoint placeOf(const Eigen::Vector3d& point) const {
        const Eigen::Vector2d place = picturePoint(view.camera(), point, aspect()).value();
        return {qRound(place.x() * view.width()), qRound(place.y() * view.height())};
    }
    QPoint middle() const { return view.rect().center(); }
    void press(const QPoint& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&view, button, keys, at);
    }
    /// QTest::mouseMove carries no button, so a drag sends its own events.
    void moveTo(const QPoint& at, Qt::MouseButtons buttons = Qt::LeftButton,
                Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, keys);
        QApplication::sendEvent(&view, &event);
    }
    void release(const QPoint& at, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mouseRelease(&view, button, {}, at);
    }
    void wheel(const QPoint& at, int notches, Qt::KeyboardModifiers keys = {}) {
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
    }
    Eigen::Vector3d viewDirection() const { return (view.camera().eye - view.camera().target).normalized(); }
    double distance() const { return (view.camera().eye - view.camera().target).norm(); }

    RenderScene scene;
    ViewTool noTool;
    OrganView view;
};

} // namespace esm
