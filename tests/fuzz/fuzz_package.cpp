#include "core/exchange/model_package.h"
#include "core/exchange/package/glb.h"
#include "core/support/byte_order.h"
#include "core/support/checksum.h"
#include "core/support/errors.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_input.h"
#include "tests/fuzz/mutation.h"

#include <algorithm>

namespace esm::fuzz {

namespace {

/// The JSON and the binary data of a package; empty where it is none.
std::vector<Bytes> chunksOf(const Bytes& glb) {
    try {
        const GlbParts parts = glbParts(glb);
        return {{parts.json, parts.jsonEnd}, {parts.binary, parts.binaryEnd}};
    } catch (const InvalidModel&) {
        return {};
    }
}

/// What is changed would be found by them alone.
Bytes withoutChecksums(const Bytes& text) {
    const auto springMass = "/extensions/ESM_spring_mass"_json_pointer;
    try {
        nlohmann::ordered_json json = jsonFrom(text);
        if (!json.contains(springMass / "checksums")) return text;
        json[springMass].erase("checksums");
        const std::string changed = json.dump();
        return {changed.begin(), changed.end()};
    } catch (const InvalidModel&) {
        return text;
    }
}

/// Lets the sum of the JSON, the last of the sums, fit: the others are looked at behind it.
void fitSumOfJson(std::vector<Bytes>& chunks) {
    while (chunks[0].size() % 4 != 0)
        chunks[0].push_back(' ');
    try {
        const nlohmann::ordered_json json = jsonFrom(chunks[0]);
        const nlohmann::ordered_json& views = json.at("bufferViews");
        if (views.empty()) return;
        const nlohmann::ordered_json& sums = views.back();
        const nlohmann::ordered_json &offset = sums.at("byteOffset"), &length = sums.at("byteLength");
        if (!offset.is_number_unsigned() || !length.is_number_unsigned()) return;
        const std::size_t end = offset.get<std::size_t>() + length.get<std::size_t>();
        Bytes sum;
        appendLittleEndian(sum, checksumOf(chunks[0].data(), chunks[0].size()));
        if (end >= sum.size() && end <= chunks[1].size())
            std::copy(sum.begin(), sum.end(),
                      chunks[1].begin() + static_cast<std::ptrdiff_t>(end - sum.size()));
    } catch (const std::exception&) {
        return; // there is no place for it
    }
}

void addChunk(Bytes& glb, std::uint32_t kind, Bytes chunk, std::uint8_t filling) {
    while (chunk.size() % 4 != 0)
        chunk.push_back(filling);
    appendLittleEndian(glb, static_cast<std::uint32_t>(chunk.size()));
    appendLittleEndian(glb, kind);
    glb.insert(glb.end(), chunk.begin(), chunk.end());
}

/// Not by writeGlb(), which takes no text that is none of JSON.
Bytes glbOf(const std::vector<Bytes>& chunks) {
    constexpr std::uint32_t magic = 0x46546C67, version = 2, json = 0x4E4F534A, binary = 0x004E4942;
    Bytes content;
    addChunk(content, json, chunks[0], ' ');
    addChunk(content, binary, chunks[1], 0);
    Bytes glb;
    for (const std::uint32_t word : {magic, version, static_cast<std::uint32_t>(12 + content.size())})
        appendLittleEndian(glb, word);
    glb.insert(glb.end(), content.begin(), content.end());
    return glb;
}

} // namespace

/// Model packages, by both readers: what the one takes for a tissue the other does too.
void readInput(const Bytes& content) {
    const FileInMemory file(content);
    try {
        loadPackage(file.path());
    } catch (const FileError&) {
        loadPackagedTissue(file.path());
        return;
    }
    try {
        loadPackagedTissue(file.path());
    } catch (const FileError& refusal) {
        expect(false, refusal.what());
    }
}

} // namespace esm::fuzz

/// Changes the JSON or the binary data inside, as most changes of the file itself leave it no package; every
/// second time without check sums.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    const esm::fuzz::FuzzedInput input{{data, most}, size, seed};
    std::vector<esm::Bytes> chunks = esm::fuzz::chunksOf(input.content());
    if (chunks.empty() || seed % 16 == 0) return input.mutated();
    const bool hasChecksums = seed / 16 % 2 == 0;
    if (!hasChecksums) chunks[0] = esm::fuzz::withoutChecksums(chunks[0]);
    esm::Bytes& chunk = chunks[seed % 16 < 12 ? 0 : 1];
    chunk = esm::fuzz::mutatedPart(std::move(chunk), seed / 32);
    if (hasChecksums) esm::fuzz::fitSumOfJson(chunks);
    return input.replacedBy(esm::fuzz::glbOf(chunks));
}
