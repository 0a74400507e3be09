#include "core/exchange/package/package_container.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using ContainerJson = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Of a file with eight bytes of binary data; its buffer is right where the text names none.
std::vector<std::string> warningsOf(const char* gltf) {
    Glb glb{ContainerJson::parse(gltf), Bytes(8)};
    if (glb.json.is_object() && !glb.json.contains("buffers")) glb.json["buffers"] = {{{"byteLength", 8U}}};
    return containerWarnings(glb);
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
    for (const char* odd : {"{}", R"({"nodes": 3, "images": {}})", R"({"nodes": [null, 1, []]})"})
        EXPECT_THAT(warningsOf(odd), IsEmpty()) << odd;
}

TEST(PackageContainer, NamesDataOutsideTheFile) {
    EXPECT_THAT(warningsOf(R"({"images": [{"bufferView": 1}, {"bufferView": 2, "uri": "skin.png"}]})"),
                ElementsAre(HasSubstr("images[1] should have no uri")));
    EXPECT_THAT(warningsOf(R"({"buffers": [{"byteLength": 8, "uri": "data.bin"}]})"),
                ElementsAre(HasSubstr("buffers[0] should have no uri")));
}

TEST(PackageContainer, NamesABufferOfAnotherLengthThanItsData) {
    EXPECT_THAT(warningsOf(R"({"buffers": [{"byteLength": 5}], "bufferViews": [{"byteLength": 5}]})"),
                IsEmpty()); // three bytes fill up the last four
    for (const char* length : {"4", "9", "-1", "\"8\"", "null"})
        EXPECT_THAT(warningsOf((R"({"buffers": [{"byteLength": )" + std::string(length) + "}]}").c_str()),
                    ElementsAre(HasSubstr("buffers[0] should have the byteLength 8")))
            << length; // and nothing of the views, which the file's data may hold all the same
    for (const char* buffers : {"[]", "{}", "7"})
        EXPECT_THAT(warningsOf((R"({"buffers": )" + std::string(buffers) + "}").c_str()),
                    ElementsAre(HasSubstr("buffers should name")))
            << buffers;
    EXPECT_THAT(warningsOf(R"({"buffers": [{"byteLength": 6}],
                               "bufferViews": [{"byteLength": 6}, {"byteOffset": 4, "byteLength": 4}]})"),
                ElementsAre(HasSubstr("bufferViews[1] reaches beyond")));
}

TEST(PackageContainer, NamesExtensionsThatOthersLack) {
    EXPECT_THAT(warningsOf(R"({"extensionsRequired": ["KHR_draco_mesh_compression", 3, "ESM_spring_mass"]})"),
                ElementsAre(HasSubstr("extensionsRequired[0] should not name KHR_draco_mesh_compression"),
                            HasSubstr("extensionsRequired[2] should not name ESM_spring_mass")));
}

} // namespace
} // namespace esm
