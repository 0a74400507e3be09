#include "core/exchange/package/glb.h"

#include "core/support/byte_order.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>

#include <limits>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string glbError(const Bytes& file) {
    try {
        parseGlb(file);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "parsed";
}

TEST(Glb, ComesBackPaddedToWholeWords) {
    const Glb glb{{{"asset", "ü"}}, {1, 2, 3}};
    const Bytes file = writeGlb(glb);
    EXPECT_EQ(file.size() % 4, 0U);
    const Glb back = parseGlb(file);
    EXPECT_EQ(back.json, glb.json);
    EXPECT_EQ(back.binary, (Bytes{1, 2, 3, 0}));
}

TEST(Glb, CutOffOrFollowedByMoreIsRefused) {
    const Bytes file = writeGlb({{{"asset", 1}}, {1, 2, 3, 4}});
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_NE(glbError(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size))), "parsed")
            << size;
    Bytes longer = file;
    longer.push_back(0);
    EXPECT_THAT(glbError(longer), HasSubstr("its header speaks of"));
    EXPECT_EQ(glbParts(longer).jsonEnd - glbParts(longer).json, 12);
}

TEST(Glb, WrongWordsInItsHeadersAreRefused) {
    const Bytes file = writeGlb({{{"asset", 1}}, {1, 2, 3, 4}});
    for (const std::size_t place : {0U, 4U, 8U, 12U, 16U}) {
        Bytes damaged = file;
        for (std::size_t i = 0; i < 4; ++i)
            damaged[place + i] = 0xff;
        EXPECT_NE(glbError(damaged), "parsed") << place;
    }
}

TEST(GltfArrays, ComeBackFromTheirAccessors) {
    Glb glb;
    GltfArrays arrays(glb);
    const std::vector<float> points{1.5F, -2, 0.1F, 4, 5, 6};
    const auto first = arrays.addFloats(points, GltfType::Vec3, GltfTarget::Vertices);
    const auto second = arrays.addIndices({1, 0, 7});
    EXPECT_EQ(glb.json["accessors"][first]["min"], (std::vector<double>{1.5, -2, double(0.1F)}));
    const nlohmann::ordered_json references{first, second};
    std::vector<std::string> problems;
    const GltfArrayReader reader(glb, problems);
    const std::vector<JsonReader> named = JsonReader(references, "used", problems).elements();
    EXPECT_EQ(reader.floats(named[0], GltfType::Vec3, 2), points);
    EXPECT_THAT(reader.indices(named[1], 3, 8), ElementsAre(1, 0, 7));
    EXPECT_THAT(problems, ElementsAre());
    EXPECT_THAT(reader.indices(named[1], 3, 7), ElementsAre());
    EXPECT_THAT(problems, ElementsAre(HasSubstr("used[1] holds 7")));
}

/// JSON's null is an element of a list, and none of what the list is for.
TEST(GltfArrays, AnAccessorOrAViewThatIsNullIsAProblem) {
    for (const char* list : {"accessors", "bufferViews"}) {
        Glb glb;
        GltfArrays arrays(glb);
        glb.json["index"] = arrays.addFloats({1, 2}, GltfType::Scalar, GltfTarget::None);
        glb.json[list][0] = nullptr;
        std::vector<std::string> problems;
        const GltfArrayReader reader(glb, problems);
        EXPECT_TRUE(
            reader.floats(JsonReader(glb.json["index"], "index", problems), GltfType::Scalar, 2).empty());
        EXPECT_THAT(problems, ElementsAre(HasSubstr(std::string(list) + "/0 is nothing")));
    }
}

TEST(ByteOrder, ReadsBackWhatItWrote) {
    Bytes bytes;
    appendLittleEndian(bytes, -1.25);
    appendLittleEndian(bytes, std::uint16_t{0x1234});
    EXPECT_EQ(littleEndian<double>(bytes.data()), -1.25);
    EXPECT_EQ(bytes[8], 0x34);
    EXPECT_EQ(unsignedNumber(bytes.data() + 8, 2, ByteOrder::Little), 0x1234U);
    EXPECT_EQ(unsignedNumber(bytes.data() + 8, 2, ByteOrder::Big), 0x3412U);
    const Bytes full(8, 0xff);
    EXPECT_EQ(unsignedNumber(full.data(), 8, ByteOrder::Big), std::numeric_limits<std::uint64_t>::max());
}

} // namespace
} // namespace esm
