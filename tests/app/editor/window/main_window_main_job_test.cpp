#include "app/editor/workers/preview.h"
#include "core/exchange/image_file.h"
#include "core/exchange/model_package.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"
#include "widgets/view/gizmos.h"

#include <QComboBox>
#include <QLabel>
#include <QRadioButton>
#include <QSlider>
#include <QToolButton>

#include <cmath>
#include <fstream>

using namespace esm;

namespace {

constexpr int rings = 18, around = 28;

/// An ellipsoid of 120 × 80 × 60 as OBJ.
void writeOrgan(const std::filesystem::path& file) {
    std::ofstream out(file);
    constexpr double pi = 3.14159265358979323846;
    const auto vertex = [&](double latitude, double longitude) {
        out << "v " << 60 * std::cos(latitude) * std::cos(longitude) << ' ' << 40 * std::sin(latitude) << ' '
            << 30 * std::cos(latitude) * std::sin(longitude) << '\n';
    };
    vertex(pi / 2, 0);
    for (int ring = 1; ring < rings; ++ring)
        for (int i = 0; i < around; ++i)
            vertex(pi / 2 - pi * ring / rings, 2 * pi * i / around);
    vertex(-pi / 2, 0);
    const auto index = [](int ring, int i) { return 2 + (ring - 1) * around + i % around; };
    for (int i = 0; i < around; ++i) {
        out << "f 1 " << index(1, i + 1) << ' ' << index(1, i) << '\n';
        for (int ring = 1; ring + 1 < rings; ++ring)
            out << "f " << index(ring, i) << ' ' << index(ring, i + 1) << ' ' << index(ring + 1, i + 1) << ' '
                << index(ring + 1, i) << '\n';
        const int last = 2 + (rings - 1) * around;
        out << "f " << last << ' ' << index(rings - 1, i) << ' ' << index(rings - 1, i + 1) << '\n';
    }
}

class MainJobTest : public EditorTest {
public:
    void importOrgan() {
        writeOrgan(folder / "organ.obj");
        dialogs.expectFile(folder / "organ.obj");
        dialogs.expectNamed("importDialog", [](QDialog* dialog) {
            QTest::mouseClick(dialog->findChild<QRadioButton*>("unit2"), Qt::LeftButton, {}, {8, 8});
            EXPECT_EQ(dialog->findChild<QLabel*>("importSize")->text(), "120 × 80.0 × 60.0 m");
            QTest::mouseClick(dialog->findChild<QRadioButton*>("unit0"), Qt::LeftButton, {}, {8, 8});
            EXPECT_EQ(dialog->findChild<QLabel*>("importSize")->text(), "120 × 80 × 60 mm");
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        press(Qt::Key_I, Qt::ControlModifier);
        ASSERT_TRUE(dialogs.isDone());
        ASSERT_EQ(project().network->restPositions.size(), std::size_t(2 + (rings - 1) * around));
        const Eigen::Vector3d size = boundingBox(project().mesh->vertices).sizes();
        EXPECT_LT((size - Eigen::Vector3d(0.12, 0.08, 0.06)).norm(), 1e-6);
        EXPECT_EQ(child<QLabel>("modelSize")->text(), "120 × 80 × 60 mm");
    }

    void softenRegion() {
        press(Qt::Key_R, Qt::ControlModifier);
        ASSERT_EQ(project().regions.size(), 1U);
        EXPECT_EQ(toolInHand(), "region") << "the ellipsoid can be dragged at once";
        EXPECT_GT(evaluateRegion(project(), project().regions[0]).nodes, 0U);
        auto* choice = child<QComboBox>("systemChoice");
        const auto first = project().regions[0].system;
        QTest::keyClick(choice, Qt::Key_Down);
        ASSERT_NE(project().regions[0].system, first);
        ASSERT_NE(project().regions[0].system, nullptr);
        const std::string variable = project().regions[0].system->inputs[0].name;
        auto* row = window->findChild<QWidget*>(QString::fromStdString("input-" + variable));
        ASSERT_NE(row, nullptr);
        auto* slider = row->findChild<QSlider*>();
        auto* words = row->findChild<QLabel*>("degrees");
        const QString wordsBefore = words->text();
        const auto springBefore =
            evaluateRegion(project(), project().regions[0]).tissue.values.springConstant;
        QTest::mouseClick(slider, Qt::LeftButton, {}, {slider->width() - 4, slider->height() / 2});
        QTest::keyClick(slider, Qt::Key_End);
        EXPECT_EQ(project().regions[0].inputs[0].second, project().regions[0].system->inputs[0].maximum);
        EXPECT_NE(words->text(), wordsBefore);
        const auto springNow = evaluateRegion(project(), project().regions[0]).tissue.values.springConstant;
        EXPECT_NE(springNow, springBefore);
    }

    void sizeRegion() {
        press(Qt::Key_E);
        ASSERT_EQ(toolInHand(), "region");
        const Ellipsoid before = *project().regions[0].ellipsoid;
        drag(placeOf(handles(before)[0]), {30, 0});
        const Ellipsoid after = *project().regions[0].ellipsoid;
        EXPECT_GT(after.radii.x(), 1.05 * before.radii.x());
        EXPECT_EQ(after.radii.tail<2>(), before.radii.tail<2>());
        EXPECT_EQ(after.centre, before.centre);
    }

    void pullTissue() {
        press(Qt::Key_V);
        ASSERT_EQ(toolInHand(), "look");
        press(Qt::Key_P);
        ASSERT_EQ(toolInHand(), "pull");
        ESM_EVENTUALLY(window->preview().status().playing && !window->view().scene().nodePositions.empty());
        const QPoint middle = window->view().rect().center();
        QTest::mousePress(&window->view(), Qt::LeftButton, {}, middle);
        moveMouse(middle + QPoint(40, -30));
        ASSERT_TRUE(window->preview().loads().pull);
        const std::uint32_t node = window->preview().loads().pull->node;
        moveMouse(middle + QPoint(80, -60));
        const auto moved = [&] {
            return (window->view().scene().nodePositions[node] - project().network->restPositions[node])
                .norm();
        };
        ESM_EVENTUALLY(moved() > 0.005);
        QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle + QPoint(80, -60));
        ESM_EVENTUALLY(moved() < 0.004);
        EXPECT_EQ(window->preview().status().failure, "");
    }

    void layPhoto() {
        writePng(makeSamplePhoto(samplePhotoNames().front())->image, folder / "photo.png");
        dialogs.expectFile(folder / "photo.png");
        press(Qt::Key_P, Qt::ControlModifier);
        ASSERT_TRUE(dialogs.isDone());
        EXPECT_TRUE(window->windowActions().texture->isChecked());
        ASSERT_EQ(toolInHand(), "projector");
        ASSERT_EQ(project().layers.size(), 1U);
        ASSERT_NE(project().atlas, nullptr);
        ESM_EVENTUALLY(window->view().scene().texturePages);
        const Image page = window->view().scene().texturePages->front().image();
        const auto& base = project().texture.baseColour;
        std::size_t painted = 0;
        for (std::size_t i = 0; i < page.pixels.size(); i += 4)
            painted += page.pixels[i] != base[0] || page.pixels[i + 1] != base[1];
        EXPECT_GT(painted, 1000U);
    }

    void sizePhoto() {
        const Projector before = project().layers[0].projector;
        drag(placeOf(handles(PhotoFace{before})[2]), {24, -12});
        const Projector after = project().layers[0].projector;
        EXPECT_GT(after.width, before.width);
        EXPECT_GT(after.height, before.height);
        const PhotoSize photo = sizeOf(project().layers[0].photo->image);
        const auto cornersBefore = photoCorners(before, photo, 0),
                   cornersAfter = photoCorners(after, photo, 0);
        double leastMoved = HUGE_VAL;
        for (std::size_t i = 0; i < 4; ++i)
            leastMoved = std::min(leastMoved, (cornersAfter[i] - cornersBefore[i]).norm());
        EXPECT_LT(leastMoved, 1e-9) << "the corner opposite to the dragged one stays";
    }

    void save() {
        dialogs.expectFile(folder / "organ.esm");
        press(Qt::Key_S, Qt::ControlModifier);
        ASSERT_TRUE(dialogs.isDone());
        EXPECT_FALSE(window->document().isModified());
    }

    void undoAndRedoAll(const Project& first) {
        const Project last = project();
        auto* steps = window->document().undoStack();
        const int count = steps->count();
        for (int i = 0; i < count; ++i)
            press(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_FALSE(steps->canUndo());
        EXPECT_FALSE(difference(first, project()).any());
        for (int i = 0; i < count; ++i)
            press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        EXPECT_FALSE(difference(last, project()).any());
        EXPECT_FALSE(window->document().isModified());
    }

    void reopen() {
        const Project saved = project();
        dialogs.expectFile(folder / "organ.esm");
        press(Qt::Key_O, Qt::ControlModifier);
        ASSERT_TRUE(dialogs.isDone());
        ASSERT_NE(project().mesh, saved.mesh);
        EXPECT_EQ(project().mesh->vertices, saved.mesh->vertices);
        ASSERT_EQ(project().regions.size(), 1U);
        EXPECT_EQ(project().regions[0].inputs, saved.regions[0].inputs);
        EXPECT_EQ(project().regions[0].ellipsoid->radii, saved.regions[0].ellipsoid->radii);
        ASSERT_EQ(project().layers.size(), 1U);
        EXPECT_EQ(project().layers[0].photo->encoded, saved.layers[0].photo->encoded);
        EXPECT_EQ(project().layers[0].projector.width, saved.layers[0].projector.width);
        EXPECT_EQ(project().layers[0].projector.pose.matrix(), saved.layers[0].projector.pose.matrix());
        ESM_EVENTUALLY(window->view().scene().texturePages);
    }

    void handOver() {
        dialogs.expectFile(folder / "organ.glb");
        press(Qt::Key_E, Qt::ControlModifier);
        ASSERT_TRUE(dialogs.isDone());
        EXPECT_TRUE(validatePackage(folder / "organ.glb").empty());
        EXPECT_EQ(loadPackage(folder / "organ.glb").preview.width, 512);
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(MainJobTest, GoesFromAMeshToAPackageAndBack) {
    open(makeSample("tube"));
    importOrgan();
    if (HasFatalFailure()) return;
    const Project imported = project();
    for (const auto step : {&MainJobTest::softenRegion, &MainJobTest::sizeRegion, &MainJobTest::pullTissue,
                            &MainJobTest::layPhoto, &MainJobTest::sizePhoto, &MainJobTest::save}) {
        (this->*step)();
        if (HasFatalFailure()) return;
    }
    undoAndRedoAll(imported);
    reopen();
    handOver();
    EXPECT_TRUE(window->close());
}

TEST_F(MainJobTest, ANewWindowMovesByItself) {
    open(makeSample("liver"));
    const auto largestMotion = [&] {
        const auto& now = window->view().scene().nodePositions;
        double largest = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            largest = std::max(largest, (now[i] - project().network->restPositions[i]).norm());
        return largest;
    };
    ESM_EVENTUALLY(largestMotion() > 0.005);
    press(Qt::Key_Space);
    ESM_EVENTUALLY(!window->preview().status().playing);
}
