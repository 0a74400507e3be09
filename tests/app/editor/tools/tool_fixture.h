#pragma once

#include "app/editor/window/actions.h"
#include "app/editor/window/view_controller.h"
#include "core/samples/samples.h"
#include "tests/widgets/view/organ_view_fixture.h"

#include <algorithm>

namespace esm {

/// A view that shows a document whose organ is a ball of 0.1 m, and one tool in hand. Nothing moves.
class ToolTest : public OrganViewTest {
protected:
    void SetUp() override {
        OrganViewTest::SetUp();
        Project project = makeSample("tube");
        project.mesh = scene.mesh;
        project.network = scene.network;
        project.regions.clear();
        project.layers.clear();
        project.scene = {};
        document.replace(project, std::nullopt);
        controller.connectActions(actions);
        view.showView(StandardView::Front);
    }

    template<typename Tool> Tool& take() {
        auto* tool =
            new Tool(ToolContext{document, selection, preview, landmarking, virtualTest,
                                 *std::as_const(actions.showRegions), *std::as_const(actions.showProjector)});
        tool->setParent(&holder);
        view.setTool(*tool);
        return *tool;
    }
    void edit(const std::function<void(Project&)>& change) { document.edit("edit", change); }
    const Project& project() const { return document.project(); }
    std::optional<Pull> pull() const { return preview.loads().pull; }
    std::optional<PlacedCollider> instrument() const { return preview.loads().instrument; }
    /// What the whole drag made is one step.
    void expectSteps(int steps) { EXPECT_EQ(document.undoStack()->count(), steps); }
    /// The organ as it would have moved.
    std::vector<Eigen::Vector3d> shifted(double x) const {
        std::vector<Eigen::Vector3d> moved = scene.mesh->vertices;
        for (Eigen::Vector3d& position : moved)
            position.x() += x;
        return moved;
    }

    QWidget holder;
    Document document{makeSample("tube")};
    Selection selection{document};
    Preview preview;
    Landmarking landmarking{document, selection};
    VirtualTest virtualTest{document, preview};
    Actions actions = createActions(&holder, document.undoStack());
    ViewController& controller = *new ViewController(view, document, selection, preview);
};

} // namespace esm
