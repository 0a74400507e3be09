#include "core/exchange/project/pairs_file.h"

#include "core/support/file_io.h"
#include "core/support/numbers.h"
#include "core/support/text_lines.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace esm {

namespace {

constexpr std::string_view pairsHeader = "photo_x,photo_y,x,y,z";

std::string_view bare(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string withoutBlanks(std::string_view line) {
    std::string kept;
    std::copy_if(line.begin(), line.end(), std::back_inserter(kept),
                 [](char c) { return c != ' ' && c != '\t'; });
    return kept;
}

/// Five finite numbers between commas.
std::optional<LandmarkPair> pairOf(std::string_view line) {
    std::array<double, 5> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t end = line.find(',');
        if ((end == line.npos) != (i + 1 == numbers.size())) return std::nullopt;
        const auto number = wholeNumber<double>(bare(line.substr(0, end)));
        if (!number || !std::isfinite(*number)) return std::nullopt;
        numbers[i] = *number;
        line.remove_prefix(end == line.npos ? line.size() : end + 1);
    }
    return LandmarkPair{{numbers[0], numbers[1]}, {numbers[2], numbers[3], numbers[4]}};
}

} // namespace

std::vector<LandmarkPair> readPairsFile(const std::filesystem::path& file) {
    constexpr std::uint64_t largest = std::uint64_t{64} << 20;
    const Bytes content = readFile(file, largest);
    refuseBinary(file, content, "CSV");
    TextLines lines(content);
    std::string_view line;
    if (lines.next(line) && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3); // some spreadsheets
    if (withoutBlanks(line) != pairsHeader)
        throw FileError(file, "line 1 should be " + std::string(pairsHeader) + ", the names of the columns");
    std::vector<LandmarkPair> pairs;
    while (lines.next(line)) {
        if (bare(line).empty()) continue;
        const std::optional<LandmarkPair> pair = pairOf(line);
        if (!pair)
            throw FileError(file, "line " + std::to_string(lines.number()) +
                                      " is no pair: give five finite numbers, " + std::string(pairsHeader) +
                                      ", in pixels and metres");
        if (pairs.size() == texture_limits::mostLandmarks)
            throw FileError(file,
                            "has more than " + std::to_string(texture_limits::mostLandmarks) + " pairs");
        pairs.push_back(*pair);
    }
    return pairs;
}

void writePairsFile(const std::vector<LandmarkPair>& pairs, const std::filesystem::path& file) {
    std::string text = std::string(pairsHeader) + "\n";
    for (const auto& [photo, organ] : pairs)
        text += exactText(photo.x()) + ',' + exactText(photo.y()) + ',' + exactText(organ.x()) + ',' +
                exactText(organ.y()) + ',' + exactText(organ.z()) + '\n';
    writeFileAtomically(file, text);
}

} // namespace esm
