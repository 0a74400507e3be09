#include "core/support/fields.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace esm {

struct Syringe {
    double volume = 1;
    std::optional<double> needle;
    std::array<double, 2> scale{1, 1};
    bool isFilled = false;
};
template<>
inline constexpr auto fieldsOf<Syringe> = fieldTable(
    field("volume", &Syringe::volume, positiveLimits("the volume", "ml", 20)),
    field("needle", &Syringe::needle, amountLimits("the needle", "mm")).whenSet(),
    field("scale", &Syringe::scale, Limits<double>{"the scale", -1, 1}).onlyWhere([](const Syringe& syringe) {
        return syringe.isFilled;
    }));

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> writtenOf(const Syringe& syringe) {
    std::vector<std::string> keys;
    forEachField(fieldsOf<Syringe>, [&](const auto& field) {
        if (field.isWrittenFor(syringe)) keys.emplace_back(field.key);
    });
    return keys;
}

TEST(Fields, BeyondTheirLimitsAreTold) {
    EXPECT_THAT(fieldProblems(Syringe{}), IsEmpty());
    EXPECT_THAT(fieldProblems(Syringe{20, 0, {2, NAN}, false}), IsEmpty()) << "empty ones have no scale";
    EXPECT_THAT(fieldProblems(Syringe{0, -1, {1, 2}, true}),
                ElementsAre("the volume must be above 0 ml and at most 20",
                            "the needle must be 0 mm or more and at most 1e+30",
                            "the scale must be from -1 to 1"));
    EXPECT_THAT(fieldProblems(Syringe{NAN, NAN, {1, NAN}, true}), testing::SizeIs(3));
}

TEST(Fields, AreWrittenWhereTheyBelongAndAreSet) {
    EXPECT_THAT(writtenOf(Syringe{}), ElementsAre("volume"));
    EXPECT_THAT(writtenOf(Syringe{1, 0, {}, false}), ElementsAre("volume", "needle"));
    EXPECT_THAT(writtenOf(Syringe{1, {}, {}, true}), ElementsAre("volume", "scale"));
}

TEST(LimitsText, SaysWhatPeopleSay) {
    EXPECT_EQ(limitsText(Limits<double>{"", 0.1, 170, "degrees"}), "from 0.1 to 170 degrees");
    EXPECT_EQ(limitsText(positiveLimits("", "s")), "above 0 s");
    EXPECT_EQ(limitsText(massLimits("")), "above 0 and at most 1e+30");
    EXPECT_EQ(limitsText(finiteLimits("")), "finite");
    EXPECT_EQ(limitsText(Limits<std::uint32_t>{"", 1, UINT32_MAX}), "1 or more");
    EXPECT_EQ(limitsText(Limits<int>{"", 1, 16384, "pixels"}), "from 1 to 16384 pixels");
}

} // namespace
} // namespace esm
