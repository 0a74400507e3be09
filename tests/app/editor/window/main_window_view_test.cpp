#include "app/editor/window/view_settings.h"
#include "app/editor/workers/preview.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QComboBox>
#include <QSlider>
#include <QTemporaryDir>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// What is shown of an organ at rest, and from where.
class MainWindowViewTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("liver"));
        window->preview().setPlaying(false);
        ESM_EVENTUALLY(window->preview().frame().project == window->preview().projectCount() &&
                       !window->preview().status().playing);
        QCoreApplication::processEvents(); // the view hears of the tissue
    }
    OrganView& view() { return window->view(); }
    const Camera& camera() { return view().camera(); }
    const RenderScene& scene() { return view().scene(); }
    const Actions& actions() { return window->windowActions(); }
    Vector3d middle() const { return boundingBox(project().mesh->vertices).center(); }
    /// The part of the view's height that a box takes.
    double shareOf(const Eigen::AlignedBox3d& box) {
        return box.diagonal().norm() / pictureHeightAt(camera(), box.center());
    }
};

} // namespace

TEST_F(MainWindowViewTest, FramesTheSelectedRegionAndWithoutOneTheOrgan) {
    const Eigen::AlignedBox3d organ = boundingBox(project().mesh->vertices);
    press(Qt::Key_R, Qt::ControlModifier);
    window->document().edit("edit", [](Project& edited) {
        edited.regions.back().ellipsoid->radii = Vector3d::Constant(0.01);
        edited.regions.back().rim = 0.002;
    });
    const Vector3d centre = project().regions.back().ellipsoid->centre;
    press(Qt::Key_F);
    EXPECT_TRUE(camera().target.isApprox(centre, 1e-9));
    EXPECT_GT(shareOf({centre.array() - 0.012, centre.array() + 0.012}), 0.3);
    EXPECT_GT(shareOf(organ), 2);
    press(Qt::Key_Home);
    const Camera whole = camera();
    window->document().edit("edit", [](Project& edited) { edited.regions.clear(); });
    press(Qt::Key_F);
    EXPECT_TRUE(camera().target.isApprox(whole.target, 1e-9));
    EXPECT_LT(shareOf(organ), 2);
}

TEST_F(MainWindowViewTest, OrthographicKeepsTheFramingAndStandardViewsKeepIt) {
    press(Qt::Key_4);
    const double height = pictureHeightAt(camera(), camera().target);
    press(Qt::Key_T);
    ASSERT_TRUE(camera().orthographicHeight);
    EXPECT_NEAR(*camera().orthographicHeight, height, 1e-9);
    press(Qt::Key_5);
    EXPECT_TRUE(camera().orthographicHeight) << "stays so";
    press(Qt::Key_T);
    EXPECT_FALSE(camera().orthographicHeight);
}

TEST_F(MainWindowViewTest, LooksFromWithinAndComesBack) {
    press(Qt::Key_1);
    const Camera before = camera();
    press(Qt::Key_W);
    ASSERT_TRUE(view().isWithin());
    EXPECT_TRUE(actions().lookFromWithin->isChecked());
    EXPECT_TRUE(boundingBox(project().mesh->vertices).contains(camera().eye));
    const Vector3d eye = camera().eye;
    actions().tool("look")->trigger();
    drag(view().rect().center(), {60, 20});
    EXPECT_EQ(camera().eye, eye) << "the mouse looks around";
    EXPECT_TRUE(view().isWithin());
    press(Qt::Key_W);
    EXPECT_FALSE(view().isWithin());
    EXPECT_TRUE(camera().eye.isApprox(before.eye)) << "to where it was";
    press(Qt::Key_W);
    press(Qt::Key_Home);
    EXPECT_FALSE(actions().lookFromWithin->isChecked());
    EXPECT_NEAR(camera().verticalFieldOfView, before.verticalFieldOfView, 1e-12);
}

TEST_F(MainWindowViewTest, PullsFromWithin) {
    press(Qt::Key_1);
    press(Qt::Key_W);
    ASSERT_TRUE(view().isWithin());
    QTest::mousePress(&view(), Qt::LeftButton, {}, view().rect().center());
    moveMouse(view().rect().center() + QPoint(30, 0));
    EXPECT_TRUE(window->preview().loads().pull) << "the wall before the eye";
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, view().rect().center());
}

TEST_F(MainWindowViewTest, ColoursByEachOfItsKinds) {
    std::map<QString, std::vector<Paint>> paints;
    for (QAction* colouring : actions().colourings->actions()) {
        colouring->trigger();
        const bool isPainted = scene().nodePaint != nullptr;
        EXPECT_EQ(isPainted, colouring->objectName() != "texture") << colouring->objectName().toStdString();
        if (isPainted) paints[colouring->objectName()] = *scene().nodePaint;
    }
    const auto differs = [&](const char* one, const char* other) { return paints[one] != paints[other]; };
    EXPECT_TRUE(differs("spring-constant", "viscosity"));
    EXPECT_TRUE(differs("spring-constant", "region"));
    EXPECT_TRUE(differs("viscosity", "region"));
    EXPECT_TRUE(differs("spring-constant", "strain"));
    actions().colourings->actions().front()->trigger();
    press(Qt::Key_S);
    EXPECT_TRUE(scene().springPaint) << "springs by their constant";
}

TEST_F(MainWindowViewTest, CutsOpenWhereTheBarSays) {
    EXPECT_FALSE(child<QSlider>("cutShare")->isVisible());
    press(Qt::Key_X);
    ASSERT_TRUE(scene().cut);
    EXPECT_TRUE(child<QSlider>("cutShare")->isVisible());
    child<QComboBox>("cutSide")->setCurrentIndex(int(CutSide::Right));
    child<QSlider>("cutShare")->setValue(250);
    const Eigen::AlignedBox3d organ = organBox(*project().mesh, *project().network);
    EXPECT_TRUE(scene().cut->normal.isApprox(Vector3d::UnitX()));
    EXPECT_NEAR(scene().cut->offset, organ.max().x() - 0.25 * organ.sizes().x(), 1e-12);
    child<QComboBox>("cutSide")->setCurrentIndex(int(CutSide::Viewer));
    press(Qt::Key_4);
    EXPECT_TRUE(scene().cut->normal.isApprox(Vector3d::UnitX(), 1e-9)) << "goes along with the eye";
    press(Qt::Key_5);
    EXPECT_TRUE(scene().cut->normal.isApprox(Vector3d::UnitY(), 1e-9));
    press(Qt::Key_X);
    EXPECT_FALSE(scene().cut);
}

TEST_F(MainWindowViewTest, ShowsPartsByTheirKeysAndHidesTissueBeneathPhotos) {
    press(Qt::Key_U);
    press(Qt::Key_L);
    press(Qt::Key_N);
    EXPECT_FALSE(scene().showSurface);
    EXPECT_TRUE(scene().showWireframe);
    EXPECT_TRUE(scene().showNodes);
    press(Qt::Key_2, Qt::ControlModifier);
    EXPECT_FALSE(scene().showNodes);
    EXPECT_FALSE(actions().showNodes->isEnabled());
    EXPECT_TRUE(actions().showNodes->toolTip().contains("Tissue"));
    press(Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(scene().showNodes);
}

TEST_F(MainWindowViewTest, RemembersWhatWasShown) {
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    for (QAction* action : {actions().showWireframe, actions().orthographic, actions().showRegions})
        action->trigger();
    actions().colourings->actions().back()->trigger();
    saveView(settings, actions());
    open(makeSample("tube"));
    restoreView(settings, actions());
    EXPECT_TRUE(scene().showWireframe);
    EXPECT_TRUE(camera().orthographicHeight);
    EXPECT_FALSE(actions().showRegions->isChecked());
    EXPECT_EQ(actions().colourings->checkedAction()->objectName(), "region");
}

namespace {

/// A liver with a photo of either kind, seen in the workspace Texture.
class LookedThrough : public MainWindowViewTest {
protected:
    void lay(ProjectorKind kind) {
        Project project = makeSample("liver");
        project.layers.resize(1);
        project.layers[0].photo = makeSamplePhoto("serosa");
        Projector& projector = project.layers[0].projector;
        projector.kind = kind;
        projector.pose.translation() =
            boundingBox(project.mesh->vertices).center() + Eigen::Vector3d(0, 0.3, 0);
        projector.pose.linear() = Eigen::AngleAxisd(-1.57, Eigen::Vector3d::UnitX()).toRotationMatrix();
        open(project);
        press(Qt::Key_2, Qt::ControlModifier);
    }
    const Projector& projector() const { return project().layers[0].projector; }
    Eigen::Vector3d ahead() { return (camera().target - camera().eye).normalized(); }
};

} // namespace

TEST_F(LookedThrough, APhotoIsAndTheFormerViewComesBack) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        lay(kind);
        const Camera before = camera();
        press(Qt::Key_C, Qt::ShiftModifier);
        EXPECT_TRUE(ahead().isApprox(-projector().pose.linear().col(2), 1e-6));
        EXPECT_EQ(camera().orthographicHeight.has_value(), kind == ProjectorKind::Parallel);
        if (kind == ProjectorKind::Perspective) {
            EXPECT_TRUE(camera().eye.isApprox(projector().pose.translation()));
        }
        EXPECT_TRUE(actions().lookThroughPhoto->isChecked());
        EXPECT_FALSE(actions().orthographic->isChecked()) << "what the user chose";
        press(Qt::Key_C, Qt::ShiftModifier);
        EXPECT_EQ(camera(), before);
        EXPECT_FALSE(actions().lookThroughPhoto->isChecked());
    }
}

TEST_F(LookedThrough, TheViewGoesAlongWithAPhotoThatIsSetByNumbers) {
    lay(ProjectorKind::Perspective);
    const Camera before = camera();
    press(Qt::Key_C, Qt::ShiftModifier);
    const auto move = [&] {
        window->document().edit(
            "move", [](Project& project) { project.layers[0].projector.pose.translation().x() += 0.01; });
    };
    move();
    EXPECT_TRUE(camera().eye.isApprox(projector().pose.translation()));
    press(Qt::Key_Home);
    EXPECT_NEAR(camera().verticalFieldOfView, before.verticalFieldOfView, 1e-12) << "its own lens is back";
    const Camera whole = camera();
    move();
    EXPECT_EQ(camera(), whole) << "nobody looks through it any more";
}

TEST_F(LookedThrough, TheOrganIsSeenBareUntilAPhotoIsEdited) {
    lay(ProjectorKind::Parallel);
    ESM_EVENTUALLY(!scene().atlas || scene().texturePages);
    press(Qt::Key_B);
    EXPECT_TRUE(actions().showBare->isChecked());
    EXPECT_FALSE(scene().texturePages);
    EXPECT_TRUE(scene().projectors.empty());
    EXPECT_TRUE(window->view().hint().startsWith("Before")) << window->view().hint().toStdString();
    window->document().edit("fade", [](Project& project) { project.layers[0].opacity = 0.5; });
    EXPECT_FALSE(actions().showBare->isChecked());
    EXPECT_EQ(scene().projectors.size(), 1U);
}
