#include "core/exchange/project/preparation_json.h"

#include "core/exchange/fields_json.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// As many coefficients as the lens's kind has, which stands before them.
struct LensForms {
    using Coefficients = std::array<double, 5>;
    const Lens& lens;

    Json write(const Coefficients& coefficients) const {
        return std::vector(coefficients.begin(), coefficients.begin() + coefficientsOf(lens.kind));
    }
    void read(const JsonReader& reader, Coefficients& coefficients) const {
        const std::vector<double> numbers = reader.numbers(coefficientsOf(lens.kind));
        std::copy(numbers.begin(), numbers.end(), coefficients.begin());
    }
};

struct PreparationForms {
    /// A circle has one radius, as ever; any other field stands by its table.
    Json write(const std::optional<PhotoField>& field) const {
        if (!field->isCircle()) return writtenFields(*field, *this);
        return {{"centre", written(field->centre)}, {"radius", field->radii.x()}, {"trim", field->trim}};
    }
    void read(const JsonReader& reader, std::optional<PhotoField>& field) const {
        field.emplace();
        if (!reader.isObject() || reader.has("shape")) return readFields(reader, *field, *this);
        fromJson(reader.member("centre"), field->centre);
        field->radii.setConstant(reader.member("radius").number());
        field->trim = reader.member("trim").number();
    }
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
};

} // namespace

void fromJson(const JsonReader& reader, Lens& lens) {
    reader.allowOnly(keysOf(fieldsOf<Lens>));
    if (reader.json().is_object()) readFields(reader, lens, LensForms{lens});
}

Json toJson(const Lens& lens) {
    return writtenFields(lens, LensForms{lens});
}

void fromJson(const JsonReader& reader, PhotoPreparation& preparation) {
    readFields(reader, preparation, PreparationForms());
}

Json toJson(const PhotoPreparation& preparation) {
    return writtenFields(preparation, PreparationForms());
}

Lens readLensFile(const std::filesystem::path& file) {
    const Json json = readJsonFile(file);
    std::vector<std::string> problems;
    PhotoPreparation only;
    fromJson(JsonReader(json, "", problems), only.lens.emplace());
    if (problems.empty()) problems = validate(only, 1, 1); // whatever the photo
    if (!problems.empty()) throw FileError(file, InvalidModel(problems).what());
    return *only.lens;
}

void writeLensFile(const Lens& lens, const std::filesystem::path& file) {
    writeFileAtomically(file, toJson(lens).dump(2) + '\n');
}

} // namespace esm
