#include "core/exchange/project/preparation_json.h"

#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "core/texture/texture_limits.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

RoundField fieldFromJson(const JsonReader& reader) {
    const std::vector<double> centre = reader.member("centre").numbers(2);
    const double radius = reader.member("radius").number();
    if (centre.size() != 2) return {};
    return {centre[0], centre[1], radius, reader.member("trim").number()};
}

ColourGains gainsFromJson(const JsonReader& reader) {
    const std::vector<double> gains = reader.numbers(3);
    if (gains.size() != 3) return {1, 1, 1};
    return {gains[0], gains[1], gains[2]};
}

Lens lensFromJson(const JsonReader& reader) {
    reader.allowOnly({"kind", "fx", "fy", "cx", "cy", "coefficients"});
    Lens lens;
    if (!reader.json().is_object()) return lens;
    const JsonReader kind = reader.member("kind");
    if (kind.json() == "fisheye")
        lens.kind = LensKind::Fisheye;
    else if (kind.json() != "pinhole" && !kind.json().is_null())
        kind.addProblem("must be \"pinhole\" or \"fisheye\"");
    lens.camera.fx = reader.member("fx").number();
    lens.camera.fy = reader.member("fy").number();
    lens.camera.cx = reader.member("cx").number();
    lens.camera.cy = reader.member("cy").number();
    const std::size_t count = lens.kind == LensKind::Fisheye ? 4 : 5;
    const std::vector<double> coefficients = reader.member("coefficients").numbers(count);
    for (std::size_t i = 0; i < coefficients.size() && i < count; ++i)
        lens.coefficients[i] = coefficients[i];
    return lens;
}

Json toJson(const Lens& lens) {
    const bool isFisheye = lens.kind == LensKind::Fisheye;
    Json coefficients = Json::array();
    for (std::size_t i = 0; i < (isFisheye ? 4 : 5); ++i)
        coefficients.push_back(lens.coefficients[i]);
    return {{"kind", isFisheye ? "fisheye" : "pinhole"},
            {"fx", lens.camera.fx},
            {"fy", lens.camera.fy},
            {"cx", lens.camera.cx},
            {"cy", lens.camera.cy},
            {"coefficients", std::move(coefficients)}};
}

std::vector<PhotoStroke> strokesFromJson(const JsonReader& reader) {
    std::vector<PhotoStroke> strokes;
    for (const JsonReader& element : reader.elements()) {
        PhotoStroke stroke;
        const JsonReader path = element.member("path");
        const std::vector<double> numbers = path.numbers(path.json().size());
        if (numbers.empty() || numbers.size() % 2 != 0)
            path.addProblem("must have an x and a y for each place");
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            stroke.path.emplace_back(numbers[i], numbers[i + 1]);
        stroke.radius = element.member("radius").number();
        stroke.softness = element.member("softness").number();
        stroke.takesBack = element.member("takesBack").flag();
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

Json toJson(const std::vector<PhotoStroke>& strokes) {
    Json list = Json::array();
    for (const PhotoStroke& stroke : strokes) {
        Json path = Json::array();
        for (const Eigen::Vector2d& place : stroke.path) {
            path.push_back(place.x());
            path.push_back(place.y());
        }
        list.push_back({{"path", std::move(path)},
                        {"radius", stroke.radius},
                        {"softness", stroke.softness},
                        {"takesBack", stroke.takesBack}});
    }
    return list;
}

ColourMatch matchFromJson(const JsonReader& reader) {
    ColourMatch match;
    const auto read = [&](const char* key, std::array<double, 3>& values) {
        const std::vector<double> numbers = reader.member(key).numbers(3);
        if (numbers.size() == 3) std::copy(numbers.begin(), numbers.end(), values.begin());
    };
    read("scale", match.scale);
    read("offset", match.offset);
    return match;
}

PhotoCrop cropFromJson(const JsonReader& reader) {
    PhotoCrop crop;
    const auto pixels = [&](const char* key) {
        return static_cast<int>(reader.member(key).integer(0, texture_limits::mostPhotoPixels));
    };
    crop.x = pixels("x");
    crop.y = pixels("y");
    crop.width = pixels("width");
    crop.height = pixels("height");
    return crop;
}

Json toJson(const PhotoCrop& crop) {
    return {{"x", crop.x}, {"y", crop.y}, {"width", crop.width}, {"height", crop.height}};
}

} // namespace

PhotoPreparation preparationFromJson(const JsonReader& reader) {
    PhotoPreparation preparation;
    if (reader.has("roundField")) preparation.field = fieldFromJson(reader.member("roundField"));
    if (reader.has("strokes")) preparation.strokes = strokesFromJson(reader.member("strokes"));
    if (reader.has("highlights"))
        preparation.highlightThreshold = static_cast<int>(reader.member("highlights").integer(1, 255));
    if (reader.has("evenLight")) preparation.evenLight = reader.member("evenLight").number();
    if (reader.has("whiteBalance")) preparation.whiteBalance = gainsFromJson(reader.member("whiteBalance"));
    if (reader.has("colourMatch")) preparation.match = matchFromJson(reader.member("colourMatch"));
    if (reader.has("lens")) preparation.lens = lensFromJson(reader.member("lens"));
    if (reader.has("crop")) preparation.crop = cropFromJson(reader.member("crop"));
    return preparation;
}

Json toJson(const PhotoPreparation& preparation) {
    Json json = Json::object();
    if (const auto& field = preparation.field)
        json["roundField"] = {
            {"centre", {field->centreX, field->centreY}}, {"radius", field->radius}, {"trim", field->trim}};
    if (!preparation.strokes.empty()) json["strokes"] = toJson(preparation.strokes);
    if (preparation.highlightThreshold) json["highlights"] = *preparation.highlightThreshold;
    if (preparation.evenLight != 0) json["evenLight"] = preparation.evenLight;
    if (preparation.whiteBalance) json["whiteBalance"] = *preparation.whiteBalance;
    if (preparation.match)
        json["colourMatch"] = {{"scale", preparation.match->scale}, {"offset", preparation.match->offset}};
    if (preparation.lens) json["lens"] = toJson(*preparation.lens);
    if (preparation.crop) json["crop"] = toJson(*preparation.crop);
    return json;
}

Lens readLensFile(const std::filesystem::path& file) {
    const Json json = readJsonFile(file);
    std::vector<std::string> problems;
    const Lens lens = lensFromJson(JsonReader(json, "", problems));
    PhotoPreparation only;
    only.lens = lens;
    if (problems.empty()) problems = validate(only, 1, 1); // whatever the photo
    if (!problems.empty()) throw FileError(file, InvalidModel(problems).what());
    return lens;
}

void writeLensFile(const Lens& lens, const std::filesystem::path& file) {
    writeFileAtomically(file, toJson(lens).dump(2) + '\n');
}

} // namespace esm
