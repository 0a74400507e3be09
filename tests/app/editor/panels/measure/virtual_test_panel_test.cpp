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
    VirtualTestPanelTest() : panel(document, test), view(document, test) {
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

} // namespace
