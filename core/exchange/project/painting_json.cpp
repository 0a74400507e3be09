#include "core/exchange/project/painting_json.h"

#include "core/exchange/project/region_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

BrushKind brushFromJson(const JsonReader& reader) {
    const std::string name = reader.text();
    const auto found = std::find_if(brushKinds.begin(), brushKinds.end(),
                                    [&](BrushKind kind) { return name == brushName(kind); });
    if (found != brushKinds.end()) return *found;
    if (reader.json().is_string()) reader.addProblem("should be erase, restore, colour or clone");
    return BrushKind::Erase;
}

std::vector<BrushPoint> pathFromJson(const JsonReader& reader, const std::vector<double>& points,
                                     std::size_t& next) {
    const std::size_t left = (points.size() - next) / numbersPerBrushPoint;
    const auto count = static_cast<std::size_t>(reader.integer(1, std::max<std::size_t>(left, 1)));
    std::vector<BrushPoint> path;
    for (std::size_t i = 0; i < std::min(count, left); ++i, next += numbersPerBrushPoint)
        path.push_back({{points[next], points[next + 1], points[next + 2]},
                        {points[next + 3], points[next + 4], points[next + 5]}});
    return path;
}

Json toJson(const BrushStroke& stroke) {
    Json json{{"brush", brushName(stroke.kind)},
              {"radius", stroke.radius},
              {"softness", stroke.softness},
              {"strength", stroke.strength},
              {"points", stroke.path.size()}};
    if (stroke.kind == BrushKind::Colour) json["colour"] = colourToJson(stroke.colour);
    if (stroke.kind == BrushKind::Clone)
        json["shift"] = {stroke.shift.x(), stroke.shift.y(), stroke.shift.z()};
    return json;
}

} // namespace

Json toJson(const BrushStrokes& strokes, std::vector<double>& points) {
    Json list = Json::array();
    for (const auto& stroke : strokes) {
        list.push_back(toJson(*stroke));
        for (const auto& [place, normal] : stroke->path)
            points.insert(points.end(),
                          {place.x(), place.y(), place.z(), normal.x(), normal.y(), normal.z()});
    }
    return list;
}

BrushStrokes strokesFromJson(const JsonReader& reader, const std::vector<double>& points, std::size_t& next) {
    BrushStrokes strokes;
    for (const JsonReader& json : reader.elements()) {
        BrushStroke stroke;
        stroke.kind = brushFromJson(json.member("brush"));
        stroke.radius = json.member("radius").number();
        stroke.softness = json.member("softness").number();
        stroke.strength = json.member("strength").number();
        if (stroke.kind == BrushKind::Colour) stroke.colour = colourFromJson(json.member("colour"));
        if (stroke.kind == BrushKind::Clone) stroke.shift = json.member("shift").vector();
        stroke.path = pathFromJson(json.member("points"), points, next);
        strokes.push_back(std::make_shared<const BrushStroke>(std::move(stroke)));
    }
    return strokes;
}

} // namespace esm
