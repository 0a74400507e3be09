#include "app/editor/window/photo_controller.h"

#include "core/exchange/image_file.h"
#include "core/samples/samples.h"
#include "core/support/angles.h"
#include "core/texture/projection/photo_reach.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QLabel>

#include <fstream>

using namespace esm;

namespace {

class PhotoControllerTest : public EditorTest {
protected:
    void SetUp() override {
        Project organ = makeSample("tube");
        organ.layers.clear();
        open(std::move(organ));
        for (const char* name : {"one.png", "two.png"})
            writePng(makeSamplePhoto("serosa")->image, folder / name);
        std::ofstream(folder / "bad.png") << "no picture";
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const TextureLayer& layer : project().layers)
            all.push_back(layer.name);
        return all;
    }
    /// As files that are dropped on the window, or named on the command line.
    void add(const std::vector<std::string>& files) const {
        std::vector<std::filesystem::path> paths;
        for (const std::string& file : files)
            paths.push_back(folder / file);
        window->openFiles(paths);
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(PhotoControllerTest, AddsAllFilesThatAreOpened) {
    add({"one.png", "two.png"});
    ESM_EVENTUALLY(project().layers.size() == 2);
    EXPECT_EQ(names(), (std::vector<std::string>{"two", "one"})) << "the first lies on top";
    EXPECT_EQ(window->document().undoStack()->count(), 1);
}

TEST_F(PhotoControllerTest, LaysSeveralSideBySideOnTheOrgan) {
    add({"one.png", "two.png", "one.png"});
    ESM_EVENTUALLY(project().layers.size() == 3);
    std::vector<Eigen::Vector3d> looks;
    for (const TextureLayer& layer : project().layers) {
        EXPECT_TRUE(mayMeet(layer.projector, sizeOf(*pictureOf(layer)), *project().mesh));
        looks.push_back(layer.projector.pose.linear().col(2));
    }
    const Camera camera = window->view().camera();
    EXPECT_TRUE(looks[2].isApprox(cameraAxes(camera).col(2), 1e-6)) << "the first from where one looks";
    EXPECT_NEAR(std::acos(looks[2].dot(looks[1])), toRadians(60), 1e-6) << "the second beside it";
    EXPECT_NEAR(std::acos(looks[2].dot(looks[0])), toRadians(60), 1e-6) << "the third on the other side";
    EXPECT_NEAR(std::acos(looks[1].dot(looks[0])), toRadians(120), 1e-6);
}

TEST_F(PhotoControllerTest, SaysOfAPhotoThatMissesTheOrgan) {
    add({"one.png"});
    ESM_EVENTUALLY(project().layers.size() == 1);
    const auto* miss = child<QLabel>("photoMisses");
    EXPECT_FALSE(miss->isVisible());
    window->document().edit("away", [](Project& edited) {
        edited.layers[0].projector.pose.translation() += Eigen::Vector3d(0, 5, 0);
    });
    ESM_EVENTUALLY(miss->isVisible());
    EXPECT_TRUE(miss->text().contains("misses the organ"));
}

TEST_F(PhotoControllerTest, SaysWhichPhotoCouldNotBeAdded) {
    QString said;
    dialogs.expectNamed("remarkBox", [&](QDialog* box) {
        said = qobject_cast<QMessageBox*>(box)->informativeText();
        box->accept();
    });
    add({"one.png", "bad.png", "two.png"});
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_TRUE(said.contains("bad.png")) << said.toStdString();
    EXPECT_EQ(names(), (std::vector<std::string>{"two", "one"}));
}

TEST_F(PhotoControllerTest, WhereNoneCanBeReadNothingIsAdded) {
    dialogs.expectNamed("problemBox", [](QDialog* box) { box->accept(); });
    add({"bad.png"});
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_TRUE(project().layers.empty());
    EXPECT_EQ(window->document().undoStack()->count(), 0);
}

TEST_F(PhotoControllerTest, ReplacesThePhotoAndKeepsItsPlace) {
    add({"one.png"});
    ESM_EVENTUALLY(project().layers.size() == 1);
    window->document().edit("crop", [](Project& edited) {
        edited.layers[0].landmarks.push_back({{10, 20}, {0, 0, 0}});
        edited.layers[0].name = "Mine";
    });
    const TextureLayer before = project().layers[0];
    const int steps = window->document().undoStack()->count();
    dialogs.expectFile(folder / "two.png");
    window->windowActions().replacePhoto->trigger();
    EXPECT_EQ(project().layers[0].photo->fileName, "two.png");
    EXPECT_EQ(project().layers[0].name, "Mine");
    EXPECT_EQ(project().layers[0].projector, before.projector);
    EXPECT_EQ(project().layers[0].landmarks, before.landmarks);
    EXPECT_EQ(window->document().undoStack()->count(), steps + 1);
    window->document().undoStack()->undo();
    EXPECT_EQ(project().layers[0], before);
}

TEST_F(PhotoControllerTest, AsksBeforeAPhotoOfAnotherShapeComes) {
    add({"one.png"});
    ESM_EVENTUALLY(project().layers.size() == 1);
    const Image& photo = project().layers[0].photo->image;
    const Image wide{
        2 * photo.width, photo.height,
        std::vector<std::uint8_t>(8 * std::size_t(photo.width) * std::size_t(photo.height), 255)};
    writePng(wide, folder / "wide.png");
    dialogs.expectFile(folder / "wide.png");
    dialogs.expectButton("replacePhotoBox", QMessageBox::Cancel);
    window->windowActions().replacePhoto->trigger();
    EXPECT_EQ(project().layers[0].photo->fileName, "one.png");
    const double width = project().layers[0].projector.width;
    dialogs.expectFile(folder / "wide.png");
    dialogs.expectNamed("replacePhotoBox", [](QDialog* box) { QTest::keyClick(box, Qt::Key_R); });
    window->windowActions().replacePhoto->trigger();
    EXPECT_EQ(project().layers[0].photo->fileName, "wide.png");
    EXPECT_NEAR(project().layers[0].projector.width, 2 * width, 1e-9);
}

TEST_F(PhotoControllerTest, APhotoThatCannotBeReadReplacesNothing) {
    add({"one.png"});
    ESM_EVENTUALLY(project().layers.size() == 1);
    dialogs.expectFile(folder / "bad.png");
    dialogs.expectNamed("problemBox", [](QDialog* box) { box->accept(); });
    window->windowActions().replacePhoto->trigger();
    EXPECT_EQ(project().layers[0].photo->fileName, "one.png");
}
