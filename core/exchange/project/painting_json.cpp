#include "core/exchange/project/painting_json.h"

#include "core/exchange/fields_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

using BrushPath = std::vector<BrushPoint>;
using SharesOfPath = std::vector<BrushShares>;

/// A path stands as its length, and so do its shares; their numbers are in arrays of the file.
struct StrokeWriting {
    Json write(const BrushPath& path) const { return path.size(); }
    Json write(const SharesOfPath& shares) const { return shares.size(); }
};

/// Calls `take` with the place of each of so many items as the reader says, at most those that are left.
template<class Take>
void readCounted(const JsonReader& reader, const std::vector<double>& numbers, std::size_t perItem,
                 std::size_t& next, const Take& take) {
    const std::size_t left = (numbers.size() - next) / perItem;
    const auto count = static_cast<std::size_t>(reader.integer(1, std::max<std::size_t>(left, 1)));
    for (std::size_t i = 0; i < std::min(count, left); ++i, next += perItem)
        take(numbers.data() + next);
}

struct StrokeReading {
    StrokeArrays& arrays;

    void read(const JsonReader& reader, BrushPath& path) const {
        readCounted(reader, arrays.points, numbersPerBrushPoint, arrays.nextPoint, [&](const double* n) {
            path.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}});
        });
    }
    void read(const JsonReader& reader, SharesOfPath& shares) const {
        readCounted(reader, arrays.shares, numbersPerBrushShares, arrays.nextShare, [&](const double* n) {
            shares.push_back({n[0], n[1]});
        });
    }
};

} // namespace

Json toJson(const BrushStrokes& strokes) {
    Json list = Json::array();
    for (const auto& stroke : strokes)
        list.push_back(writtenFields(*stroke, StrokeWriting()));
    return list;
}

std::vector<double> pointNumbers(const BrushStroke& stroke) {
    std::vector<double> numbers;
    numbers.reserve(numbersPerBrushPoint * stroke.path.size());
    for (const auto& [place, normal] : stroke.path)
        numbers.insert(numbers.end(), {place.x(), place.y(), place.z(), normal.x(), normal.y(), normal.z()});
    return numbers;
}

std::vector<double> shareNumbers(const BrushStroke& stroke) {
    std::vector<double> numbers;
    numbers.reserve(numbersPerBrushShares * stroke.shares.size());
    for (const auto& [radius, strength] : stroke.shares)
        numbers.insert(numbers.end(), {radius, strength});
    return numbers;
}

BrushStrokes strokesFromJson(const JsonReader& reader, StrokeArrays& arrays) {
    BrushStrokes strokes;
    for (const JsonReader& json : reader.elements())
        strokes.push_back(
            std::make_shared<const BrushStroke>(valueFrom<BrushStroke>(json, StrokeReading{arrays})));
    return strokes;
}

} // namespace esm
