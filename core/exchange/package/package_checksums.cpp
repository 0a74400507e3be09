#include "core/exchange/package/package_checksums.h"

#include "core/exchange/package/package_layout.h"
#include "core/support/byte_order.h"
#include "core/support/checksum.h"

#include <algorithm>
#include <limits>

// One number for each buffer view, its CRC-32, in an array that lies in the last view. That one would be of
// its own bytes; in its place stands the sum of the JSON part, which can be complete before the sums are
// known, as it names their place alone. Views that overlap are refused: a small file with many of them could
// ask for sums of any number of bytes.

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// Views that are looked for: one alone makes a file be refused, and no message names more.
constexpr std::size_t mostDamaged = 20;

std::uint32_t checksumOfPart(const char* begin, const char* end) {
    return checksumOf(reinterpret_cast<const std::uint8_t*>(begin), static_cast<std::size_t>(end - begin));
}

/// The sums that the file has, one per buffer view; empty where it has none, or none that can be read.
std::vector<std::uint32_t> writtenChecksums(const Glb& glb, std::vector<std::string>& problems) {
    const JsonReader gltf(glb.json, "", problems);
    const JsonReader extension = gltf.member("extensions").member(package_layout::extension);
    if (!extension.json().is_object() || !extension.has("checksums")) return {};
    const GltfArrayReader arrays(glb, problems);
    const JsonReader place = extension.member("checksums");
    const std::size_t views = gltf.member("bufferViews").elements().size();
    const JsonReader view = arrays.element("accessors", place).member("bufferView");
    if (!problems.empty()) return {};
    if (view.integer(0, views) + 1 != views) place.addProblem("should lie in the last of the bufferViews");
    return arrays.indices(place, views, std::numeric_limits<std::size_t>::max());
}

/// "meshes/0/primitives/0/NORMAL", "images/1"; the view's own place where nothing draws it.
std::string drawnFrom(const Glb& glb, std::size_t view) {
    std::vector<std::string> ignored;
    const JsonReader reader(glb.json, "", ignored);
    const GltfArrayReader arrays(glb, ignored);
    const auto isMeant = [&](const JsonReader& place) { return place.json() == view; };
    if (reader.has("images"))
        for (const JsonReader& image : reader.member("images").elements())
            if (isMeant(image.member("bufferView"))) return image.place();
    for (const JsonReader& mesh : reader.member("meshes").elements())
        for (const JsonReader& primitive : mesh.member("primitives").elements())
            for (const auto& [name, accessor] : primitive.member("attributes").members())
                if (isMeant(arrays.element("accessors", accessor).member("bufferView")))
                    return primitive.place() + "." + name;
    return "bufferViews/" + std::to_string(view);
}

} // namespace

std::size_t addChecksums(GltfArrays& arrays) {
    return arrays.addIndices(std::vector<std::uint32_t>(arrays.views() + 1, 0));
}

void fillChecksums(Glb& glb) {
    const Json& views = glb.json["bufferViews"];
    const std::string json = jsonPart(glb.json);
    Bytes sums;
    for (std::size_t view = 0; view + 1 < views.size(); ++view)
        appendLittleEndian(sums, checksumOf(&glb.binary[views[view]["byteOffset"].get<std::size_t>()],
                                            views[view]["byteLength"].get<std::size_t>()));
    appendLittleEndian(sums, checksumOfPart(json.data(), json.data() + json.size()));
    const auto place = views.back()["byteOffset"].get<std::ptrdiff_t>();
    std::copy(sums.begin(), sums.end(), glb.binary.begin() + place);
}

std::vector<std::size_t> damagedViews(const Bytes& file, const Glb& glb, std::vector<std::string>& problems) {
    const std::vector<std::uint32_t> sums = writtenChecksums(glb, problems);
    if (sums.empty()) return {};
    const GlbParts parts = glbParts(file);
    if (checksumOfPart(parts.json, parts.jsonEnd) != sums.back()) {
        problems.emplace_back("the JSON is damaged, or was changed without its check sums; copy the file "
                              "again, or export it anew");
        return {};
    }
    const GltfArrayReader arrays(glb, problems);
    std::vector<std::size_t> damaged;
    std::size_t summed = 0;
    for (std::size_t view = 0; view + 1 < sums.size() && damaged.size() < mostDamaged; ++view) {
        const Json place = view;
        const auto bytes = arrays.view(JsonReader(place, "bufferViews/" + std::to_string(view), problems));
        summed += bytes.size();
        if (summed > glb.binary.size()) {
            problems.emplace_back(
                "bufferViews overlap, which check sums do not allow; export it anew, or leave "
                "the check sums out");
            return {};
        }
        if (!bytes.empty() && checksumOf(bytes.data(), bytes.size()) != sums[view]) damaged.push_back(view);
    }
    return damaged;
}

std::vector<std::string> damageProblems(const Glb& glb, const std::vector<std::size_t>& damaged) {
    std::vector<std::string> problems;
    problems.reserve(damaged.size());
    for (const std::size_t view : damaged)
        problems.push_back(drawnFrom(glb, view) + " " + damagedArray);
    return problems;
}

} // namespace esm
