#include "app/editor/window/theme.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QLabel>

using namespace esm;

namespace {

class ModelPanelTest : public EditorTest {
protected:
    void SetUp() override {
        applyTheme(*qApp, Theme::Dark);
        open(makeSample("tube"));
    }
};

} // namespace

TEST_F(ModelPanelTest, SaysWhereNoNodeIsFixed) {
    auto* fixing = child<QLabel>("fixing");
    const auto isWhole = [fixing] { return fixing->heightForWidth(fixing->width()) <= fixing->height(); };
    window->document().edit("free", [](Project& p) {
        p.scene.fixed.clear();
        p.scene.tethers = {{3, 1, 1}};
    });
    ESM_EVENTUALLY(fixing->text().startsWith("Tethers") && fixing->text().contains("The tool Fix nodes"));
    EXPECT_TRUE(isWhole());
    window->document().edit("untie", [](Project& p) { p.scene.tethers.clear(); });
    ESM_EVENTUALLY(fixing->text().startsWith("Nothing") && fixing->text().contains("The tool Fix nodes"));
    EXPECT_TRUE(isWhole());
    window->document().edit("fix", [](Project& p) { p.scene.fixed.push_back({{0, 1}, std::nullopt}); });
    ESM_EVENTUALLY(!fixing->text().contains("The tool Fix nodes"));
    EXPECT_TRUE(isWhole());
}
