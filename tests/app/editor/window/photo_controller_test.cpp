#include "app/editor/window/photo_controller.h"

#include "core/exchange/image_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

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
    /// As files are dropped on the window.
    void drop(const std::vector<std::string>& files) const {
        QMimeData data;
        QList<QUrl> urls;
        for (const std::string& file : files)
            urls << QUrl::fromLocalFile(QString::fromStdString((folder / file).string()));
        data.setUrls(urls);
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &event);
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(PhotoControllerTest, AddsAllFilesThatAreDropped) {
    drop({"one.png", "two.png"});
    ESM_EVENTUALLY(project().layers.size() == 2);
    EXPECT_EQ(names(), (std::vector<std::string>{"two", "one"})) << "the first lies on top";
    EXPECT_EQ(window->document().undoStack()->count(), 1);
}

TEST_F(PhotoControllerTest, SaysWhichPhotoCouldNotBeAdded) {
    QString said;
    dialogs.expectNamed("remarkBox", [&](QDialog* box) {
        said = qobject_cast<QMessageBox*>(box)->informativeText();
        box->accept();
    });
    drop({"one.png", "bad.png", "two.png"});
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_TRUE(said.contains("bad.png")) << said.toStdString();
    EXPECT_EQ(names(), (std::vector<std::string>{"two", "one"}));
}

TEST_F(PhotoControllerTest, WhereNoneCanBeReadNothingIsAdded) {
    dialogs.expectNamed("problemBox", [](QDialog* box) { box->accept(); });
    drop({"bad.png"});
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_TRUE(project().layers.empty());
    EXPECT_EQ(window->document().undoStack()->count(), 0);
}
