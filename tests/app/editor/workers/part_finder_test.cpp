#include "app/editor/workers/part_finder.h"

#include "core/samples/samples.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

PartFinder::Surface surfaceOf(const char* sample) {
    const Project project = makeSample(sample);
    return {project.mesh, project.network};
}

} // namespace

TEST(PartFinder, FindsTheLastSurfacesPartsAndShowsNoneOlder) {
    PartFinder finder;
    int heard = 0;
    QObject::connect(&finder, &PartFinder::found, &finder, [&] { ++heard; });
    EXPECT_FALSE(finder.isWorking());
    finder.find(surfaceOf("liver"));
    EXPECT_TRUE(finder.isWorking());
    ESM_EVENTUALLY(!finder.isWorking());
    EXPECT_EQ(heard, 1);
    const auto liver = finder.parts();
    ASSERT_EQ(liver.size(), 1U);

    finder.find(surfaceOf("liver"));
    EXPECT_TRUE(finder.parts().empty());
    finder.find(surfaceOf("ventricle"));
    ESM_EVENTUALLY(!finder.isWorking());
    EXPECT_EQ(heard, 2) << "once, though two were asked for";
    ASSERT_FALSE(finder.parts().empty());
    EXPECT_NE(finder.parts()[0].volume, liver[0].volume);
}
