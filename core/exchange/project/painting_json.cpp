#include "core/exchange/project/painting_json.h"

#include "core/exchange/fields_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

using BrushPath = std::vector<BrushPoint>;

/// A path stands as its length; its points are appended to one array of the file.
struct StrokeWriting {
    std::vector<double>& points;

    Json write(const BrushPath& path) const {
        for (const auto& [place, normal] : path)
            points.insert(points.end(),
                          {place.x(), place.y(), place.z(), normal.x(), normal.y(), normal.z()});
        return path.size();
    }
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

Json toJson(const BrushStrokes& strokes, std::vector<double>& points) {
    Json list = Json::array();
    for (const auto& stroke : strokes)
        list.push_back(writtenFields(*stroke, StrokeWriting{points}));
    return list;
}

BrushStrokes strokesFromJson(const JsonReader& reader, const std::vector<double>& points, std::size_t& next) {
    BrushStrokes strokes;
    for (const JsonReader& json : reader.elements())
        strokes.push_back(
            std::make_shared<const BrushStroke>(valueFrom<BrushStroke>(json, StrokeReading{points, next})));
    return strokes;
}

} // namespace esm
