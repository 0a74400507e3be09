#include "core/decoders/vtk_polydata.h"

#include "core/support/byte_order.h"
#include "core/support/errors.h"
#include "core/support/text_lines.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string_view>

namespace esm {

namespace {

/// How one number is stored in the binary form. All are big-endian.
struct NumberType {
    std::string_view name;
    std::size_t bytes;
    enum class Kind { Signed, Unsigned, Real } kind;
};

constexpr NumberType fileInt{"int", 4, NumberType::Kind::Signed};

// vtkIdType is written as a 4-byte int by VTK itself; `long` as on the 64-bit systems that write it.
constexpr std::array numberTypes{
    NumberType{"char", 1, NumberType::Kind::Signed},
    NumberType{"unsigned_char", 1, NumberType::Kind::Unsigned},
    NumberType{"short", 2, NumberType::Kind::Signed},
    NumberType{"unsigned_short", 2, NumberType::Kind::Unsigned},
    fileInt,
    NumberType{"unsigned_int", 4, NumberType::Kind::Unsigned},
    NumberType{"long", 8, NumberType::Kind::Signed},
    NumberType{"unsigned_long", 8, NumberType::Kind::Unsigned},
    NumberType{"vtkidtype", 4, NumberType::Kind::Signed},
    NumberType{"vtktypeint32", 4, NumberType::Kind::Signed},
    NumberType{"vtktypeint64", 8, NumberType::Kind::Signed},
    NumberType{"vtktypeuint32", 4, NumberType::Kind::Unsigned},
    NumberType{"vtktypeuint64", 8, NumberType::Kind::Unsigned},
    NumberType{"float", 4, NumberType::Kind::Real},
    NumberType{"double", 8, NumberType::Kind::Real},
};

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& letter : result)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return result;
}

bool isSpace(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

/// Legacy VTK is text whose numbers may be binary, in sections that name themselves. It is read by one cursor
/// over the whole file; before anything is allocated, what a section announces is held against what is left
/// of the file, as a count is quickly damaged and memory quickly full.
class VtkParser {
public:
    VtkParser(const std::filesystem::path& file, const Bytes& content)
        : m_file(file), m_text(reinterpret_cast<const char*>(content.data()), content.size()) {}

    PolygonSoup parse() {
        parseHeader();
        while (parseSection(lowerCase(nextWord()))) {
        }
        return std::move(m_soup);
    }

private:
    void parseHeader();
    bool parseSection(const std::string& keyword);
    void parsePoints();
    std::vector<std::vector<std::uint32_t>> parseCells();
    std::vector<std::vector<std::uint32_t>> parseOffsetCells(std::size_t offsetCount,
                                                             std::size_t cornerCount);
    void addPolygons();
    void addStrips();
    void skipFields();
    void skipMetadata();

    std::string_view nextLine();
    std::string_view nextWord();
    /// Of the text form.
    template<typename Number> Number nextNumber(const std::string& expected);
    std::size_t nextCount();
    NumberType nextType();
    void expectWord(std::string_view word);
    /// The place of `count` numbers, checked to lie within the file as far as that can be known.
    void beginNumbers(std::size_t count, std::size_t perItem, const NumberType& type);
    double nextReal(const NumberType& type);
    std::int64_t nextInteger(const NumberType& type);
    std::uint64_t nextBits(std::size_t bytes);
    std::uint32_t nextIndex(const NumberType& type);
    void skipNumbers(std::size_t count, const NumberType& type);
    [[noreturn]] void fail(const std::string& problem) const;

    const std::filesystem::path& m_file;
    std::string_view m_text;
    std::size_t m_at = 0;
    bool m_binary = false;
    bool m_offsetCells = false; ///< since version 5.0
    PolygonSoup m_soup;
};

void VtkParser::fail(const std::string& problem) const {
    const std::string_view before = m_text.substr(0, m_at);
    const std::string place =
        m_binary ? "byte " + std::to_string(m_at)
                 : "line " + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
    throw FileError(m_file, problem + " (at " + place + " of " +
                                (m_binary ? std::to_string(m_text.size()) + " bytes" : "the file") +
                                "); export it again from the program that made it");
}

std::string_view VtkParser::nextLine() {
    const std::size_t end = std::min(m_text.find('\n', m_at), m_text.size());
    std::string_view line = m_text.substr(m_at, end - m_at);
    m_at = std::min(end + 1, m_text.size());
    while (!line.empty() && isSpace(line.back()))
        line.remove_suffix(1);
    return line;
}

std::string_view VtkParser::nextWord() {
    while (m_at < m_text.size() && isSpace(m_text[m_at]))
        ++m_at;
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && !isSpace(m_text[m_at]))
        ++m_at;
    return m_text.substr(begin, m_at - begin);
}

std::size_t VtkParser::nextCount() {
    return nextNumber<std::size_t>("a count");
}

NumberType VtkParser::nextType() {
    const std::string word = lowerCase(nextWord());
    for (const NumberType& type : numberTypes)
        if (type.name == word) return type;
    fail("has numbers of the unknown type \"" + word.substr(0, 40) + "\"");
}

void VtkParser::expectWord(std::string_view word) {
    const std::string found = lowerCase(nextWord());
    if (found != lowerCase(word))
        fail("has \"" + found.substr(0, 40) + "\" where " + std::string(word) + " is expected");
}

void VtkParser::parseHeader() {
    const std::string_view first = nextLine();
    constexpr std::string_view magic = "# vtk datafile version ";
    if (lowerCase(first.substr(0, magic.size())) != magic)
        throw FileError(m_file, "is not a legacy VTK file: its first line is not \"# vtk DataFile Version\"; "
                                "save it as legacy VTK polydata, PLY, STL or OBJ");
    const std::string version(first.substr(magic.size()));
    const char major = version.empty() ? ' ' : version.front();
    if (major < '1' || major > '5' || (version.size() > 1 && version[1] != '.'))
        throw FileError(m_file, "is of the legacy VTK version \"" + version.substr(0, 20) +
                                    "\"; versions 1.0 to 5.1 can be read; save it in one of them");
    m_offsetCells = major == '5';
    nextLine(); // the title
    const std::string form = lowerCase(nextWord());
    if (form != "ascii" && form != "binary") fail("has neither ASCII nor BINARY in its third line");
    expectWord("DATASET");
    const std::string dataset = lowerCase(nextWord());
    if (dataset != "polydata")
        throw FileError(m_file, "holds a VTK dataset \"" + dataset.substr(0, 40) +
                                    "\" and no surface; save the surface as POLYDATA");
    m_binary = form == "binary";
}

/// False at the end of what describes the surface.
bool VtkParser::parseSection(const std::string& keyword) {
    if (keyword.empty() || keyword == "point_data" || keyword == "cell_data") return false;
    if (keyword == "points")
        parsePoints();
    else if (keyword == "polygons")
        addPolygons();
    else if (keyword == "triangle_strips")
        addStrips();
    else if (keyword == "vertices" || keyword == "lines")
        parseCells();
    else if (keyword == "metadata")
        skipMetadata();
    else if (keyword == "field")
        skipFields();
    else
        fail("has \"" + keyword.substr(0, 40) + "\" where a section of polydata is expected");
    return true;
}

/// Divided and not multiplied: count · size of a damaged file may wrap around. In text a number takes two
/// bytes at least, one of which the last one may lack.
void VtkParser::beginNumbers(std::size_t count, std::size_t perItem, const NumberType& type) {
    if (m_binary) nextLine();
    const std::size_t smallest = m_binary ? type.bytes : 2; // one digit and a space
    const std::size_t left = m_text.size() - m_at + (m_binary ? 0 : 1);
    if (count > left / smallest / perItem)
        fail("is cut off: " + std::to_string(count) +
             " entries are announced, more than the rest of the file can hold");
}

std::uint64_t VtkParser::nextBits(std::size_t bytes) {
    if (m_text.size() - m_at < bytes) fail("is cut off in the middle of its numbers");
    const auto* place = reinterpret_cast<const std::uint8_t*>(m_text.data() + m_at);
    m_at += bytes;
    return unsignedNumber(place, bytes, ByteOrder::Big);
}

double VtkParser::nextReal(const NumberType& type) {
    if (m_binary) {
        if (type.kind != NumberType::Kind::Real) return static_cast<double>(nextInteger(type));
        const std::uint64_t bits = nextBits(type.bytes);
        if (type.bytes == 8) {
            double value = 0;
            std::memcpy(&value, &bits, sizeof value);
            return value;
        }
        const auto half = static_cast<std::uint32_t>(bits);
        float value = 0;
        std::memcpy(&value, &half, sizeof value);
        return value;
    }
    return nextNumber<double>("a number");
}

template<typename Number> Number VtkParser::nextNumber(const std::string& expected) {
    const std::string_view word = nextWord();
    if (word.empty()) fail("is cut off in the middle of its numbers");
    const auto number = wholeNumber<Number>(word);
    if (!number) fail("has \"" + std::string(word.substr(0, 40)) + "\" where " + expected + " is expected");
    return *number;
}

/// Two's complement in fewer bytes is widened by shifting the sign up to the highest bit and back.
std::int64_t VtkParser::nextInteger(const NumberType& type) {
    if (m_binary) {
        const std::uint64_t bits = nextBits(type.bytes);
        if (type.kind == NumberType::Kind::Unsigned || type.bytes == 8)
            return static_cast<std::int64_t>(bits);
        const std::size_t shift = 64 - 8 * type.bytes;
        return static_cast<std::int64_t>(bits << shift) >> shift;
    }
    return nextNumber<std::int64_t>("a whole number");
}

std::uint32_t VtkParser::nextIndex(const NumberType& type) {
    const std::int64_t index = nextInteger(type);
    if (index < 0 || index >= static_cast<std::int64_t>(m_soup.vertices.size()))
        fail("names point " + std::to_string(index) + ", but there are " +
             std::to_string(m_soup.vertices.size()) + " points");
    return static_cast<std::uint32_t>(index);
}

void VtkParser::skipNumbers(std::size_t count, const NumberType& type) {
    beginNumbers(count, 1, type);
    if (m_binary)
        m_at += count * type.bytes;
    else
        for (std::size_t i = 0; i < count; ++i)
            nextReal(type);
}

void VtkParser::parsePoints() {
    if (!m_soup.vertices.empty()) fail("has a second list of POINTS, beside the one that its polygons name");
    const std::size_t count = nextCount();
    if (count > std::numeric_limits<std::uint32_t>::max()) fail("announces more points than can be numbered");
    const NumberType type = nextType();
    beginNumbers(count, 3, type);
    m_soup.vertices.resize(count);
    for (Eigen::Vector3d& point : m_soup.vertices)
        for (double& coordinate : point.reshaped())
            coordinate = nextReal(type);
}

std::vector<std::vector<std::uint32_t>> VtkParser::parseCells() {
    const std::size_t cellCount = nextCount(), numberCount = nextCount();
    if (m_offsetCells) return parseOffsetCells(cellCount, numberCount);
    if (cellCount > numberCount) fail("announces more cells than numbers to describe them");
    beginNumbers(numberCount, 1, fileInt);
    std::vector<std::vector<std::uint32_t>> cells(cellCount);
    std::size_t left = numberCount;
    for (std::vector<std::uint32_t>& cell : cells) {
        const std::int64_t corners = left > 0 ? nextInteger(fileInt) : -1;
        if (corners < 0 || static_cast<std::size_t>(corners) > left - 1)
            fail("has a cell whose corners do not fit the announced size");
        cell.resize(static_cast<std::size_t>(corners));
        for (std::uint32_t& corner : cell)
            corner = nextIndex(fileInt);
        left -= 1 + cell.size();
    }
    if (left != 0) fail("has cells that do not add up to the announced size");
    return cells;
}

std::vector<std::vector<std::uint32_t>> VtkParser::parseOffsetCells(std::size_t offsetCount,
                                                                    std::size_t cornerCount) {
    expectWord("OFFSETS");
    const NumberType offsetType = nextType();
    beginNumbers(offsetCount, 1, offsetType);
    std::vector<std::size_t> offsets(offsetCount);
    for (std::size_t i = 0; i < offsetCount; ++i) {
        const std::int64_t offset = nextInteger(offsetType);
        if (offset < static_cast<std::int64_t>(i == 0 ? 0 : offsets[i - 1]) ||
            offset > static_cast<std::int64_t>(cornerCount))
            fail("has cell offsets that do not rise from 0 to the announced " + std::to_string(cornerCount));
        offsets[i] = static_cast<std::size_t>(offset);
    }
    if (offsetCount > 0 && (offsets.front() != 0 || offsets.back() != cornerCount))
        fail("has cell offsets that do not reach from 0 to the announced " + std::to_string(cornerCount));
    expectWord("CONNECTIVITY");
    const NumberType cornerType = nextType();
    beginNumbers(cornerCount, 1, cornerType);
    std::vector<std::vector<std::uint32_t>> cells(offsetCount == 0 ? 0 : offsetCount - 1);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i].resize(offsets[i + 1] - offsets[i]);
        for (std::uint32_t& corner : cells[i])
            corner = nextIndex(cornerType);
    }
    return cells;
}

void VtkParser::addPolygons() {
    for (std::vector<std::uint32_t>& cell : parseCells())
        if (cell.size() >= 3) m_soup.polygons.push_back(std::move(cell));
}

/// Each corner of a strip makes a triangle with the two before it; every second one is turned, else its front
/// would be its back.
void VtkParser::addStrips() {
    for (const std::vector<std::uint32_t>& strip : parseCells())
        for (std::size_t i = 2; i < strip.size(); ++i) {
            const bool turned = i % 2 == 1;
            m_soup.polygons.push_back(
                {strip[turned ? i - 1 : i - 2], strip[turned ? i - 2 : i - 1], strip[i]});
        }
}

void VtkParser::skipFields() {
    nextWord(); // its name
    for (std::size_t arrays = nextCount(); arrays > 0; --arrays) {
        std::string name = lowerCase(nextWord());
        if (name == "metadata") {
            skipMetadata();
            name = lowerCase(nextWord());
        }
        const std::size_t components = nextCount(), tuples = nextCount();
        const NumberType type = nextType();
        if (components != 0 && tuples > m_text.size() / components)
            fail("is cut off in field \"" + name.substr(0, 40) + "\"");
        skipNumbers(components * tuples, type);
    }
}

/// Ends at an empty line.
void VtkParser::skipMetadata() {
    nextLine();
    while (m_at < m_text.size() && !nextLine().empty()) {
    }
}

} // namespace

PolygonSoup parseVtkPolydata(const std::filesystem::path& file, const Bytes& content) {
    return VtkParser(file, content).parse();
}

} // namespace esm
