#include "app/editor/panels/measure/virtual_test_panel.h"

#include "app/editor/panels/measure/press_view.h"
#include "core/authoring/regions.h"
#include "core/exchange/project/tissue_preset_file.h"
#include "core/support/file_io.h"
#include "tests/app/editor/panels/measure/pressed_organ.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

class VirtualTestPanelTest : public PressedOrgan {
protected:
    explicit VirtualTestPanelTest(const Detail& detail = {Detail::Kind::Nodes, 500})
        : PressedOrgan(detail), panel(document, test), view(document, test) {
        panel.resize(276, 700);
        view.resize(900, 320);
        for (QWidget* widget : std::initializer_list<QWidget*>{&panel, &view}) {
            widget->show();
            EXPECT_TRUE(QTest::qWaitForWindowExposed(widget, patience));
        }
    }

    QPushButton& button(const char* name) {
        auto* found = panel.findChild<QPushButton*>(name);
        return *(found ? found : view.findChild<QPushButton*>(name));
    }
    QPushButton& buttonSaying(const QString& text) {
        for (auto* found : view.findChildren<QPushButton*>())
            if (found->text() == text) return *found;
        throw std::out_of_range(text.toStdString());
    }
    QString said(const char* name) { return panel.findChild<QLabel*>(name)->text(); }
    void type(const char* name, const QString& text) {
        auto* field = panel.findChild<NumberField*>(name);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void chooseTest(int row) {
        auto* list = panel.findChild<QComboBox*>("fingerTest");
        list->setCurrentIndex(row);
        emit list->activated(row);
    }
    bool isShown(const char* name) { return panel.findChild<QWidget*>(name)->isVisible(); }
    QString drawn() { return view.findChild<CurveChart*>()->spokenValue(); }

    VirtualTestPanel panel;
    PressView view;
};

TEST_F(VirtualTestPanelTest, SaysWhyNothingCanBeDoneYet) {
    awaitTissue();
    ESM_EVENTUALLY(button("pressButton").toolTip() == "Choose a place on the organ first");
    for (const char* name : {"pressButton", "cancelPress", "keepPress", "clearPress"}) {
        EXPECT_FALSE(button(name).isEnabled()) << name;
        EXPECT_FALSE(button(name).toolTip().isEmpty()) << name;
    }
    EXPECT_FALSE(buttonSaying("Save table…").isEnabled());
    EXPECT_EQ(said("pressForce"), QString(QChar(0x2013)));
    constexpr int columnWidth = 256; // with room for a scroll bar
    EXPECT_LE(panel.minimumSizeHint().width(), columnWidth);
}

TEST_F(VirtualTestPanelTest, EnterInAFieldPressesAndTheCurveArrives) {
    test.choosePlace(placeIn(5));
    awaitTissue();
    ESM_EVENTUALLY(button("pressButton").isEnabled());
    type("fingerDepth", "1.5");
    EXPECT_TRUE(button("cancelPress").isEnabled());
    ESM_EVENTUALLY(test.latest() != nullptr);
    EXPECT_EQ(said("pressDepth"), "1.50");
    EXPECT_NE(said("pressForce"), QString(QChar(0x2013)));
    EXPECT_NE(said("equivalentModulus"), QString(QChar(0x2013)));
    EXPECT_EQ(said("pressForceBefore"), QString(QChar(0x2013)));
    EXPECT_THAT(drawn().toStdString(), testing::StartsWith("1.50 mm: "));
    EXPECT_FALSE(button("cancelPress").isEnabled());
    type("fingerRadius", "none");
    EXPECT_FALSE(test.isPressing()) << "what is no number is not pressed with";
}

TEST_F(VirtualTestPanelTest, CancelStopsAndSaysNothing) {
    test.choosePlace(placeIn(5));
    awaitTissue();
    ESM_EVENTUALLY(button("pressButton").isEnabled());
    button("pressButton").click();
    ASSERT_TRUE(test.isPressing());
    button("cancelPress").click();
    EXPECT_FALSE(button("cancelPress").isEnabled());
    EXPECT_EQ(said("pressMessage"), "");
    EXPECT_EQ(said("pressForce"), QString(QChar(0x2013)));
}

TEST_F(VirtualTestPanelTest, ShowsTheCoresSentenceInThePanel) {
    test.choosePlace(placeIn(5));
    awaitTissue();
    type("fingerDepth", "900");
    ESM_EVENTUALLY(said("pressMessage").contains("press less deep"));
    EXPECT_TRUE(said("pressMessage").front().isUpper());
    EXPECT_TRUE(panel.findChild<QLabel*>("pressMessage")->property("warning").toBool());
    type("fingerDepth", "1");
    ESM_EVENTUALLY(test.latest() && said("pressMessage").isEmpty());
}

TEST_F(VirtualTestPanelTest, ShowsBeforeAndAfterAndSaysWhatIsOld) {
    test.choosePlace(placeIn(5));
    measure();
    const QString soft = said("pressForce");
    stiffen();
    ESM_EVENTUALLY(said("pressMessage").contains("before the last change"));
    EXPECT_EQ(said("pressForce"), soft);
    measure();
    EXPECT_EQ(said("pressForceBefore"), soft);
    EXPECT_EQ(said("pressMessage"), "");
    EXPECT_THAT(drawn().toStdString(), testing::HasSubstr("; before, "));
    button("clearPress").click();
    EXPECT_EQ(said("pressForceBefore"), QString(QChar(0x2013)));
    button("keepPress").click();
    EXPECT_FALSE(button("keepPress").isEnabled());
    test.choosePlace(placeIn(6));
    measure();
    EXPECT_THAT(said("pressMessage").toStdString(), testing::HasSubstr("another place"));
}

TEST_F(VirtualTestPanelTest, SaysHowThePressureWithinSwellsTheOrgan) {
    document.edit("press", [](Project& project) { project.scene.pressures = {{0, {{0, 5}}}}; });
    test.choosePlace(placeIn(5));
    measure();
    EXPECT_THAT(said("pressMessage").toStdString(),
                testing::ContainsRegex("Under the pressure within, part 1 has 1[0-9][0-9] % of its volume"));
    document.edit("press", [](Project& project) { project.scene.pressures = {{0, {{0, 1e6}}}}; });
    ESM_EVENTUALLY(test.isOutdated());
    measure();
    EXPECT_THAT(said("pressMessage").toStdString(), testing::HasSubstr("bursts part 1"));
}

TEST_F(VirtualTestPanelTest, SaysThatItPressesFromOutsideWhereTheInsideWasClicked) {
    awaitTissue();
    test.choosePlace(placeIn(5), true);
    EXPECT_THAT(said("pressMessage").toStdString(), testing::HasSubstr("from outside"));
    test.choosePlace(placeIn(5));
    EXPECT_EQ(said("pressMessage"), "");
}

TEST_F(VirtualTestPanelTest, SaysWhatIsPublishedOfTheTissueAtThePlace) {
    test.choosePlace(placeIn(5));
    EXPECT_EQ(said("publishedModulus"), "");
    document.edit("preset", [&](Project& project) {
        project.regions.clear();
        applyPreset(project, document.newRegionId(), tissuePreset("liver"));
    });
    ESM_EVENTUALLY(said("publishedModulus") == "Liver, published: 5.49 kPa");
    EXPECT_THAT(panel.findChild<QLabel*>("publishedModulus")->toolTip().toStdString(),
                testing::HasSubstr("3.3 to 7.8 kPa"));
}

TEST_F(VirtualTestPanelTest, AsksForWhatEachKindOfTestNeedsAndNothingMoves) {
    const int height = panel.sizeHint().height();
    const QPoint below = panel.findChild<QWidget*>("fingerDuration")->mapTo(&panel, QPoint());
    EXPECT_FALSE(panel.findChild<NumberField*>("fingerDuration")->isEnabled());
    EXPECT_THAT(panel.findChild<NumberField*>("fingerDuration")->toolTip().toStdString(),
                testing::HasSubstr("at rest"));
    chooseTest(1);
    EXPECT_TRUE(isShown("fingerDepth"));
    EXPECT_FALSE(isShown("fingerForce"));
    EXPECT_TRUE(panel.findChild<NumberField*>("fingerDuration")->isEnabled());
    EXPECT_EQ(button("pressButton").text(), "Press and stay");
    chooseTest(2);
    EXPECT_FALSE(isShown("fingerDepth"));
    EXPECT_TRUE(isShown("fingerForce"));
    EXPECT_EQ(panel.findChild<QLabel*>("pushForce")->text(), QString(QChar(0x2013)));
    ESM_EVENTUALLY(panel.findChild<QWidget*>("fingerDuration")->mapTo(&panel, QPoint()) == below);
    EXPECT_EQ(panel.sizeHint().height(), height);
}

TEST_F(VirtualTestPanelTest, SavesTableAndChartOfBothCurves) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    test.choosePlace(placeIn(5));
    measure();
    stiffen();
    measure();
    const TemporaryFolder folder;
    const auto save = [&](const char* what, const char* name) {
        DialogScript dialogs;
        dialogs.expectFile(folder / name);
        buttonSaying(what).click();
        EXPECT_TRUE(dialogs.isDone());
        const Bytes bytes = readFile(folder / name);
        return std::string(bytes.begin(), bytes.end());
    };
    const std::string table = save("Save table…", "press.csv");
    EXPECT_THAT(table, testing::StartsWith("name,depth_m,force_n\nnow,0,0\n"));
    EXPECT_THAT(table, testing::HasSubstr("\nbefore,0.001,"));
    EXPECT_THAT(save("Save chart…", "press.png"), testing::StartsWith("\x89PNG"));
    EXPECT_THAT(save("Save chart…", "press.svg"), testing::HasSubstr(">before<"));
}

class VirtualTestPanelInTime : public VirtualTestPanelTest {
protected:
    VirtualTestPanelInTime() : VirtualTestPanelTest(solidDetail()) {}
};

TEST_F(VirtualTestPanelInTime, ShowsHowTheFingerSinksInAndSavesIt) {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    test.choosePlace(placeIn(5));
    awaitTissue();
    chooseTest(2);
    type("fingerForce", "50 mN");
    type("fingerDuration", "2");
    ESM_EVENTUALLY(test.latest() && !test.isPressing());
    EXPECT_EQ(said("pushForce"), "0.0500");
    EXPECT_NE(said("pushRestDepth"), QString(QChar(0x2013)));
    EXPECT_NE(said("pushTissueTime"), QString(QChar(0x2013)));
    EXPECT_THAT(drawn().toStdString(), testing::StartsWith("2.00 s: "));
    const TemporaryFolder folder;
    DialogScript dialogs;
    dialogs.expectFile(folder / "push.csv");
    buttonSaying("Save table…").click();
    const Bytes bytes = readFile(folder / "push.csv");
    EXPECT_THAT(std::string(bytes.begin(), bytes.end()),
                testing::StartsWith("name,time_s,depth_m,force_n\nnow,0,0,0.05\n"));
    chooseTest(0);
    EXPECT_EQ(drawn(), "nothing measured yet");
}

TEST_F(VirtualTestPanelInTime, SaysWhereThereIsNoTimeConstant) {
    test.choosePlace(placeIn(5));
    awaitTissue();
    chooseTest(2);
    test.setForce(0.05);
    type("fingerDuration", "0.5");
    ESM_EVENTUALLY(test.latest() && !test.isPressing());
    EXPECT_EQ(said("pushTimeConstant"), QString(QChar(0x2013)));
    EXPECT_THAT(said("pressMessage").toStdString(), testing::HasSubstr("a longer duration"));
}

} // namespace
