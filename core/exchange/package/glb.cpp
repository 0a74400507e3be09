#include "core/exchange/package/glb.h"

#include "core/support/byte_order.h"
#include "core/support/errors.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::uint32_t magic = 0x46546C67, jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
constexpr std::size_t headerSize = 12, chunkHeaderSize = 8;
constexpr unsigned uint32Component = 5125, float32Component = 5126;
constexpr const char* remedy = "; get it again from where it came";

const char* nameOf(GltfType type) {
    constexpr std::array names{"SCALAR", "VEC2", "VEC3", "VEC4"};
    return names[static_cast<std::size_t>(type)];
}

std::size_t componentsOf(GltfType type) {
    return static_cast<std::size_t>(type) + 1;
}

void pad(Bytes& bytes, std::uint8_t filler) {
    while (bytes.size() % 4 != 0)
        bytes.push_back(filler);
}

std::size_t paddedSize(std::size_t size) {
    return (size + 3) / 4 * 4;
}

/// @param content bytes or text
template<typename Content>
void appendChunk(Bytes& file, std::uint32_t type, const Content& content, std::uint8_t filler) {
    const std::size_t size = paddedSize(content.size());
    appendLittleEndian(file, static_cast<std::uint32_t>(size));
    appendLittleEndian(file, type);
    file.insert(file.end(), content.begin(), content.end());
    file.resize(file.size() + size - content.size(), filler);
}

std::uint32_t wordAt(const Bytes& file, std::size_t place) {
    return littleEndian<std::uint32_t>(&file[place]);
}

/// The bytes that the header speaks of.
std::size_t announcedSize(const Bytes& file) {
    if (file.empty()) throw InvalidModel("is empty; choose another file");
    if (file.size() < headerSize || wordAt(file, 0) != magic)
        throw InvalidModel(
            "is not a binary glTF file (.glb); choose a model package, exported from a project");
    if (const std::uint32_t version = wordAt(file, 4); version != 2)
        throw InvalidModel("is glTF of version " + std::to_string(version) + "; version 2 is needed");
    const std::uint32_t announced = wordAt(file, 8);
    if (announced < headerSize || announced > file.size())
        throw InvalidModel("is cut off or damaged: its header speaks of " + std::to_string(announced) +
                           " bytes, but it has " + std::to_string(file.size()) + remedy);
    return announced;
}

} // namespace

std::string jsonPart(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize(paddedSize(text.size()), ' ');
    return text;
}

Bytes writeGlb(const Glb& glb) {
    const std::string text = jsonPart(glb.json);
    Bytes file;
    const std::size_t size =
        headerSize + 2 * chunkHeaderSize + paddedSize(text.size()) + paddedSize(glb.binary.size());
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw InvalidModel(
            "the package would be larger than the 4 GiB a GLB can hold; use smaller or fewer textures");
    file.reserve(size);
    for (const std::uint32_t word : {magic, std::uint32_t{2}, static_cast<std::uint32_t>(size)})
        appendLittleEndian(file, word);
    appendChunk(file, jsonChunk, text, ' ');
    appendChunk(file, binaryChunk, glb.binary, 0);
    return file;
}

Glb parseGlb(const Bytes& file) {
    const GlbParts parts = glbParts(file);
    if (const std::uint32_t announced = wordAt(file, 8); announced != file.size())
        throw InvalidModel("is damaged: its header speaks of " + std::to_string(announced) +
                           " bytes, but it has " + std::to_string(file.size()) + remedy);
    return {parseJson(parts.json, parts.jsonEnd), Bytes(parts.binary, parts.binaryEnd)};
}

GlbParts glbParts(const Bytes& file) {
    const std::size_t end = announcedSize(file);
    GlbParts parts{nullptr, nullptr, nullptr, nullptr};
    for (std::size_t place = headerSize; end - place >= chunkHeaderSize;) {
        const std::size_t size = wordAt(file, place);
        const std::uint32_t type = wordAt(file, place + 4);
        const std::uint8_t* content = file.data() + place + chunkHeaderSize;
        place += chunkHeaderSize;
        if (size > end - place)
            throw InvalidModel("is cut off or damaged: its part at byte " + std::to_string(place) +
                               " announces " + std::to_string(size) + " bytes" + remedy);
        place += size;
        if (!parts.json && type != jsonChunk)
            throw InvalidModel(std::string("is damaged: its first part is not JSON") + remedy);
        if (!parts.json) {
            parts.json = reinterpret_cast<const char*>(content);
            parts.jsonEnd = parts.json + size;
        } else if (type == binaryChunk && !parts.binary) {
            parts.binary = content;
            parts.binaryEnd = content + size;
        }
    }
    if (!parts.json) throw InvalidModel(std::string("is damaged: it has no JSON") + remedy);
    return parts;
}

GltfArrays::GltfArrays(Glb& glb) : m_glb(glb) {
    m_glb.json["accessors"] = Json::array();
    m_glb.json["bufferViews"] = Json::array();
}

std::size_t GltfArrays::addFloats(const std::vector<float>& values, GltfType type, GltfTarget target) {
    assert(!values.empty());
    const std::size_t components = componentsOf(type), begin = m_glb.binary.size();
    for (const float value : values)
        appendLittleEndian(m_glb.binary, value);
    std::vector<float> least(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(components)),
        most = least;
    for (std::size_t i = 0; i < values.size(); ++i) {
        least[i % components] = std::min(least[i % components], values[i]);
        most[i % components] = std::max(most[i % components], values[i]);
    }
    Json& accessors = m_glb.json["accessors"];
    accessors.push_back({{"bufferView", addView(begin, target)},
                         {"componentType", float32Component},
                         {"count", values.size() / components},
                         {"type", nameOf(type)},
                         {"min", std::vector<double>(least.begin(), least.end())},
                         {"max", std::vector<double>(most.begin(), most.end())}});
    return accessors.size() - 1;
}

std::size_t GltfArrays::addIndices(const std::vector<std::uint32_t>& values, GltfTarget target) {
    assert(!values.empty());
    const std::size_t begin = m_glb.binary.size();
    for (const std::uint32_t value : values)
        appendLittleEndian(m_glb.binary, value);
    Json& accessors = m_glb.json["accessors"];
    accessors.push_back({{"bufferView", addView(begin, target)},
                         {"componentType", uint32Component},
                         {"count", values.size()},
                         {"type", nameOf(GltfType::Scalar)}});
    return accessors.size() - 1;
}

std::size_t GltfArrays::addFile(const Bytes& content) {
    const std::size_t begin = m_glb.binary.size();
    m_glb.binary.insert(m_glb.binary.end(), content.begin(), content.end());
    return addView(begin, GltfTarget::None);
}

std::size_t GltfArrays::views() const {
    return m_glb.json["bufferViews"].size();
}

std::size_t GltfArrays::addView(std::size_t begin, GltfTarget target) {
    Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", m_glb.binary.size() - begin}};
    if (target != GltfTarget::None) view["target"] = static_cast<int>(target);
    pad(m_glb.binary, 0);
    Json& views = m_glb.json["bufferViews"];
    views.push_back(std::move(view));
    return views.size() - 1;
}

GltfArrayReader::GltfArrayReader(const Glb& glb, std::vector<std::string>& problems,
                                 std::vector<std::size_t> damaged)
    : m_glb(glb), m_problems(problems), m_damaged(std::move(damaged)) {}

bool GltfArrayReader::isDamaged(const JsonReader& bufferView) const {
    const Json& place = bufferView.json();
    return place.is_number_unsigned() &&
           std::find(m_damaged.begin(), m_damaged.end(), place.get<std::size_t>()) != m_damaged.end();
}

JsonReader GltfArrayReader::element(const char* list, const JsonReader& reference) const {
    const auto found = m_glb.json.find(list);
    const std::size_t size = found != m_glb.json.end() && found->is_array() ? found->size() : 0;
    if (reference.json().is_null()) return reference;
    if (!reference.json().is_number_unsigned() || reference.json().get<std::uint64_t>() >= size) {
        reference.addProblem("should name one of the " + std::to_string(size) + " " + list);
        return reference.nothing();
    }
    const auto place = reference.json().get<std::size_t>();
    JsonReader json{(*found)[place], std::string(list) + "/" + std::to_string(place), m_problems};
    if (!(*found)[place].is_null()) return json;
    json.addProblem("is nothing, where an object should be");
    return reference.nothing();
}

std::size_t GltfArrayReader::count(const JsonReader& accessor) const {
    return static_cast<std::size_t>(
        element("accessors", accessor).member("count").integer(1, m_glb.binary.size()));
}

std::span<const std::uint8_t> GltfArrayReader::view(const JsonReader& reference) const {
    const JsonReader json = element("bufferViews", reference);
    if (json.json().is_null()) return {};
    const std::size_t whole = m_glb.binary.size(), known = m_problems.size();
    json.member("buffer").integer(0, 0);
    const std::size_t offset = json.has("byteOffset") ? json.member("byteOffset").integer(0, whole) : 0;
    const std::size_t size = json.member("byteLength").integer(1, whole);
    if (json.has("byteStride")) json.addProblem("should have no byteStride");
    if (m_problems.size() == known && size <= whole - offset) return Span(m_glb.binary).subspan(offset, size);
    if (m_problems.size() == known) json.addProblem("reaches beyond the file's binary data");
    return {};
}

GltfArrayReader::Span GltfArrayReader::array(const JsonReader& reference, unsigned componentType,
                                             GltfType type, std::size_t count) const {
    const JsonReader json = element("accessors", reference);
    if (json.json().is_null()) return {};
    const JsonReader bytes = json.member("bufferView");
    if (isDamaged(bytes)) {
        reference.addProblem(damagedArray);
        return {};
    }
    const Span span = view(bytes);
    const std::size_t known = m_problems.size();
    const std::size_t offset = json.has("byteOffset") ? json.member("byteOffset").integer(0, span.size()) : 0;
    const std::size_t size = count * componentsOf(type) * sizeof(float);
    if (json.member("componentType").integer(0, 65535) != componentType)
        json.addProblem("should have the componentType " + std::to_string(componentType));
    if (json.member("type").text() != nameOf(type))
        json.addProblem(std::string("should be of type ") + nameOf(type));
    if (json.member("count").integer(0, m_glb.binary.size()) != count)
        json.addProblem("should have " + std::to_string(count) + " elements, for " + reference.place());
    if (json.has("sparse")) json.addProblem("should not be sparse");
    if (m_problems.size() != known || span.empty()) return {};
    if (offset % sizeof(float) == 0 && size <= span.size() - offset) return span.subspan(offset, size);
    json.addProblem("reaches beyond its bufferView");
    return {};
}

std::vector<float> GltfArrayReader::floats(const JsonReader& accessor, GltfType type,
                                           std::size_t count) const {
    const Span span = array(accessor, float32Component, type, count);
    std::vector<float> values;
    values.reserve(span.size() / sizeof(float));
    for (std::size_t i = 0; i < span.size(); i += sizeof(float))
        values.push_back(littleEndian<float>(&span[i]));
    const auto bad =
        std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
    if (bad == values.end()) return values;
    accessor.addProblem("holds a number that is not finite, number " + std::to_string(bad - values.begin()));
    return {};
}

std::vector<std::uint32_t> GltfArrayReader::indices(const JsonReader& accessor, std::size_t count,
                                                    std::size_t limit) const {
    const Span span = array(accessor, uint32Component, GltfType::Scalar, count);
    std::vector<std::uint32_t> values;
    values.reserve(span.size() / sizeof(std::uint32_t));
    for (std::size_t i = 0; i < span.size(); i += sizeof(std::uint32_t))
        values.push_back(littleEndian<std::uint32_t>(&span[i]));
    if (limit == 0 && !m_problems.empty()) return values;
    const auto bad =
        std::find_if(values.begin(), values.end(), [&](std::uint32_t value) { return value >= limit; });
    if (bad == values.end()) return values;
    accessor.addProblem("holds " + std::to_string(*bad) + " as number " +
                        std::to_string(bad - values.begin()) + ", but should stay below " +
                        std::to_string(limit));
    return {};
}

Bytes GltfArrayReader::file(const JsonReader& bufferView) const {
    if (isDamaged(bufferView)) {
        bufferView.addProblem(damagedArray);
        return {};
    }
    const Span span = view(bufferView);
    return Bytes(span.begin(), span.end());
}

} // namespace esm
