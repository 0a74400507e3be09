#include "app/editor/document/autosave.h"

#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <fstream>
#include <sys/stat.h>

using namespace esm;

namespace {

class AutosaveTest : public testing::Test {
protected:
    void setMass(double mass) {
        document.edit("mass", [mass](Project& p) { p.base.mass = mass; });
    }
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "copies"))
            if (entry.path().extension() == ".esm") found.push_back(entry.path());
        return found;
    }

    bool hasCopy() const { return std::filesystem::is_directory(folder / "copies") && !files().empty(); }

    TemporaryFolder folder;
    Document document{makeSample("tube")};
};

} // namespace

TEST_F(AutosaveTest, KeepsUnsavedWorkUntilItIsSaved) {
    Autosave autosave(document, folder / "copies");
    autosave.save();
    EXPECT_FALSE(std::filesystem::exists(folder / "copies"));
    setMass(0.5);
    autosave.save();
    autosave.finish();
    ASSERT_EQ(files().size(), 1U);
    EXPECT_EQ(loadProject(files()[0]).base.mass, 0.5);
    document.markSaved(folder / "tube.esm", document.project());
    autosave.save();
    EXPECT_TRUE(files().empty());
}

TEST_F(AutosaveTest, RemovesItsCopyAtTheEnd) {
    {
        Autosave autosave(document, folder / "copies");
        setMass(0.5);
        autosave.save();
    }
    EXPECT_TRUE(files().empty());
}

TEST_F(AutosaveTest, LeavesOtherRunningProgramsAlone) {
    Autosave running(document, folder / "copies");
    setMass(0.5);
    running.save();
    running.finish();
    Document other(makeSample("tube"));
    EXPECT_TRUE(Autosave(other, folder / "copies").leftBehind().empty());
}

TEST_F(AutosaveTest, FindsAndTakesOverWhatWasLeftBehind) {
    std::filesystem::create_directories(folder / "copies");
    const auto left = folder / "copies" / "left.esm";
    saveProject(document.project(), left);
    {
        Autosave autosave(document, folder / "copies");
        const auto found = autosave.leftBehind();
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].copy, left);
        autosave.takeOver(found[0]);
        EXPECT_EQ(files().size(), 1U);
        EXPECT_FALSE(std::filesystem::exists(left));
        EXPECT_TRUE(autosave.leftBehind().empty());
    }
    EXPECT_TRUE(files().empty());
}

TEST_F(AutosaveTest, WritesTheCopyOnceTheEditsRest) {
    using std::chrono::milliseconds;
    Autosave autosave(document, folder / "copies", nullptr, {milliseconds(50), milliseconds(60000)});
    setMass(0.5);
    setMass(0.75);
    ESM_EVENTUALLY(hasCopy());
    EXPECT_EQ(loadProject(files()[0]).base.mass, 0.75);
}

TEST_F(AutosaveTest, WritesNothingBeforeTheEditsRest) {
    using std::chrono::milliseconds;
    Autosave autosave(document, folder / "copies", nullptr, {milliseconds(60000), milliseconds(60000)});
    setMass(0.5);
    QTest::qWait(0);
    EXPECT_FALSE(std::filesystem::exists(folder / "copies"));
}

TEST_F(AutosaveTest, WritesTheCopyAmongEditsThatNeverRest) {
    using std::chrono::milliseconds;
    Autosave autosave(document, folder / "copies", nullptr, {milliseconds(60000), milliseconds(300)});
    double mass = 0.5;
    QTimer edits;
    QObject::connect(&edits, &QTimer::timeout, &document, [&] { setMass(mass += 0.001); });
    edits.start(10);
    ESM_EVENTUALLY(hasCopy());
}

TEST_F(AutosaveTest, KnowsTheTitleAndTheTimeOfWhatWasLeftBehind) {
    const auto left = folder / "copies" / "left.esm";
    const QDateTime before = QDateTime::currentDateTime();
    {
        Autosave autosave(document, folder / "copies");
        document.markSaved(folder / "my liver.esm", document.project());
        setMass(0.5);
        autosave.save();
        autosave.finish();
        // As if the program ended here: what is renamed stays.
        auto title = files()[0];
        std::filesystem::rename(title, left);
        for (const std::string ending : {".title", ".path"}) {
            title.replace_extension(ending);
            std::filesystem::rename(title, folder / "copies" / ("left" + ending));
        }
    }
    const Autosave next(document, folder / "copies");
    const auto found = next.leftBehind();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].former.title, "my liver.esm");
    EXPECT_EQ(found[0].former.path, folder / "my liver.esm");
    EXPECT_GE(found[0].written, before.addSecs(-2)) << "file systems round times";
    EXPECT_LE(found[0].written, QDateTime::currentDateTime());
    Autosave::discard(found[0]);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "copies"));
}

TEST_F(AutosaveTest, TriesAgainWhereTheCopyCouldNotBeWritten) {
    using std::chrono::milliseconds;
    Autosave autosave(document, folder / "copies", nullptr, {milliseconds(10), milliseconds(50)});
    std::ofstream(folder / "copies") << "no folder";
    setMass(0.5);
    autosave.save();
    autosave.finish();
    std::filesystem::remove(folder / "copies");
    ESM_EVENTUALLY(hasCopy());
    EXPECT_EQ(loadProject(files()[0]).base.mass, 0.5);
    Document other(makeSample("tube"));
    EXPECT_TRUE(Autosave(other, folder / "copies").leftBehind().empty()) << "it is in use";
}

TEST_F(AutosaveTest, TellsOnceThatNoCopyCanBeWrittenAndThatItCanAgain) {
    using std::chrono::milliseconds;
    Autosave autosave(document, folder / "copies", nullptr, {milliseconds(10), milliseconds(20)});
    QStringList failures, messages;
    QObject::connect(&autosave, &Autosave::failed, [&](const QString& reason) { failures << reason; });
    QObject::connect(&autosave, &Autosave::message, [&](const QString& text) { messages << text; });
    std::ofstream(folder / "copies") << "no folder";
    setMass(0.5);
    ESM_EVENTUALLY(!failures.isEmpty());
    EXPECT_TRUE(failures[0].contains("copies")) << failures[0].toStdString();
    setMass(0.75);
    autosave.save();
    autosave.finish();
    QApplication::processEvents();
    EXPECT_EQ(failures.size(), 1);
    EXPECT_TRUE(messages.isEmpty());
    std::filesystem::remove(folder / "copies");
    ESM_EVENTUALLY(failures.size() == 2);
    EXPECT_EQ(failures[1], "");
    EXPECT_EQ(messages.size(), 1);
    EXPECT_TRUE(hasCopy());
}

TEST_F(AutosaveTest, NeverLetsTheWindowWaitForADisk) {
    using std::chrono::milliseconds;
    Autosave autosave(document, folder / "copies", nullptr, {milliseconds(50), milliseconds(50)});
    setMass(0.5);
    autosave.save();
    autosave.finish();
    // Who writes into a pipe waits until somebody reads.
    auto pipe = files()[0];
    pipe.replace_extension(".title");
    std::filesystem::remove(pipe);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    setMass(0.75);
    autosave.save();
    document.markSaved(folder / "tube.esm", document.project());
    std::promise<void> returned;
    auto wasInTime = std::async(std::launch::async, [&pipe, done = returned.get_future()] {
        const bool inTime = done.wait_for(milliseconds(patience)) == std::future_status::ready;
        std::ifstream(pipe).get();
        return inTime;
    });
    autosave.save();
    returned.set_value();
    EXPECT_TRUE(wasInTime.get());
    ESM_EVENTUALLY(!hasCopy());
}

class LeftBehindTest : public EditorTest {};

TEST_F(LeftBehindTest, IsBroughtBackUnsaved) {
    const TemporaryFolder folder;
    Project lost = makeSample("tube");
    lost.base.mass = 0.75;
    saveProject(lost, folder / "left.esm");
    open(makeSample("liver"));
    Autosave autosave(window->document(), folder / "");
    std::ofstream(folder / "left.title") << "my liver.esm";
    std::ofstream(folder / "left.path") << (folder / "my liver.esm").string();
    dialogs.expectNamed("leftBehindBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("my liver.esm"));
        QTest::keyClick(box, Qt::Key_Return);
    });
    window->files().offerLeftBehind(autosave);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().base.mass, 0.75);
    EXPECT_TRUE(window->document().isModified());
    EXPECT_FALSE(std::filesystem::exists(folder / "left.esm"));

    EXPECT_EQ(window->document().title(), "my liver.esm");
    window->document().edit("mass", [](Project& p) { p.base.mass = 0.5; });
    autosave.save();
    autosave.finish();
    QStringList titles;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        if (entry.path().extension() == ".title") {
            std::ifstream in(entry.path());
            titles << QString::fromStdString({std::istreambuf_iterator<char>(in), {}});
        }
    EXPECT_EQ(titles, QStringList("my liver.esm")) << "lost twice, it still has its title";

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
    const TemporaryFolder folder;
    Project slip = makeSample("tube");
    SpringNetwork network = *slip.network;
    network.springs[3].restLength = 50;
    slip.network = std::make_shared<SpringNetwork>(network);
    saveProject(slip, folder / "left.esm");
    open(makeSample("liver"));
    Autosave autosave(window->document(), folder / "");
    dialogs.expectNamed("leftBehindBox", [](QDialog* box) { QTest::keyClick(box, Qt::Key_Return); });
    dialogs.expectNamed("remarkBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("rest length"));
        box->accept();
    });
    window->files().offerLeftBehind(autosave);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().network->springs[3].restLength, 50);
}
