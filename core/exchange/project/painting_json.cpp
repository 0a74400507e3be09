#include "core/exchange/project/painting_json.h"

#include "core/exchange/fields_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

using BrushPath = std::vector<BrushPoint>;

/// A path stands as its length; its points are in an array of the file.
struct StrokeWriting {
    Json write(const BrushPath& path) const { return path.size(); }
};

struct StrokeReading {
    const std::vector<double>& points;
    std::size_t& next;

    void read(const JsonReader& reader, BrushPath& path) const {
        const std::size_t left = (points.size() - next) / numbersPerBrushPoint;
        const auto count = static_cast<std::size_t>(reader.integer(1, std::max<std::size_t>(left, 1)));
        for (std::size_t i = 0; i < std::min(count, left); ++i, next += numbersPerBrushPoint)
            path.push_back({{points[next], points[next + 1], points[next + 2]},
                            {points[next + 3], points[next + 4], points[next + 5]}});
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

BrushStrokes strokesFromJson(const JsonReader& reader, const std::vector<double>& points, std::size_t& next) {
    BrushStrokes strokes;
    for (const JsonReader& json : reader.elements())
        strokes.push_back(
            std::make_shared<const BrushStroke>(valueFrom<BrushStroke>(json, StrokeReading{points, next})));
    return strokes;
}

} // namespace esm
