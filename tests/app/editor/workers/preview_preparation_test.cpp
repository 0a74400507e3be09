#include "app/editor/workers/preview.h"
#include "core/samples/samples.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>
#include <QScopeGuard>
#include <QTest>

#include <atomic>

using namespace esm;

namespace {

/// Keeps a thread waiting. Outlives the thread.
class Gate {
public:
    void open() {
        m_isOpen = true;
        m_isOpen.notify_all();
    }
    void wait() const { m_isOpen.wait(false); }

private:
    std::atomic<bool> m_isOpen = false;
};

} // namespace

TEST(Preview, MovesOnByTheFormerParametersWhileNewOnesArePrepared) {
    Gate gate;
    Preview preview;
    const auto opening = qScopeGuard([&gate] { gate.open(); });
    Project tube = makeSample("tube");
    preview.setProject(tube);
    preview.setGentleMotion(true);
    preview.setPlaying(true);
    ESM_EVENTUALLY(preview.frame().project == 1 && preview.status().realTimeFactor > 0);
    // Announced on the thread that prepares, before it factorises.
    QObject::connect(
        &preview, &Preview::tissueReady, &preview, [&gate] { gate.wait(); }, Qt::DirectConnection);
    tube.base.viscosity *= 2;
    preview.setProject(tube);
    for (int i = 0; i < 3; ++i) {
        const std::vector<Eigen::Vector3d> positions = preview.frame().positions;
        ESM_EVENTUALLY(preview.frame().positions != positions);
        EXPECT_EQ(preview.frame().project, 1);
    }
    gate.open();
    ESM_EVENTUALLY(preview.frame().project == 2);
}

TEST(Preview, PreparesOfQuickChangesTheFirstAndTheLast) {
    Gate gate;
    std::atomic<int> prepared = 0;
    Preview preview;
    const auto opening = qScopeGuard([&gate] { gate.open(); });
    QObject::connect(
        &preview, &Preview::tissueReady, &preview,
        [&] {
            ++prepared;
            gate.wait();
        },
        Qt::DirectConnection);
    Project tube = makeSample("tube");
    preview.setProject(tube);
    ESM_EVENTUALLY(prepared == 1);
    for (int change = 2; change <= 10; ++change) {
        tube.base.mass *= 1.1;
        preview.setProject(tube);
    }
    gate.open();
    ESM_EVENTUALLY(preview.frame().project == 10);
    EXPECT_EQ(prepared, 2);
    EXPECT_EQ(preview.tissue()->mass, evaluateModel(tube).mass);
}

TEST(Preview, PutsToRestAndPlaysTheProjectThatCameBefore) {
    Project tube = makeSample("tube"), liver = makeSample("liver");
    liver.scene.duration = 0.1;
    liver.scene.forces = {{20, {0, 0, 0.01}, 0, 0.1}};
    Preview preview;
    preview.setProject(tube);
    ESM_EVENTUALLY(preview.frame().project == 1);
    preview.setProject(liver);
    preview.playScene();
    // In this order: before it begins it does not play either.
    ESM_EVENTUALLY(preview.frame().project == 2 &&
                   preview.frame().positions != liver.network->restPositions && !preview.status().playing);
    EXPECT_EQ(preview.frame().network, liver.network);
}
