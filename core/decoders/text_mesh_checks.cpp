#include "core/decoders/mesh_file_checks.h"
#include "core/support/byte_order.h"
#include "core/support/errors.h"
#include "core/support/text_lines.h"

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

bool isBlank(std::string_view line) {
    return line.find_first_not_of(" \t") == std::string_view::npos;
}

/// A file that is cut off must not pass for a small one: each announced line is looked for and read.
class OffChecker {
public:
    OffChecker(const fs::path& file, const Bytes& content) : m_file(file), m_lines(content) {}

    /// The number of faces.
    std::uint64_t check() {
        readCounts();
        for (std::uint64_t i = 0; i < m_vertices; ++i)
            if (!nextData() || !holdsThreeNumbers(m_line))
                fail("announces " + std::to_string(m_vertices) + " vertices, but number " +
                     std::to_string(i) + atLine(m_lines) + " is missing or damaged; the file may be cut off");
        for (std::uint64_t i = 0; i < m_faces; ++i)
            if (!nextData() || !isFace(m_line))
                fail("announces " + std::to_string(m_faces) + " faces, but number " + std::to_string(i) +
                     atLine(m_lines) + " is missing, damaged or names a missing vertex");
        return m_faces;
    }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw FileError(m_file, problem + "; export it again");
    }

    /// The next line that holds more than a comment.
    bool nextData() {
        while (m_lines.next(m_line)) {
            m_line = m_line.substr(0, m_line.find('#'));
            if (!isBlank(m_line)) return true;
        }
        return false;
    }

    /// The counts may stand beside the format's name or below it.
    void readCounts() {
        if (!nextData() || takeWord(m_line).find("OFF") == std::string_view::npos)
            throw FileError(m_file, "does not begin with OFF; choose a file of the kind its ending says");
        if (isBlank(m_line)) nextData();
        const auto vertices = wholeNumber<std::uint64_t>(takeWord(m_line));
        const auto faces = wholeNumber<std::uint64_t>(takeWord(m_line));
        if (!vertices || !faces) fail("does not give its counts of vertices and faces" + atLine(m_lines));
        m_vertices = *vertices;
        m_faces = *faces;
    }

    bool isFace(std::string_view line) const {
        const std::uint64_t corners = wholeNumber<std::uint64_t>(takeWord(line)).value_or(0);
        if (corners == 0 || corners > line.size()) return false;
        for (std::uint64_t corner = 0; corner < corners; ++corner) {
            const auto index = wholeNumber<std::uint64_t>(takeWord(line));
            if (!index || *index >= m_vertices) return false;
        }
        return true;
    }

    const fs::path& m_file;
    TextLines m_lines;
    std::string_view m_line;
    std::uint64_t m_vertices = 0, m_faces = 0;
};

} // namespace

std::size_t checkOff(const fs::path& file, const Bytes& content) {
    refuseBinary(file, content, "OFF");
    return OffChecker(file, content).check();
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

/// Whether an STL file is binary is told by its size and not by its first word: many binary ones begin with
/// "solid" in their free text. Of the right size for its count it is binary; else it is a text, or cut off.
std::size_t checkStl(const fs::path& file, const Bytes& content) {
    constexpr std::size_t headerSize = 84, triangleSize = 50;
    const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
    const std::uint32_t count = content.size() >= headerSize ? littleEndian<std::uint32_t>(&content[80]) : 0;
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
