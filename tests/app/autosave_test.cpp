#include "app/editor/document/autosave.h"

#include "core/exchange/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

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
        EXPECT_THAT(autosave.leftBehind(), testing::ElementsAre(left));
        autosave.takeOver(left);
        EXPECT_EQ(files().size(), 1U);
        EXPECT_FALSE(std::filesystem::exists(left));
        EXPECT_TRUE(autosave.leftBehind().empty());
    }
    EXPECT_TRUE(files().empty());
}

class LeftBehindTest : public EditorTest {};

TEST_F(LeftBehindTest, IsBroughtBackUnsaved) {
    const TemporaryFolder folder;
    Project lost = makeSample("tube");
    lost.base.mass = 0.75;
    saveProject(lost, folder / "left.esm");
    open(makeSample("liver"));
    Autosave autosave(window->document(), folder / "");
    dialogs.expectNamed("leftBehindBox", [](QDialog* box) { QTest::keyClick(box, Qt::Key_Return); });
    window->files().offerLeftBehind(autosave);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().base.mass, 0.75);
    EXPECT_TRUE(window->document().isModified());
    EXPECT_FALSE(std::filesystem::exists(folder / "left.esm"));
}
