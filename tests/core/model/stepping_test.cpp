#include "core/model/stepping.h"

#include <gmock/gmock.h>

#include <limits>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MeasuredStepping, IsCheckedWhole) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THAT(validate(MeasuredStepping{{Integrator::Split2, 0.01, Precision::Double}, 0, 1e-3}),
                IsEmpty());
    EXPECT_THAT(validate(MeasuredStepping{{Integrator::Rk4, 0.01, Precision::Float}, 0.5, 1}), IsEmpty());
    const Stepping sound{Integrator::Rk4, 0.01, Precision::Double};
    EXPECT_THAT(validate(MeasuredStepping{sound, 0.5, 1, "0123456789abcdef"}), IsEmpty());
    for (const char* digest : {"0123456789abcde", "0123456789abcdeg", "0123456789ABCDEF"})
        EXPECT_THAT(validate(MeasuredStepping{sound, 0.5, 1, digest}), ElementsAre(HasSubstr("hexadecimal")));
    EXPECT_THAT(validate(MeasuredStepping{{Integrator::Split, 0, Precision::Float}, -1, 0}),
                ElementsAre(HasSubstr("time step"), HasSubstr("double precision"), HasSubstr("the error"),
                            HasSubstr("wall time")));
    EXPECT_THAT(
        validate(MeasuredStepping{{Integrator::Auto, infinite, Precision::Double}, infinite, infinite}),
        ElementsAre(HasSubstr("time step"), HasSubstr("auto"), HasSubstr("the error"),
                    HasSubstr("wall time")));
}

TEST(Precision, HasANameThatReadsBack) {
    for (const Precision precision : {Precision::Double, Precision::Float})
        EXPECT_EQ(fromWord<Precision>(wordOf(precision)), precision);
    EXPECT_FALSE(fromWord<Precision>("half"));
}

} // namespace
} // namespace esm
