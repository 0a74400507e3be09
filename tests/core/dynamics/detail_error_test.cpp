#include "core/dynamics/detail_error.h"

#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// A ball of 20 cm that a round instrument, 8 cm across, pushes in by 2 cm.
Project pokedOrgan() {
    Project project = makeProject("organ", {tissue::sphereMesh(4, 0.1), {}});
    project.scene.duration = 0.3;
    project.scene.record.every = 0.1;
    project.scene.instrument = InstrumentMotion{0.04, {{0, {0, 0.15, 0}}, {0.3, {0, 0.12, 0}}}};
    return project;
}

TEST(DetailError, FallsAsNodesGrowMany) {
    const Project project = pokedOrgan();
    double last = 1;
    for (const std::size_t nodes : {100, 500, 2000}) {
        const double error = detailError(project, {Detail::Kind::Nodes, nodes});
        EXPECT_LT(error, last) << nodes;
        EXPECT_GT(error, 0) << nodes;
        last = error;
    }
    EXPECT_LT(last, 0.1);
    EXPECT_EQ(detailError(project, {}), 0);
}

TEST(DetailError, OfARunThatIsBrokenOffIsNone) {
    const Project project = pokedOrgan();
    EXPECT_THROW(detailError(project, {Detail::Kind::Nodes, 2}), InvalidModel);
    EXPECT_THROW(detailError(project, {Detail::Kind::Nodes, 100}, {}, [](double done) { return done < 0.7; }),
                 Cancelled);
}

} // namespace
} // namespace esm
