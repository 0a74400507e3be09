#include "core/exchange/project/preparation_json.h"

#include "core/exchange/fields_json.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// Of pinholes and of fisheyes OpenCV knows so many.
std::size_t coefficientsOf(LensKind kind) {
    return kind == LensKind::Fisheye ? 4 : 5;
}

Json lensToJson(const Lens& lens) {
    Json json{{"kind", wordOf(lens.kind)}};
    json.update(writtenFields(lens.camera));
    for (std::size_t i = 0; i < coefficientsOf(lens.kind); ++i)
        json["coefficients"].push_back(lens.coefficients[i]);
    return json;
}

Lens lensFromJson(const JsonReader& reader) {
    reader.allowOnly({"kind", "fx", "fy", "cx", "cy", "coefficients"});
    Lens lens;
    if (!reader.json().is_object()) return lens;
    fromJson(reader.member("kind"), lens.kind);
    readFields(reader, lens.camera);
    const std::vector<double> coefficients = reader.member("coefficients").numbers(coefficientsOf(lens.kind));
    std::copy(coefficients.begin(), coefficients.end(), lens.coefficients.begin());
    return lens;
}

struct PreparationForms {
    Json write(const std::vector<Eigen::Vector2d>& path) const {
        Json json = Json::array();
        for (const Eigen::Vector2d& place : path) {
            json.push_back(place.x());
            json.push_back(place.y());
        }
        return json;
    }
    void read(const JsonReader& reader, std::vector<Eigen::Vector2d>& path) const {
        const std::vector<double> numbers = reader.numbers(reader.json().size());
        if (numbers.empty() || numbers.size() % 2 != 0)
            reader.addProblem("must have an x and a y for each place");
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
            path.emplace_back(numbers[i], numbers[i + 1]);
    }

    Json write(const Lens& lens) const { return lensToJson(lens); }
    void read(const JsonReader& reader, Lens& lens) const { lens = lensFromJson(reader); }
};

} // namespace

void fromJson(const JsonReader& reader, PhotoPreparation& preparation) {
    readFields(reader, preparation, PreparationForms());
}

Json toJson(const PhotoPreparation& preparation) {
    return writtenFields(preparation, PreparationForms());
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
    writeFileAtomically(file, lensToJson(lens).dump(2) + '\n');
}

} // namespace esm
