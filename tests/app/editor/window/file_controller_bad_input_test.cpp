#include "app/editor/window/file_controller.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QMessageBox>
#include <QPushButton>

#include <fstream>

using namespace esm;

namespace {

class BadInputTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }

    std::filesystem::path write(const std::string& name, const std::string& content) {
        std::ofstream(folder / name) << content;
        return folder / name;
    }
    /// Opens a file and gives the message that says why it cannot be.
    std::string messageOf(const std::filesystem::path& file) {
        QString said;
        dialogs.expectNamed("problemBox", [&](QDialog* dialog) {
            said = qobject_cast<QMessageBox*>(dialog)->informativeText();
            dialog->accept();
        });
        window->openFiles({file});
        EXPECT_TRUE(dialogs.isDone());
        return said.toStdString();
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(BadInputTest, EachBadFileIsNamedAndNothingChanges) {
    const Project before = project();
    const std::vector<std::filesystem::path> files{folder / "missing.obj",
                                                   write("empty.stl", ""),
                                                   write("nothing.obj", "# none\n"),
                                                   write("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                                                   write("broken.esm", "PK not a zip"),
                                                   write("broken.png", "no picture"),
                                                   write("unknown.xyz", "?")};
    for (const auto& file : files) {
        const std::string message = messageOf(file);
        EXPECT_NE(message.find(file.filename().string()), std::string::npos) << file << ": " << message;
        EXPECT_FALSE(difference(before, project()).any()) << file;
        EXPECT_FALSE(window->document().isModified()) << file;
    }
}

TEST_F(BadInputTest, ASaveThatFailsLeavesTheChangesUnsaved) {
    window->document().edit("mass", [](Project& p) { p.base.mass *= 2; });
    dialogs.expectNamed("problemBox", [](QDialog* dialog) { dialog->accept(); });
    EXPECT_FALSE(window->files().saveTo(folder / "no such folder" / "x.esm"));
    EXPECT_TRUE(window->document().isModified());
    dialogs.expectNamed("unsavedBox", [](QDialog* dialog) {
        qobject_cast<QMessageBox*>(dialog)->button(QMessageBox::Cancel)->click();
    });
    EXPECT_FALSE(window->close());
    dialogs.expectNamed("unsavedBox", [](QDialog* dialog) {
        qobject_cast<QMessageBox*>(dialog)->button(QMessageBox::Discard)->click();
    });
    EXPECT_TRUE(window->close());
}
