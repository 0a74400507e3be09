#include "core/exchange/fuzzy/fuzzy_shapes.h"

#include "core/exchange/fuzzy/fuzzy_source.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

using ShapeNumbers = std::vector<double>;

struct SetPoint {
    double x, degree;
};

/// Where a side comes down to 0, and whether it is straight up to there.
struct SetFoot {
    double x;
    bool isStraight = true;
};

/// The points go outward from the one that is full.
SetFoot footOf(const std::vector<SetPoint>& side) {
    const auto foot =
        std::find_if(side.begin(), side.end(), [](const SetPoint& point) { return point.degree == 0; });
    if (foot == side.end()) throw InvalidModel("a side of the set ends between 0 and 1");
    if (!std::is_sorted(side.begin(), side.end(),
                        [](const SetPoint& a, const SetPoint& b) { return a.degree > b.degree; }))
        throw InvalidModel("the set rises twice; only trapezoids can be taken");
    SetFoot result{foot->x};
    const SetPoint& top = side.front();
    const double width = foot->x - top.x;
    for (auto point = side.begin(); point != foot; ++point)
        if (std::abs(point->x - (top.x + (1 - point->degree) * width)) > 1e-9 * std::abs(width))
            result.isStraight = false;
    return result;
}

std::vector<SetPoint> pointsFrom(const ShapeNumbers& numbers) {
    if (numbers.empty() || numbers.size() % 2 != 0) throw InvalidModel("points are pairs of numbers");
    std::vector<SetPoint> points;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        const SetPoint point{numbers[i], numbers[i + 1]};
        if (!std::isfinite(point.x)) throw InvalidModel("points must have finite places");
        if (!(point.degree >= 0 && point.degree <= 1)) throw InvalidModel("degrees go from 0 to 1");
        if (!points.empty() && point.x < points.back().x)
            throw InvalidModel("points must come in the order of their places");
        points.push_back(point);
    }
    return points;
}

/// A side that does not come down goes on beyond its last point, as IEC 61131-7 has it.
ShapeReading fromPoints(const ShapeNumbers& numbers) {
    const std::vector<SetPoint> points = pointsFrom(numbers);
    const auto isFull = [](const SetPoint& point) { return point.degree == 1; };
    const auto first = std::find_if(points.begin(), points.end(), isFull);
    if (first == points.end()) throw InvalidModel("the set does not reach the degree 1");
    const auto last = std::find_if(points.rbegin(), points.rend(), isFull).base() - 1;
    if (!std::all_of(first, last, isFull))
        throw InvalidModel("the set falls and rises again; only trapezoids can be taken");
    ShapeReading reading{{first->x, first->x, last->x, last->x}, false, false, {}};
    if (points.size() == 1) return reading;
    reading.opensLeft = first == points.begin();
    reading.opensRight = last + 1 == points.end();
    const auto footBeyond = [&](const std::vector<SetPoint>& side) {
        const SetFoot foot = footOf(side);
        if (!foot.isStraight) reading.warning = "its sides bend and are taken as straight ones";
        return foot.x;
    };
    if (!reading.opensLeft)
        reading.set.a = footBeyond({std::make_reverse_iterator(first + 1), points.rend()});
    if (!reading.opensRight) reading.set.d = footBeyond({last, points.end()});
    return reading;
}

/// fuzzylite lets the outer corners be infinite.
ShapeReading fromCorners(Trapezoid set) {
    ShapeReading reading;
    reading.opensLeft = std::isinf(set.a) && set.a < 0;
    reading.opensRight = std::isinf(set.d) && set.d > 0;
    if (reading.opensLeft) {
        if (std::isinf(set.b)) set.b = set.c;
        set.a = set.b;
    }
    if (reading.opensRight) {
        if (std::isinf(set.c)) set.c = set.b;
        set.d = set.c;
    }
    reading.set = set;
    return reading;
}

/// From 0 at `start` to 1 at `end` and on; falling where the end lies left of the start.
ShapeReading fromRamp(double start, double end) {
    if (start < end) return {{start, end, end, end}, false, true, {}};
    if (end < start) return {{end, end, end, start}, true, false, {}};
    throw InvalidModel("it begins where it ends"); // fuzzylite gives it the degree 0 everywhere
}

/// Of a curve from `start` to `end` that never runs to the left.
void checkRises(const ShapeNumbers& n) {
    if (!(n[0] < n[1])) throw InvalidModel("its start must lie before its end");
}

ShapeReading fromBell(const ShapeNumbers& n) {
    const double centre = n[0], width = std::abs(n[1]);
    if (!(std::abs(n[2]) > 0)) throw InvalidModel("a bell has a slope");
    const double half = width / std::abs(n[2]); // the tangent at the degree one half
    const double core = std::max(width - half, 0.0);
    return {{centre - width - half, centre - core, centre + core, centre + width + half}, false, false, {}};
}

ShapeReading fromSigmoid(const ShapeNumbers& n) {
    if (!(std::abs(n[1]) > 0)) throw InvalidModel("a sigmoid has a slope");
    return fromRamp(n[0] - 2 / n[1], n[0] + 2 / n[1]); // the tangent at the inflection
}

struct KnownShape {
    const char* name;
    const char* otherName;
    std::size_t numbers;
    const char* warning; ///< of one that only comes near
    ShapeReading (*read)(const ShapeNumbers&);
};

constexpr const char* straightened = "its curved sides are taken as straight ones";
constexpr const char* tangential = "its curves are taken as their tangents";
constexpr double gaussianBase = 2.5066282746310002; // √(2π): the triangle then has the same area

const std::array knownShapes{
    KnownShape{"trapezoid", "trape", 4, nullptr,
               [](const ShapeNumbers& n) {
                   return fromCorners({n[0], n[1], n[2], n[3]});
               }},
    KnownShape{"triangle", "trian", 3, nullptr,
               [](const ShapeNumbers& n) {
                   return fromCorners({n[0], n[1], n[1], n[2]});
               }},
    KnownShape{"rectangle", "rect", 2, nullptr,
               [](const ShapeNumbers& n) {
                   return fromCorners({std::min(n[0], n[1]), std::min(n[0], n[1]), std::max(n[0], n[1]),
                                       std::max(n[0], n[1])});
               }},
    KnownShape{"ramp", nullptr, 2, nullptr, [](const ShapeNumbers& n) { return fromRamp(n[0], n[1]); }},
    KnownShape{"constant", "singleton", 1, nullptr,
               [](const ShapeNumbers& n) {
                   return ShapeReading{{n[0], n[0], n[0], n[0]}, false, false, {}};
               }},
    KnownShape{"sshape", nullptr, 2, straightened,
               [](const ShapeNumbers& n) {
                   checkRises(n);
                   return fromRamp(n[0], n[1]);
               }},
    KnownShape{"zshape", nullptr, 2, straightened,
               [](const ShapeNumbers& n) {
                   checkRises(n);
                   return fromRamp(n[1], n[0]);
               }},
    KnownShape{"pishape", nullptr, 4, straightened,
               [](const ShapeNumbers& n) {
                   return fromCorners({n[0], n[1], n[2], n[3]});
               }},
    KnownShape{"cosine", nullptr, 2, "it is taken as the triangle of the same area",
               [](const ShapeNumbers& n) {
                   const double half = std::abs(n[1]) / 2;
                   return fromCorners({n[0] - half, n[0], n[0], n[0] + half});
               }},
    KnownShape{"gaussian", "gauss", 2, "it is taken as the triangle of the same area",
               [](const ShapeNumbers& n) {
                   const double half = gaussianBase * std::abs(n[1]);
                   return fromCorners({n[0] - half, n[0], n[0], n[0] + half});
               }},
    KnownShape{"bell", nullptr, 3, tangential, fromBell},
    KnownShape{"sigmoid", nullptr, 2, tangential, fromSigmoid},
    // Those of jFuzzyLogic, whose numbers come in another order.
    KnownShape{"gbell", nullptr, 3, tangential,
               [](const ShapeNumbers& n) {
                   return fromBell({n[2], n[0], n[1]});
               }},
    KnownShape{"sigm", nullptr, 2, tangential,
               [](const ShapeNumbers& n) {
                   return fromSigmoid({n[1], n[0]});
               }},
};

/// Some shapes may have a height behind their numbers.
void checkCount(const KnownShape& shape, const ShapeNumbers& numbers) {
    const bool hasHeight = numbers.size() == shape.numbers + 1;
    if (numbers.size() != shape.numbers && !hasHeight)
        throw InvalidModel("a " + std::string(shape.name) + " takes " + std::to_string(shape.numbers) +
                           " numbers, got " + std::to_string(numbers.size()));
    if (hasHeight && numbers.back() != 1)
        throw InvalidModel("has the height " + roundedText(numbers.back()) + "; every set reaches 1 here");
}

} // namespace

ShapeReading readShape(const std::string& shape, const std::vector<double>& numbers) {
    const std::string name = inSmallLetters(shape);
    if (name == "discrete") return fromPoints(numbers);
    std::vector<std::string> names{"discrete"};
    for (const KnownShape& known : knownShapes) {
        names.emplace_back(known.name);
        if (name != known.name && (!known.otherName || name != known.otherName)) continue;
        checkCount(known, numbers);
        ShapeReading reading = known.read(numbers);
        if (known.warning) reading.warning = std::string(known.name) + ": " + known.warning;
        return reading;
    }
    throw InvalidModel("the shape \"" + shape + "\" cannot be taken; known are " + joined(names));
}

} // namespace esm
