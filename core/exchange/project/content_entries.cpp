#include "core/exchange/project/content_entries.h"

#include "core/support/errors.h"
#include "core/texture/photo/photo_format.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

Bytes ContentEntries::bytes(const std::string& entry, std::uint64_t size) {
    try {
        if (!m_named.insert(entry).second)
            throw InvalidModel("the entry " + entry + " is named twice; leave one out");
        if (size > m_budget)
            throw InvalidModel("the entry " + entry +
                               " would unpack to more than the 2 GiB a project may have");
        m_budget -= size;
        Bytes content = m_entries.bytes(entry, size, nextStep());
        if (content.size() == size) return content;
        m_problems.push_back(entry + " should have " + std::to_string(size) + " bytes, but has " +
                             std::to_string(content.size()));
    } catch (const InvalidModel& error) {
        m_problems.push_back(error.what());
    }
    return {};
}

std::shared_ptr<const Photo> ContentEntries::photo(const std::string& name, Bytes encoded) {
    const PhotoFormat format = inspectPhoto(encoded);
    const std::uint64_t most = texture_limits::mostPhotoPixels;
    if (format.width > 0 && format.height > 0 && format.width <= most / format.height) {
        takePixels(format.width * format.height, name);
    }
    return decodePhoto(name, std::move(encoded), nextStep());
}

void ContentEntries::prepare(const JsonReader& reader, TextureLayer& layer) {
    const PhotoPreparation preparation = std::exchange(layer.preparation, {});
    if (!layer.photo || preparation.isNothing()) return;
    try {
        takePixels(layer.photo->image.pixels.size() / 4, layer.photo->fileName);
        if (takePrepared(layer, preparation)) return;
        esm::prepare(layer, preparation, nextStep());
        m_shared.preparations.push_back({layer.photo, preparation, layer.prepared});
    } catch (const InvalidModel& error) {
        for (const std::string& problem : error.problems())
            reader.addProblem("is not usable: " + problem);
    } catch (const FileError& error) {
        reader.addProblem(std::string("is not usable: ") + error.what());
    }
}

std::vector<double> ContentEntries::numbers(const JsonReader& arrays, const char* entry,
                                            std::size_t components) {
    std::vector<double> values = array<double>(arrays, entry, components);
    const auto bad =
        std::find_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
    if (bad == values.end()) return values;
    m_problems.push_back(std::string(entry) + ": number " + std::to_string(bad - values.begin()) +
                         " is not finite");
    return {};
}

std::vector<std::uint32_t> ContentEntries::indices(const JsonReader& arrays, const char* entry,
                                                   std::size_t components, std::size_t limit) {
    std::vector<std::uint32_t> values = array<std::uint32_t>(arrays, entry, components);
    if (limit == 0 && foundProblems()) return values;
    const auto bad =
        std::find_if(values.begin(), values.end(), [&](std::uint32_t value) { return value >= limit; });
    if (bad == values.end()) return values;
    m_problems.push_back(std::string(entry) + ": number " + std::to_string(bad - values.begin()) + " is " +
                         std::to_string(*bad) + ", but should be below " + std::to_string(limit));
    return {};
}

bool ContentEntries::takePrepared(TextureLayer& layer, const PhotoPreparation& preparation) const {
    const auto found = std::find_if(m_shared.preparations.begin(), m_shared.preparations.end(),
                                    [&](const SharedParts::Preparation& known) {
                                        return known.photo == layer.photo && known.preparation == preparation;
                                    });
    if (found == m_shared.preparations.end()) return false;
    layer.preparation = preparation;
    layer.prepared = found->prepared;
    return true;
}

void ContentEntries::takePixels(std::uint64_t pixels, const std::string& name) {
    if (pixels > m_pixels)
        throw FileError(name, "has more pixels than the project's other photos leave room for; use fewer "
                              "or smaller photos");
    m_pixels -= pixels;
}

std::vector<std::array<Eigen::Vector2d, 3>> flatTriangles(const std::vector<double>& numbers) {
    std::vector<std::array<Eigen::Vector2d, 3>> triangles;
    triangles.reserve(numbers.size() / 6);
    for (std::size_t i = 0; i < numbers.size(); i += 6)
        triangles.push_back({Eigen::Vector2d(numbers[i], numbers[i + 1]),
                             {numbers[i + 2], numbers[i + 3]},
                             {numbers[i + 4], numbers[i + 5]}});
    return triangles;
}

} // namespace esm
