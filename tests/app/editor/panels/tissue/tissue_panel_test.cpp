#include "app/editor/panels/tissue/tissue_panel.h"

#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/tissue_preset_file.h"
#include "core/samples/samples.h"
#include "widgets/fuzzy/term_scale.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// Over the whole organ of 20 N/m and 3 N·s/m a region of which no rule concludes the viscosity.
Project silentProject() {
    Project project = makeSample("tube");
    project.regions.clear();
    project.base = {20, 3, 0.5};
    FuzzySystem system = fuzzyPreset("susilap-g");
    for (FuzzyRule& rule : system.rules)
        std::erase_if(rule.conclusions, [](const FuzzyProposition& said) { return said.variable == 1; });
    setSystem(project, RegionId{1}, std::make_shared<const FuzzySystem>(system));
    return project;
}

class TissuePanelTest : public testing::Test {
protected:
    void show(Project project) {
        document.replace(std::move(project), std::nullopt);
        selection.setRegion(document.project().regions.front().id);
    }
    QString text(const char* name) const { return panel.findChild<QLabel*>(name)->text(); }
    NumberField* field(const char* name) const { return panel.findChild<NumberField*>(name); }
    QString shownIn(const char* name) const { return field(name)->text(); }
    void type(const char* name, const QString& text) {
        field(name)->setText(text);
        field(name)->setModified(true);
        field(name)->takeTyped();
    }
    /// All labels that hold these words.
    int labelsWith(const QString& words) const {
        int count = 0;
        for (const auto* label : panel.findChildren<QLabel*>())
            count += label->isVisibleTo(&panel) && label->text().contains(words);
        return count;
    }

    Document document{makeSample("tube")};
    Selection selection{document};
    SystemReach reach{document, selection};
    TissuePanel panel{document, selection, reach};
};

} // namespace

TEST_F(TissuePanelTest, SaysOnceWhatAnOutputKeepsThatNoRuleReaches) {
    show(silentProject());
    const auto* row = panel.findChild<LinguisticSlider*>("output-viscosity");
    ASSERT_TRUE(row);
    EXPECT_EQ(row->findChild<TermScale*>()->note(), "no rule reaches it: it keeps 3 N·s/m");
    EXPECT_EQ(labelsWith("no rule reaches"), 0) << "not in the warnings as well";
    EXPECT_EQ(text("beneath"), "it keeps 0.5 kg");
    document.edit("Base", [](Project& project) { project.base.viscosity = 4; });
    EXPECT_EQ(row->findChild<TermScale*>()->note(), "no rule reaches it: it keeps 4 N·s/m");
}

TEST_F(TissuePanelTest, SaysWhatAHeldValueReplaces) {
    Project project = silentProject();
    project.regions[0].held.mass = 0.2;
    show(project);
    EXPECT_EQ(text("beneath"), "in place of 0.5 kg");
}

TEST_F(TissuePanelTest, NamesTheSourceUntilTheTissueIsChangedOtherwise) {
    show(makeSample("liver"));
    const TissuePreset preset = tissuePreset("uterus");
    const RegionId region = *selection.region();
    EXPECT_EQ(text("tissueSource"), "values set here, by no preset");
    document.edit("Preset", [&](Project& project) { applyPreset(project, region, preset); });
    EXPECT_EQ(text("tissueSource"), "source: " + QString::fromStdString(preset.source));
    document.edit("Name", [](Project& project) { project.regions[0].name = "womb"; });
    EXPECT_EQ(text("tissueSource"), "source: " + QString::fromStdString(preset.source));
    document.edit("Slider", [](Project& project) { setInput(project.regions[0], "consistency", 10); });
    EXPECT_EQ(text("tissueSource"), "values set here, by no preset");
    document.undoStack()->undo();
    document.edit("Mass", [](Project& project) { project.base.mass = 0.4; });
    EXPECT_EQ(text("tissueSource"), "values set here, by no preset");
    const TissuePreset tethers = tissuePreset("tube-tethers");
    document.edit("Tethers", [&](Project& project) { applyPreset(project, region, tethers); });
    EXPECT_EQ(text("tissueSource"), "source of the tethers: " + QString::fromStdString(tethers.source));
}

TEST_F(TissuePanelTest, HasRoomForTheLongestNumber) {
    Project project = makeSample("tube");
    project.regions[0].held = {1.234e-7, 1.234e-7, 1.234e-7};
    show(project);
    panel.resize(308, 700);
    static_cast<QWidget&>(panel).show();
    for (const auto* field : panel.findChildren<NumberField*>()) {
        if (!field->isVisible()) continue;
        const int text = field->fontMetrics().horizontalAdvance(field->text());
        EXPECT_LT(text + 6, field->width()) << qPrintable(field->text());
        EXPECT_EQ(field->width(), field->maximumWidth()) << "it is not squeezed";
    }
}

TEST_F(TissuePanelTest, SaysHowSoonStretchedTissueComesBack) {
    Project project = makeSample("liver");
    project.regions.resize(1);
    project.regions[0].held.springConstant = 2.5;
    project.regions[0].held.viscosity = 11;
    show(project);
    EXPECT_EQ(shownIn("relaxationTime"), "4.400 s");
    document.edit("thin", [](Project& p) { p.regions[0].held.viscosity = 0.5; });
    EXPECT_EQ(shownIn("relaxationTime"), "0.2000 s");
    document.edit("limp", [](Project& p) { p.regions[0].held.springConstant = 0; });
    EXPECT_EQ(shownIn("relaxationTime"), QString(QChar(0x2013))) << "nothing draws it back";
    selection.setRegion(std::nullopt);
    document.edit("base", [](Project& p) {
        p.base.springConstant = 16;
        p.base.viscosity = 2.88;
    });
    EXPECT_EQ(shownIn("relaxationTime"), "0.1800 s");
}

TEST_F(TissuePanelTest, TakesYoungsModulusByHand) {
    Project project = makeSample("liver");
    project.regions.resize(1);
    show(project);
    const auto region = [&]() -> const Region& { return document.project().regions[0]; };
    type("youngsModulus", "4 kPa");
    EXPECT_NEAR(*region().held.springConstant, springConstantOfWall(4000, 0.003), 1e-9);
    type("relaxationTime", "250 ms");
    EXPECT_NEAR(*region().held.viscosity, 0.25 * springConstantOfWall(4000, 0.003), 1e-9);
    type("wallThickness", "6");
    EXPECT_EQ(document.project().base.wallThickness, 0.006);
    EXPECT_EQ(shownIn("youngsModulus"), "2.000 kPa") << "the same springs make a wall twice as thick";
    document.undoStack()->undo();
    EXPECT_EQ(shownIn("youngsModulus"), "4.000 kPa");
    selection.setRegion(std::nullopt);
    type("youngsModulus", "10");
    EXPECT_NEAR(document.project().base.springConstant, springConstantOfWall(10000, 0.003), 1e-9);
}

TEST_F(TissuePanelTest, TakesYoungsModulusInWordsWhereTheSystemHasSome) {
    Project project = makeSample("liver");
    project.regions.resize(1);
    setSystem(project, project.regions[0].id, std::make_shared<const FuzzySystem>(fuzzyPreset("organ")));
    show(project);
    const auto region = [&]() -> const Region& { return document.project().regions[0]; };
    EXPECT_FALSE(panel.findChild<LinguisticSlider*>("output-youngs_modulus")) << "it spans decades";
    type("youngsModulus", "10");
    EXPECT_NEAR(*valueOf(region().inputs, "firmness"), 4, 1e-4);
    EXPECT_FALSE(region().held.springConstant);
    EXPECT_EQ(shownIn("youngsModulus"), "10.00 kPa");
    type("relaxationTime", "0.2");
    EXPECT_NEAR(*valueOf(region().inputs, "springiness"), 5, 1e-4);
    type("youngsModulus", "9000");
    EXPECT_NEAR(*region().held.springConstant, springConstantOfWall(9e6, 0.003), 1e-3)
        << "no word reaches it";
    EXPECT_EQ(shownIn("relaxationTime"), "0.2000 s") << "the time is the system's";
}
