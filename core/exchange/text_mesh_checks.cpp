#include "core/exchange/mesh_file_checks.h"
#include "core/exchange/text_lines.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cstdint>

namespace esm {

namespace fs = std::filesystem;

namespace {

std::string atLine(const TextLines& lines) {
    return " in line " + std::to_string(lines.number());
}

bool holdsThreeNumbers(std::string_view rest) {
    for (int i = 0; i < 3; ++i)
        if (!wholeNumber<double>(takeWord(rest))) return false;
    return true;
}

} // namespace

std::size_t checkOff(const fs::path& file, const Bytes& content) {
    refuseBinary(file, content, "OFF");
    TextLines lines(content);
    const auto nextData = [&lines](std::string_view& line) {
        while (lines.next(line)) {
            line = line.substr(0, line.find('#'));
            if (line.find_first_not_of(" \t") != line.npos) return true;
        }
        return false;
    };
    std::string_view line;
    if (!nextData(line) || takeWord(line).find("OFF") == line.npos)
        throw FileError(file, "does not begin with OFF; choose a file of the kind its ending says");
    if (line.find_first_not_of(" \t") == line.npos) nextData(line);
    const auto vertexCount = wholeNumber<std::uint64_t>(takeWord(line));
    const auto faceCount = wholeNumber<std::uint64_t>(takeWord(line));
    if (!vertexCount || !faceCount)
        throw FileError(file, "does not give its counts of vertices and faces" + atLine(lines) +
                                  "; export it again");
    for (std::uint64_t i = 0; i < *vertexCount; ++i)
        if (!nextData(line) || !holdsThreeNumbers(line))
            throw FileError(file, "announces " + std::to_string(*vertexCount) + " vertices, but number " +
                                      std::to_string(i) + atLine(lines) +
                                      " is missing or damaged; the file may be cut off; export it again");
    for (std::uint64_t i = 0; i < *faceCount; ++i) {
        const bool there = nextData(line);
        const std::uint64_t corners = there ? wholeNumber<std::uint64_t>(takeWord(line)).value_or(0) : 0;
        bool whole = corners > 0 && corners <= line.size();
        for (std::uint64_t corner = 0; whole && corner < corners; ++corner) {
            const auto index = wholeNumber<std::uint64_t>(takeWord(line));
            whole = index && *index < *vertexCount;
        }
        if (!whole)
            throw FileError(file, "announces " + std::to_string(*faceCount) + " faces, but number " +
                                      std::to_string(i) + atLine(lines) +
                                      " is missing, damaged or names a missing vertex; export it again");
    }
    return *faceCount;
}

namespace {

/// A text that is no STL differs from a cut-off STL in having neither NUL nor other control characters.
bool isText(const Bytes& content) {
    const std::size_t looked = std::min<std::size_t>(content.size(), 512);
    return std::none_of(content.begin(), content.begin() + static_cast<std::ptrdiff_t>(looked),
                        [](std::uint8_t byte) { return byte < 9; });
}

std::size_t checkStlText(const fs::path& file, const Bytes& content) {
    TextLines lines(content);
    std::size_t facets = 0, vertices = 0;
    bool ended = false;
    for (std::string_view line; lines.next(line);) {
        const std::string_view keyword = takeWord(line);
        facets += keyword == "facet";
        ended = ended || keyword == "endsolid";
        if (keyword != "vertex") continue;
        ++vertices;
        if (!holdsThreeNumbers(line) || vertices > 3 * facets)
            throw FileError(file, "has a corner that is damaged or belongs to no facet" + atLine(lines) +
                                      "; export it again");
    }
    if (!ended || vertices != 3 * facets)
        throw FileError(file, "is cut off" + atLine(lines) + ": after " + std::to_string(facets) +
                                  " facets, corners or \"endsolid\" are missing; export it again");
    return facets;
}

} // namespace

std::size_t checkStl(const fs::path& file, const Bytes& content) {
    constexpr std::size_t headerSize = 84, triangleSize = 50;
    const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    std::uint32_t count = 0;
    if (content.size() >= headerSize)
        for (std::size_t i = 0; i < 4; ++i)
            count |= std::uint32_t{content[80 + i]} << (8 * i);
    const std::size_t held = content.size() >= headerSize ? (content.size() - headerSize) / triangleSize : 0;
    if (content.size() >= headerSize && content.size() == headerSize + std::size_t{count} * triangleSize)
        return count;

    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (isText(content)) {
        if (begin == text.npos || text.substr(begin, 5) != "solid")
            throw FileError(file, "is a text that does not begin with \"solid\", so it is no STL file; "
                                  "choose a file of the kind its ending says");
        return checkStlText(file, content);
    }
    if (content.size() < headerSize)
        throw FileError(file, "is cut off or no STL file: it ends at byte " + std::to_string(content.size()) +
                                  ", within the header; export it again");
    if (count > held)
        throw FileError(file, "is cut off or no STL file: it announces " + std::to_string(count) +
                                  " triangles and has room for " + std::to_string(held) +
                                  "; export it again");
    return count;
}

} // namespace esm
