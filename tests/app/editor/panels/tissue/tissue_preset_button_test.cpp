#include "app/editor/panels/tissue/tissue_preset_button.h"

#include "core/exchange/project/tissue_preset_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QAction>
#include <QMenu>

using namespace esm;

namespace {

class TissuePresetTest : public testing::Test {
protected:
    QAction* action(const char* name) const {
        emit button.menu()->aboutToShow();
        return button.menu()->findChild<QAction*>(name);
    }
    void choose(const char* name) {
        dialogs.expectNamed("presetBox", [this](QDialog* box) {
            preview = qobject_cast<QMessageBox*>(box)->informativeText();
            auto* apply = box->findChild<QPushButton*>("applyPreset");
            apply->isEnabled() && mayApply ? apply->click() : box->reject();
        });
        action(name)->trigger();
    }
    const Project& project() const { return document.project(); }

    Document document{makeSample("liver")};
    Selection selection{document};
    TissuePresetButton button{document, selection};
    DialogScript dialogs;
    QString preview;
    bool mayApply = true;
};

} // namespace

TEST_F(TissuePresetTest, SetsTheWholeOrganInOneStep) {
    const Project before = project();
    selection.setRegion(std::nullopt);
    choose("tube");
    const Region& whole = project().regions.at(0);
    EXPECT_FALSE(whole.ellipsoid);
    EXPECT_EQ(whole.inputs, tissuePreset("tube").inputs);
    EXPECT_NEAR(*evaluate(whole, usualWallThickness).values.springConstant, 16.2606, 2e-4 * 16.2606);
    EXPECT_EQ(project().base.mass, 0.010);
    EXPECT_EQ(project().scene.tethers.at(0).springConstant, 2.41327);
    const int steps = document.undoStack()->index();
    choose("tube");
    EXPECT_EQ(document.undoStack()->index(), steps) << "the same again changes nothing";
    document.undoStack()->undo();
    EXPECT_EQ(project().regions.size(), before.regions.size());
    EXPECT_EQ(project().base.mass, before.base.mass);
    EXPECT_EQ(project().scene.tethers.at(0).springConstant, before.scene.tethers.at(0).springConstant);
}

TEST_F(TissuePresetTest, ListsWhatItWillChangeAndChangesNothingUnasked) {
    selection.setRegion(project().regions[0].id);
    const Project before = project();
    mayApply = false;
    choose("uterus");
    EXPECT_EQ(project(), before);
    for (const char* part :
         {"base mass", "0.5 kg", "spring constant", "16.26 N/m", "81.31 N/m", "Radetzky 2003"})
        EXPECT_TRUE(preview.contains(part)) << part;
    EXPECT_FALSE(preview.contains("tethers")) << "they stay as they are";
    mayApply = true;
    choose("uterus");
    choose("uterus");
    EXPECT_TRUE(preview.contains("Nothing would change"));
}

TEST_F(TissuePresetTest, GivesAPartItsWordsOnly) {
    Region part;
    part.id = document.newRegionId();
    part.name = "part";
    part.ellipsoid =
        Ellipsoid{Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.05), Eigen::Quaterniond::Identity()};
    part.held = {1, 2, 0.3};
    document.edit("add", [&](Project& organ) { organ.regions.push_back(part); });
    selection.setRegion(project().regions.back().id);
    const Project before = project();
    EXPECT_TRUE(action("ventricle")->toolTip().contains("mass and tethers are for a whole organ"));
    choose("ventricle");
    const Region& shown = project().regions.back();
    EXPECT_EQ(shown.system->name, "robo-sim");
    EXPECT_FALSE(shown.held.springConstant);
    EXPECT_EQ(shown.held.mass, 0.3);
    EXPECT_EQ(project().base.mass, before.base.mass);
    choose("tube-tethers");
    EXPECT_EQ(project().regions.back().system->name, "robo-sim");
    EXPECT_EQ(project().scene.tethers.at(0).viscosity, 10.6875);
}

TEST_F(TissuePresetTest, TellsTheSourceOfEach) {
    for (const std::string& name : tissuePresetNames()) {
        const TissuePreset preset = tissuePreset(name);
        const QString toolTip = action(name.c_str())->toolTip();
        for (const std::string& part : {preset.source, preset.description, publishedText(preset)})
            EXPECT_TRUE(toolTip.contains(QString::fromStdString(part))) << name;
    }
}
