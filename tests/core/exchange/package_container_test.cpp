#include "core/exchange/package_container.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using ContainerJson = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warningsOf(const char* gltf) {
    return containerWarnings(ContainerJson::parse(gltf));
}

TEST(PackageContainer, NamesNodesThatMoveTheMesh) {
    EXPECT_THAT(warningsOf(R"({"nodes": [{"mesh": 0, "scale": [2, 2, 2]}]})"),
                ElementsAre(HasSubstr("nodes[0] should have no scale")));
    EXPECT_THAT(warningsOf(R"({"nodes": [{"mesh": 0}, {"children": [0], "translation": [0, 0, 1],
                                          "rotation": [1, 0, 0, 0]}]})"),
                ElementsAre(HasSubstr("nodes[1] should have no translation"), HasSubstr("no rotation")));
    EXPECT_THAT(warningsOf(R"({"nodes": [{"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1]}]})"),
                ElementsAre(HasSubstr("no matrix")));
}

TEST(PackageContainer, LeavesNodesAloneThatStayWhereTheyAre) {
    EXPECT_THAT(warningsOf(R"({"nodes": [{"mesh": 0, "scale": [1.0, 1, 1], "translation": [0, 0, -0.0]},
                                         {"camera": 0, "translation": [0, 0, 3]}]})"),
                IsEmpty());
    for (const char* odd : {"{}", "[]", R"({"nodes": 3, "images": {}})", R"({"nodes": [null, 1, []]})"})
        EXPECT_THAT(warningsOf(odd), IsEmpty()) << odd;
}

TEST(PackageContainer, NamesDataOutsideTheFile) {
    EXPECT_THAT(warningsOf(R"({"images": [{"bufferView": 1}, {"bufferView": 2, "uri": "skin.png"}]})"),
                ElementsAre(HasSubstr("images[1] should have no uri")));
    EXPECT_THAT(warningsOf(R"({"buffers": [{"byteLength": 1, "uri": "data.bin"}]})"),
                ElementsAre(HasSubstr("buffers[0] should have no uri")));
}

} // namespace
} // namespace esm
