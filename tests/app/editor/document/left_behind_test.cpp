#include "app/editor/document/journal.h"
#include "app/editor/document/left_behind.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor/document/random_edits.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QDir>

#include <fstream>

using namespace esm;

namespace {

class LeftBehindTest : public EditorTest {
protected:
    void acceptOffer() {
        dialogs.expectNamed("leftBehindBox", [this](QDialog* box) {
            offer = qobject_cast<QMessageBox*>(box)->informativeText();
            QTest::keyClick(box, Qt::Key_Return);
        });
    }
    /// A journal as a program leaves it that is killed.
    void leave(const std::function<void(Document&, Selection&, Journal&)>& work) {
        Document lost(projectToEdit());
        Selection selection(lost);
        Journal journal(lost, selection, folder / "running");
        work(lost, selection, journal);
        journal.finish();
        for (const auto& entry : std::filesystem::directory_iterator(folder / "running"))
            if (entry.is_directory())
                std::filesystem::copy(entry.path(), folder / "recovery" / "left.journal",
                                      std::filesystem::copy_options::recursive);
    }
    void SetUp() override {
        std::filesystem::create_directories(folder / "recovery");
        open(makeSample("liver"));
        selection = std::make_unique<Selection>(window->document());
        journal = std::make_unique<Journal>(window->document(), *selection, folder / "recovery");
    }

    TemporaryFolder folder;
    std::unique_ptr<Selection> selection;
    std::unique_ptr<Journal> journal;
    QString offer;
};

} // namespace

TEST_F(LeftBehindTest, ComesBackWithUndoListWorkspaceAndSelection) {
    RegionId region;
    leave([&](Document& lost, Selection& chosen, Journal& kept) {
        for (const char* name : {"first", "second"}) {
            lost.edit("Rename", [&](Project& project) { project.name = name; });
        }
        region = lost.project().regions.front().id;
        lost.undoStack()->undo();
        chosen.setRegion(region);
        chosen.setPhoto(lost.project().layers.front().id);
        kept.setWorkspace("texture");
    });
    acceptOffer();
    window->offerLeftBehind(*journal);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(offer.contains("first")) << offer.toStdString();
    EXPECT_EQ(project().name, "first");
    EXPECT_TRUE(window->windowActions().texture->isChecked());
    EXPECT_TRUE(window->document().isModified());
    EXPECT_TRUE(window->document().undoStack()->canRedo());
    EXPECT_EQ(window->document().undoStack()->undoText(), "Rename");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(project().name, projectToEdit().name);
    ESM_EVENTUALLY(!std::filesystem::exists(folder / "recovery" / "left.journal"));
}

TEST_F(LeftBehindTest, GoesWhereItIsDiscarded) {
    leave([](Document& lost, Selection&, Journal&) {
        lost.edit("Rename", [](Project& project) { project.name = "lost"; });
    });
    dialogs.expectButton("leftBehindBox", QMessageBox::Discard);
    window->offerLeftBehind(*journal);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(std::filesystem::is_empty(folder / "recovery"));
}

TEST_F(LeftBehindTest, StaysForTheNextStartWhereItIsLeftForLater) {
    leave([](Document& lost, Selection&, Journal&) {
        lost.edit("Rename", [](Project& project) { project.name = "lost"; });
    });
    const std::string before = project().name;
    dialogs.expectNamed("leftBehindBox", [](QDialog* box) { QTest::keyClick(box, Qt::Key_Escape); });
    window->offerLeftBehind(*journal);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().name, before);
    EXPECT_TRUE(std::filesystem::exists(folder / "recovery" / "left.journal"));
    acceptOffer();
    window->offerLeftBehind(*journal);
    EXPECT_EQ(project().name, "lost");
}

TEST_F(LeftBehindTest, ComesBackUnsavedFromACopyOfAnEarlierVersion) {
    Project lost = makeSample("tube");
    lost.base.mass = 0.75;
    const auto recovery = folder / "recovery";
    saveProject(lost, recovery / "left.esm");
    std::ofstream(recovery / "left.title") << "my liver.esm";
    std::ofstream(recovery / "left.path") << (folder / "my liver.esm").string();
    acceptOffer();
    window->offerLeftBehind(*journal);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(offer.contains("my liver.esm"));
    EXPECT_EQ(project().base.mass, 0.75);
    EXPECT_TRUE(window->document().isModified());
    EXPECT_EQ(window->document().title(), "my liver.esm");
    for (const char* left : {"left.esm", "left.title", "left.path"})
        ESM_EVENTUALLY(!std::filesystem::exists(recovery / left));

    EXPECT_FALSE(window->document().path()) << "nothing is replaced unasked";
    EXPECT_EQ(window->document().proposedPath(), folder / "my liver.esm");
    dialogs.expect([](QWidget* dialog) { return qobject_cast<QFileDialog*>(dialog) != nullptr; },
                   [&](QDialog* dialog) {
                       EXPECT_EQ(dialog->findChild<QLineEdit*>("fileNameEdit")->text(), "my liver.esm");
                       EXPECT_EQ(qobject_cast<QFileDialog*>(dialog)->directory(),
                                 QDir(QString::fromStdString(folder.path().string())));
                       dialog->reject();
                   });
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
}

TEST_F(LeftBehindTest, TellsWhatIsWrongWithIt) {
    Project slip = makeSample("tube");
    SpringNetwork network = *slip.network;
    network.springs[3].restLength = 50;
    slip.network = std::make_shared<SpringNetwork>(network);
    saveProject(slip, folder / "recovery" / "left.esm");
    acceptOffer();
    dialogs.expectNamed("remarkBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("rest length"));
        box->accept();
    });
    window->offerLeftBehind(*journal);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().network->springs[3].restLength, 50);
}

TEST_F(LeftBehindTest, IsOfferedBeforeTheFilesOfTheCommandLineAreOpened) {
    Project lost = makeSample("tube");
    lost.base.mass = 0.75;
    std::filesystem::create_directories(recoveryFolder());
    saveProject(lost, recoveryFolder() / "left.esm");
    saveProject(makeSample("ventricle"), folder / "asked for.esm");
    acceptOffer();
    dialogs.expectButton("unsavedBox", QMessageBox::Cancel);
    window->start({folder / "asked for.esm"});
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_EQ(project().base.mass, 0.75);
    EXPECT_FALSE(window->document().path());
    EXPECT_TRUE(window->document().isModified());
}
