#include "core/exchange/fuzzy/fuzzy_shapes.h"

#include "core/support/errors.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

struct ShapeCase {
    const char* shape;
    std::vector<double> numbers;
    Trapezoid set;
    bool opensLeft, opensRight, isNear;
};

} // namespace

TEST(FuzzyShapes, BecomeTrapezoids) {
    const std::vector<ShapeCase> cases{
        {"Trapezoid", {0, 1, 2, 3}, {0, 1, 2, 3}, false, false, false},
        {"trape", {0, 1, 2, 3, 1}, {0, 1, 2, 3}, false, false, false},
        {"TRIANGLE", {0, 1, 3}, {0, 1, 1, 3}, false, false, false},
        {"Rectangle", {3, 1}, {1, 1, 3, 3}, false, false, false},
        {"Ramp", {1, 2}, {1, 2, 2, 2}, false, true, false},
        {"Ramp", {2, 1}, {1, 1, 1, 2}, true, false, false},
        {"SShape", {1, 2}, {1, 2, 2, 2}, false, true, true},
        {"ZShape", {1, 2}, {1, 1, 1, 2}, true, false, true},
        {"PiShape", {0, 1, 2, 3}, {0, 1, 2, 3}, false, false, true},
        {"Cosine", {5, 4}, {3, 5, 5, 7}, false, false, true},
        {"Bell", {5, 2, 2}, {2, 4, 6, 8}, false, false, true},
        {"Sigmoid", {5, -2}, {4, 4, 4, 6}, true, false, true},
        {"GBELL", {2, 2, 5}, {2, 4, 6, 8}, false, false, true},
        {"SIGM", {-2, 5}, {4, 4, 4, 6}, true, false, true},
        {"Constant", {4}, {4, 4, 4, 4}, false, false, false},
        {"Discrete", {4, 1}, {4, 4, 4, 4}, false, false, false},
        {"Discrete", {0, 0, 1, 0, 2, 0.5, 3, 1, 4, 1, 4, 0, 9, 0}, {1, 3, 4, 4}, false, false, false},
        {"Discrete", {3, 1, 4, 1, 6, 0}, {3, 3, 4, 6}, true, false, false},
        {"Discrete", {0, 1, 1, 1, 2, 0.8, 5, 0}, {0, 0, 1, 5}, true, false, true},
    };
    for (const ShapeCase& c : cases) {
        const ShapeReading reading = readShape(c.shape, c.numbers);
        EXPECT_EQ(reading.set.a, c.set.a) << c.shape;
        EXPECT_EQ(reading.set.b, c.set.b) << c.shape;
        EXPECT_EQ(reading.set.c, c.set.c) << c.shape;
        EXPECT_EQ(reading.set.d, c.set.d) << c.shape;
        EXPECT_EQ(reading.opensLeft, c.opensLeft) << c.shape;
        EXPECT_EQ(reading.opensRight, c.opensRight) << c.shape;
        EXPECT_EQ(!reading.warning.empty(), c.isNear) << c.shape;
    }
}

TEST(FuzzyShapes, ThatAreNoTrapezoidsAreRefused) {
    const std::vector<std::vector<double>> points{{},
                                                  {1},
                                                  {0, 0, 1, 0.5},
                                                  {0, 0, 1, 1, 2, 0.5},
                                                  {0, 1, 1, 0, 2, 1},
                                                  {0, 0, 1, 0.4, 2, 0.2, 3, 1},
                                                  {0, 0, 1, 1, 0, 0},
                                                  {0, 0.5, 1, 0, 2, 1},
                                                  {0, 0, 1, 2}};
    for (const std::vector<double>& numbers : points)
        EXPECT_THROW(readShape("Discrete", numbers), InvalidModel);
    EXPECT_THROW(readShape("Bell", {0, 1, 0}), InvalidModel);
    EXPECT_THROW(readShape("Sigmoid", {0, 0}), InvalidModel);
    EXPECT_THROW(readShape("Trapezoid", {0, 1, 2, 3, 0.5}), InvalidModel);
    EXPECT_THROW(readShape("", {}), InvalidModel);
    EXPECT_THROW(readShape("Ramp", {3, 3}), InvalidModel);
    for (const char* shape : {"SShape", "ZShape"})
        for (const double end : {3.0, 2.0})
            EXPECT_THROW(readShape(shape, {3, end}), InvalidModel) << shape << end;
}
