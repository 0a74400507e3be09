#include "app/editor/document/file_memory.h"

#include "app/editor/window/file_controller.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QSettings>

using namespace esm;

namespace {

class FileMemoryTest : public EditorTest {
protected:
    void SetUp() override { QSettings().clear(); }
    void TearDown() override { QSettings().clear(); }

    QString pathOf(const std::string& name) const { return QString::fromStdString((folder / name).string()); }
    std::filesystem::path saved(const std::string& name, double mass) const {
        Project project = makeSample("tube");
        project.base.mass = mass;
        saveProject(project, folder / name);
        return folder / name;
    }
    QList<QAction*> recentEntries() const { return window->windowActions().recent->actions(); }

    TemporaryFolder folder;
};

} // namespace

TEST_F(FileMemoryTest, KeepsAFolderForEachKind) {
    std::filesystem::create_directories(folder / "photos");
    rememberFolder(FileKind::Photo, folder / "photos" / "view.jpg");
    rememberFolder(FileKind::Mesh, folder / "liver.obj");
    EXPECT_EQ(startFolder(FileKind::Photo, std::nullopt), pathOf("photos"));
    EXPECT_EQ(startFolder(FileKind::Mesh, std::nullopt), pathOf("").chopped(1));
}

TEST_F(FileMemoryTest, StartsBesideTheProjectWhereNothingWasUsedOrIsLeft) {
    const auto project = folder / "liver.esm";
    EXPECT_EQ(startFolder(FileKind::Package, project), pathOf("").chopped(1));
    rememberFolder(FileKind::Package, folder / "gone" / "liver.glb");
    EXPECT_EQ(startFolder(FileKind::Package, project), pathOf("").chopped(1));
    EXPECT_TRUE(QDir(startFolder(FileKind::Package, std::nullopt)).exists());
}

TEST_F(FileMemoryTest, KeepsTheLastEightFilesEachOnce) {
    for (int i = 0; i < 10; ++i)
        addRecentFile(folder / (std::to_string(i) + ".esm"));
    addRecentFile(folder / "5.esm");
    const QStringList files = recentFiles();
    ASSERT_EQ(files.size(), 8);
    EXPECT_EQ(files[0], pathOf("5.esm"));
    EXPECT_EQ(files[1], pathOf("9.esm"));
    EXPECT_EQ(files.count(pathOf("5.esm")), 1);
}

TEST_F(FileMemoryTest, OpensARecentProject) {
    const auto first = saved("first.esm", 0.5), second = saved("second.esm", 0.75);
    open(makeSample("tube"));
    ASSERT_EQ(recentEntries().size(), 1) << "that there is nothing yet";
    EXPECT_FALSE(recentEntries()[0]->isEnabled());
    window->openFiles({first, second});
    EXPECT_EQ(recentFiles(), (QStringList{pathOf("second.esm"), pathOf("first.esm")}));
    ASSERT_GT(recentEntries().size(), 2);
    EXPECT_TRUE(recentEntries()[1]->text().contains("first.esm"));
    recentEntries()[1]->trigger();
    ESM_EVENTUALLY(project().base.mass == 0.5);
    EXPECT_EQ(window->document().path(), first);
}

TEST_F(FileMemoryTest, TellsThatARecentFileIsAwayAndKeepsItsEntry) {
    const auto gone = saved("gone.esm", 0.5);
    open(makeSample("tube"));
    window->openFiles({gone});
    std::filesystem::remove(gone);
    dialogs.expectNamed("problemBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("gone.esm"));
        box->accept();
    });
    recentEntries()[0]->trigger();
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_EQ(recentFiles(), QStringList(pathOf("gone.esm")));
    EXPECT_TRUE(recentEntries()[0]->text().contains("gone.esm"));
}

TEST_F(FileMemoryTest, ForgetsAllRecentFilesWhenAsked) {
    open(makeSample("tube"));
    ASSERT_TRUE(window->files().saveTo(folder / "tube.esm"));
    EXPECT_EQ(recentFiles().size(), 1);
    recentEntries().last()->trigger();
    ESM_EVENTUALLY(recentFiles().isEmpty());
}
