#pragma once

#include "app/editor/workers/virtual_test.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "tests/support/eventually.h"

namespace esm {

/// The sample liver, by few nodes so that it is pressed soon, and a finger.
class PressedOrgan : public testing::Test {
protected:
    explicit PressedOrgan(const Detail& detail = {Detail::Kind::Nodes, 500})
        : document(withDetail(makeSample("liver"), detail)), test(document, preview) {
        QObject::connect(&document, &Document::changed, &preview,
                         [this] { preview.setProject(document.project()); });
        preview.setProject(document.project());
        test.setDepth(0.001);
    }

    /// The middle of a triangle of the surface.
    CarriedPlace placeIn(std::size_t triangle) const {
        return {document.project().mesh->triangles[triangle], Eigen::Vector3d::Constant(1.0 / 3)};
    }
    void awaitTissue() { ESM_EVENTUALLY(preview.tissue() != nullptr); }
    void measure() {
        awaitTissue();
        test.press();
        ESM_EVENTUALLY(!test.isPressing());
    }
    /// Tissue twice as firm, everywhere.
    void stiffen() {
        document.edit("stiffen", [](Project& project) {
            for (Region& region : project.regions)
                region.held.springConstant = 2 * region.held.springConstant.value_or(100);
        });
        awaitTissue();
    }

    Document document;
    Preview preview;
    VirtualTest test;
};

/// The same filled with nodes.
inline Detail solidDetail() {
    return {Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, 0.02}};
}

} // namespace esm
