#include "app/editor/window/file_controller.h"
#include "app/editor/workers/preview.h"
#include "core/exchange/image_file.h"
#include "core/exchange/package/glb.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "core/support/file_lock.h"
#include "tests/app/editor_driver.h"
#include "tests/support/decode_with.h"
#include "tests/support/temporary_folder.h"

#include <QAbstractButton>
#include <QDropEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QRadioButton>

#include <fstream>

using namespace esm;

namespace {

class FileControllerTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }

    std::filesystem::path write(const std::string& name, const std::string& content) {
        std::ofstream(folder / name) << content;
        return folder / name;
    }
    std::string content(const std::string& name) {
        std::ifstream in(folder / name);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::filesystem::path tetrahedron() {
        return write("organ.obj",
                     "v 0 0 0\nv 90 0 0\nv 0 90 0\nv 0 0 90\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }
    void drop(const std::vector<std::filesystem::path>& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const auto& file : files)
            urls << QUrl::fromLocalFile(QString::fromStdString(file.string()));
        data.setUrls(urls);
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &enter);
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window.get(), &event);
    }
    void setMass(double mass) {
        window->document().edit("mass", [mass](Project& p) { p.base.mass = mass; });
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(FileControllerTest, KnowsWhereAFileIsThatWasNamedFromAFolder) {
    saveProject(makeSample("tube"), folder / "tube.esm");
    window->openFiles({std::filesystem::relative(folder / "tube.esm")});
    ASSERT_TRUE(window->document().path());
    EXPECT_TRUE(window->document().path()->is_absolute());
}

TEST_F(FileControllerTest, TellsWhatIsWrongWithAProjectThatOpensAllTheSame) {
    Project slip = makeSample("tube");
    SpringNetwork network = *slip.network;
    network.springs[3].restLength = 50;
    slip.network = std::make_shared<SpringNetwork>(network);
    saveProject(slip, folder / "slip.esm");
    dialogs.expectNamed("remarkBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("rest length"));
        box->accept();
    });
    window->openFiles({folder / "slip.esm"});
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().network->springs[3].restLength, 50);
}

TEST_F(FileControllerTest, SavesWhatIsTypedWhileTheCursorIsStillInTheField) {
    typeInto(massField(), "0.5");
    dialogs.expectFile(folder / "tube.esm");
    press(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(dialogs.isDone());
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 0.5);
    EXPECT_FALSE(window->document().isModified());
    typeInto(massField(), "0.75");
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 0.75);
}

TEST_F(FileControllerTest, AsksBeforeItReplacesWhatAnotherProgramHasSaved) {
    saveProject(makeSample("tube"), folder / "tube.esm");
    window->openFiles({folder / "tube.esm"});
    setMass(0.5);
    press(Qt::Key_S, Qt::ControlModifier);
    Project other = makeSample("tube");
    other.base.mass = 0.25;
    saveProject(other, folder / "tube.esm");
    setMass(0.75);
    dialogs.expectButton("changedFileBox", QMessageBox::Cancel);
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 0.25);
    EXPECT_TRUE(window->document().isModified());
    dialogs.expectNamed("changedFileBox", [](QDialog* box) {
        for (QAbstractButton* button : qobject_cast<QMessageBox*>(box)->buttons())
            if (button->text() == "&Replace") button->click();
    });
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 0.75);
    setMass(1);
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 1);
}

TEST_F(FileControllerTest, SavesNothingWhileAnotherProgramIsAboutToReplaceTheFile) {
    saveProject(makeSample("tube"), folder / "tube.esm");
    window->openFiles({folder / "tube.esm"});
    const double mass = project().base.mass;
    setMass(0.5);
    {
        const FileLock other(folder / "tube.esm");
        QString said;
        dialogs.expectNamed("problemBox", [&](QDialog* box) {
            said = qobject_cast<QMessageBox*>(box)->informativeText();
            box->accept();
        });
        press(Qt::Key_S, Qt::ControlModifier);
        EXPECT_TRUE(said.contains("is being changed by process")) << said.toStdString();
        EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, mass);
    }
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 0.5);
}

TEST_F(FileControllerTest, AsksAboutWhatIsTypedBeforeTheWindowCloses) {
    typeInto(massField(), "0.5");
    dialogs.expectButton("unsavedBox", QMessageBox::Cancel);
    press(Qt::Key_Q, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(window->isVisible());
    dialogs.expectButton("unsavedBox", QMessageBox::Save);
    dialogs.expectFile(folder / "tube.esm");
    EXPECT_TRUE(window->close());
    EXPECT_EQ(loadProject(folder / "tube.esm").base.mass, 0.5);
}

TEST_F(FileControllerTest, AsksAboutTheFileThatItWouldReplace) {
    write("liver.esm", "precious");
    dialogs.expectFile(folder / "liver");
    dialogs.expectButton("replaceBox", QMessageBox::Cancel);
    dialogs.expectFile(folder / "liver.v2");
    press(Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(dialogs.isDone());
    EXPECT_EQ(content("liver.esm"), "precious");
    EXPECT_FALSE(std::filesystem::exists(folder / "liver.v2"));
    EXPECT_EQ(loadProject(folder / "liver.v2.esm").name, project().name);
    EXPECT_EQ(window->document().path(), folder / "liver.v2.esm");
}

TEST_F(FileControllerTest, OpensWhatItSavedAMomentBefore) {
    setMass(0.5);
    ASSERT_TRUE(window->files().saveTo(folder / "tube.esm"));
    setMass(0.75);
    dialogs.expectButton("unsavedBox", QMessageBox::Save);
    window->openFiles({folder / "tube.esm"});
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().base.mass, 0.75);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(FileControllerTest, AsksBeforeAnImportedOrganIsLost) {
    const auto file = tetrahedron();
    dialogs.expectNamed("importDialog", [](QDialog* dialog) { dialog->accept(); });
    window->openFiles({file});
    ASSERT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().name, "organ");
    dialogs.expectButton("unsavedBox", QMessageBox::Cancel);
    EXPECT_FALSE(window->close());
}

TEST_F(FileControllerTest, ProposesToSaveAnImportedOrganBesideItsFile) {
    dialogs.expectNamed("importDialog", [](QDialog* dialog) { dialog->accept(); });
    window->openFiles({tetrahedron()});
    QString proposed;
    dialogs.expect([](QWidget* dialog) { return qobject_cast<QFileDialog*>(dialog) != nullptr; },
                   [&](QDialog* dialog) {
                       proposed = qobject_cast<QFileDialog*>(dialog)->selectedFiles().value(0);
                       dialog->reject();
                   });
    window->windowActions().save->trigger();
    EXPECT_EQ(proposed, QString::fromStdString((folder / "organ.esm").string()));
    EXPECT_FALSE(window->document().path());
}

TEST_F(FileControllerTest, LettersAnswerWhetherToSaveButNoneDiscards) {
    setMass(0.5);
    dialogs.expectNamed("unsavedBox", [](QDialog* box) {
        EXPECT_TRUE(QTest::qWaitForWindowActive(box, patience));
        QTest::keyClick(box, Qt::Key_D);
        EXPECT_TRUE(box->isVisible());
        QTest::keyClick(box, Qt::Key_C, Qt::AltModifier);
    });
    EXPECT_FALSE(window->files().mayLeaveProject());
    EXPECT_TRUE(dialogs.isDone());
}

TEST_F(FileControllerTest, OpensDroppedFilesOneAfterTheOther) {
    const std::vector<std::filesystem::path> files{write("first.esm", "x"), write("second.esm", "x")};
    QStringList said;
    for (std::size_t i = 0; i < files.size(); ++i)
        dialogs.expectNamed("problemBox", [&](QDialog* box) {
            QTest::qWait(0); // what opens beside it would open now
            EXPECT_EQ(QApplication::activeModalWidget(), box);
            said << qobject_cast<QMessageBox*>(box)->informativeText();
            box->accept();
        });
    drop(files);
    ESM_EVENTUALLY(dialogs.isDone() && said.size() == 2);
    EXPECT_TRUE(said[0].contains("first.esm"));
    EXPECT_TRUE(said[1].contains("second.esm"));
}

TEST_F(FileControllerTest, TakesADroppedProjectMeshAndPhoto) {
    Project stored = makeSample("ventricle");
    stored.base.mass = 0.25;
    saveProject(stored, folder / "stored.esm");
    drop({folder / "stored.esm"});
    ESM_EVENTUALLY(project().base.mass == 0.25);
    EXPECT_EQ(window->document().path(), folder / "stored.esm");

    const auto photo = makeSamplePhoto(samplePhotoNames().front());
    const auto picture = folder / "view.PNG";
    std::ofstream(picture, std::ios::binary)
        .write(reinterpret_cast<const char*>(photo->encoded.data()),
               static_cast<std::streamsize>(photo->encoded.size()));
    drop({picture});
    ESM_EVENTUALLY(project().layers.size() == 1);
    EXPECT_TRUE(window->windowActions().texture->isChecked());

    dialogs.expectNamed("importDialog", [](QDialog* dialog) { dialog->accept(); });
    dialogs.expectButton("unsavedBox", QMessageBox::Discard);
    drop({tetrahedron()});
    ESM_EVENTUALLY(project().name == "organ");
}

TEST_F(FileControllerTest, RefusesADropThatIsNoFile) {
    QMimeData text;
    text.setText("not a file");
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(window.get(), &enter);
    EXPECT_FALSE(enter.isAccepted());
    QMimeData page;
    page.setUrls({QUrl("https://example.org/liver.obj")});
    QDragEnterEvent far({10, 10}, Qt::CopyAction, &page, Qt::LeftButton, Qt::NoModifier);
    far.ignore();
    QApplication::sendEvent(window.get(), &far);
    EXPECT_FALSE(far.isAccepted());
}

TEST_F(FileControllerTest, EscapeInTheImportDialogLeavesEverythingAsItWas) {
    setMass(0.5);
    const auto network = project().network;
    dialogs.expectNamed("importDialog", [](QDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
    window->openFiles({tetrahedron()});
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_EQ(project().network, network);
    EXPECT_EQ(project().base.mass, 0.5);
    EXPECT_TRUE(window->document().isModified());
}

TEST_F(FileControllerTest, AnImportThatCannotBeMadeIsAskedAgainWithItsAnswers) {
    const auto network = project().network;
    dialogs.expectNamed("importDialog", [](QDialog* dialog) {
        dialog->findChild<QRadioButton*>("unit0")->click();       // millimetres: 90 of them
        dialog->findChild<QRadioButton*>("importBody2")->click(); // a wall of prisms
        dialog->findChild<NumberField*>("importThickness")->setValue(0.9);
        dialog->accept();
    });
    dialogs.expectNamed("problemBox", [&](QDialog* dialog) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(dialog)->informativeText().contains("too thick"));
        EXPECT_EQ(project().network, network);
        dialog->accept();
    });
    dialogs.expectNamed("importDialog", [](QDialog* dialog) {
        EXPECT_TRUE(dialog->findChild<QRadioButton*>("unit0")->isChecked());
        EXPECT_TRUE(dialog->findChild<QRadioButton*>("importBody2")->isChecked());
        EXPECT_EQ(dialog->findChild<NumberField*>("importThickness")->value(), 0.9);
        dialog->findChild<NumberField*>("importThickness")->setValue(0.01);
        dialog->findChild<QRadioButton*>("unit2")->click(); // the importer still answers
        ESM_EVENTUALLY(dialog->findChild<QLabel*>("importSize")->text() == "90.0 × 90.0 × 90.0 m");
        dialog->accept();
    });
    window->openFiles({tetrahedron()});
    EXPECT_TRUE(dialogs.isDone());
    ASSERT_TRUE(project().network->lattice);
    EXPECT_EQ(project().network->lattice->filling.wallThickness, 0.01);
}

TEST_F(FileControllerTest, StopsReadingAFileOnEscapeAndLeavesEverythingAsItWas) {
    const Image white{8, 8, Bytes(256, 255)};
    writePng(white, folder / "photo.png");
    Project withPhoto = makeSample("tube");
    withPhoto.layers.resize(1);
    withPhoto.layers[0].photo = decodePhoto("photo.png", encodePng(white));
    saveProject(withPhoto, folder / "photo.esm");
    write("decoder", "#!/bin/sh\nexec sleep 1000\n");
    std::filesystem::permissions(folder / "decoder", std::filesystem::perms::owner_all);
    const DecodeWith endless(folder / "decoder");
    const Project before = window->document().project();
    for (const auto& file : {tetrahedron(), folder / "photo.png", folder / "photo.esm"}) {
        int drawn = 0;
        QTimer::singleShot(0, [&drawn] { ++drawn; });
        dialogs.expectNamed("progressDialog",
                            [](QDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
        window->openFiles({file});
        EXPECT_TRUE(dialogs.isDone()) << file;
        EXPECT_GT(drawn, 0) << "the window was frozen meanwhile";
        EXPECT_EQ(window->document().project().mesh, before.mesh) << file;
        EXPECT_EQ(window->document().project().layers.size(), before.layers.size()) << file;
    }
}

TEST_F(FileControllerTest, AProjectOpensAsItWasLeft) {
    window->windowActions().texture->trigger();
    window->preview().setPlaying(false);
    ESM_EVENTUALLY(!window->preview().status().playing);
    ASSERT_TRUE(window->files().saveTo(folder / "left.esm"));
    EXPECT_FALSE(window->document().isModified());
    EXPECT_EQ(loadProject(folder / "left.esm").editor, (EditorState{Workspace::Texture, false}));
    window->windowActions().tissue->trigger();
    window->files().openSample("tube");
    ESM_EVENTUALLY(window->preview().status().playing);
    EXPECT_TRUE(window->windowActions().tissue->isChecked());
    window->files().openProject(folder / "left.esm");
    EXPECT_TRUE(window->windowActions().texture->isChecked());
    ASSERT_TRUE(window->files().saveTo(folder / "at once.esm"));
    EXPECT_EQ(loadProject(folder / "at once.esm").editor, (EditorState{Workspace::Texture, false}));
    ESM_EVENTUALLY(!window->preview().status().playing);
    EXPECT_FALSE(window->document().isModified());
}

TEST_F(FileControllerTest, ExportsPhotosAsJpegWhereThatTypeIsChosen) {
    writePng({8, 8, std::vector<std::uint8_t>(256, 255)}, folder / "photo.png");
    window->openFiles({folder / "photo.png"});
    const auto exportedAs = [&](const QString& filter, const std::string& name) {
        dialogs.expect([](QWidget* dialog) { return qobject_cast<QFileDialog*>(dialog) != nullptr; },
                       [&](QDialog* dialog) {
                           qobject_cast<QFileDialog*>(dialog)->selectNameFilter(filter);
                           auto* field = dialog->findChild<QLineEdit*>("fileNameEdit");
                           field->setText(QString::fromStdString((folder / name).string()));
                           QTest::keyClick(field, Qt::Key_Return);
                       });
        window->windowActions().exportPackage->trigger();
        return parseGlb(readFile(folder / (name + ".glb"))).json["images"][0]["mimeType"].get<std::string>();
    };
    EXPECT_EQ(exportedAs("Model packages (*.glb)", "exact"), "image/png");
    EXPECT_EQ(exportedAs("Model packages, texture as JPEG (*.glb)", "small"), "image/jpeg");
}
