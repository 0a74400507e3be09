#include "core/decoders/mesh_file_checks.h"
#include "core/support/byte_order.h"
#include "core/support/errors.h"
#include "core/support/text_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace esm {

namespace fs = std::filesystem;

namespace {

struct PlyProperty {
    std::size_t bytes = 0;        ///< of a value, or of each entry of a list
    std::size_t countBytes = 0;   ///< of a list's length; 0 for a single value
    bool isOfFaceCorners = false; ///< texture coordinates, u and v of every corner in turn
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyForm { Text, LittleEndian, BigEndian };

struct PlyHeader {
    PlyForm form = PlyForm::Text;
    std::vector<PlyElement> elements;
    std::size_t bodyStart = 0;
};

std::size_t plyTypeBytes(std::string_view name) {
    struct Type {
        std::string_view name;
        std::size_t bytes;
    };
    constexpr std::array types{
        Type{"char", 1},  Type{"uchar", 1},  Type{"short", 2},   Type{"ushort", 2},
        Type{"int", 4},   Type{"uint", 4},   Type{"float", 4},   Type{"double", 8},
        Type{"int8", 1},  Type{"uint8", 1},  Type{"int16", 2},   Type{"uint16", 2},
        Type{"int32", 4}, Type{"uint32", 4}, Type{"float32", 4}, Type{"float64", 8},
    };
    for (const Type& type : types)
        if (type.name == name) return type.bytes;
    return 0;
}

/// @param bytes of each, 4 or 8
std::vector<double> realNumbers(const std::uint8_t* from, std::size_t count, std::size_t bytes,
                                ByteOrder order) {
    std::vector<double> numbers;
    numbers.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t bits = unsignedNumber(from + i * bytes, bytes, order);
        numbers.push_back(bytes == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                     : std::bit_cast<double>(bits));
    }
    return numbers;
}

/// The header announces how much follows; a file that is cut off holds less and must not pass for a small
/// one. So the file is walked through as announced, without keeping anything: a text must have a whole line
/// for each element, a binary one the bytes.
class PlyChecker {
public:
    PlyChecker(const fs::path& file, const Bytes& content) : m_file(file), m_content(content) {}

    std::optional<std::size_t> check() {
        readHeader();
        if (m_header.form == PlyForm::Text)
            checkText();
        else
            checkBinary();
        for (const PlyElement& element : m_header.elements)
            if (element.name == "face") return element.count;
        for (const PlyElement& element : m_header.elements)
            if (element.name == "tristrips") return std::nullopt;
        return 0;
    }

    /// Of every face, as far as it has a list of them. Precondition: checked.
    FaceCoordinates faceCoordinates() && { return std::move(m_faceCoordinates); }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw FileError(m_file, problem + "; export it again");
    }

    void readHeader();
    void readFormat(std::string_view name);
    void readProperty(std::string_view rest, const std::string& place);
    void readElement(std::string_view rest, const std::string& place);
    void endHeader(std::string_view lastLine);
    void checkText();
    void checkBinary();
    void keepFaceCoordinates(const std::vector<double>& numbers);

    const fs::path& m_file;
    const Bytes& m_content;
    PlyHeader m_header;
    FaceCoordinates m_faceCoordinates;
};

void PlyChecker::readFormat(std::string_view name) {
    if (name == "ascii")
        m_header.form = PlyForm::Text;
    else if (name == "binary_little_endian")
        m_header.form = PlyForm::LittleEndian;
    else if (name == "binary_big_endian")
        m_header.form = PlyForm::BigEndian;
    else
        fail("is a PLY file of the unknown format \"" + std::string(name.substr(0, 40)) + "\"");
}

void PlyChecker::readProperty(std::string_view rest, const std::string& place) {
    PlyProperty property;
    std::string_view type = takeWord(rest);
    if (type == "list") {
        property.countBytes = plyTypeBytes(takeWord(rest));
        if (property.countBytes == 0) fail("has a list of an unknown type" + place);
        type = takeWord(rest);
    }
    property.bytes = plyTypeBytes(type);
    if (property.bytes == 0 || m_header.elements.empty()) fail("has a property of an unknown type" + place);
    const bool isReal = type == "float" || type == "float32" || type == "double" || type == "float64";
    property.isOfFaceCorners = property.countBytes > 0 && isReal && takeWord(rest) == "texcoord" &&
                               m_header.elements.back().name == "face";
    m_header.elements.back().properties.push_back(property);
}

void PlyChecker::readElement(std::string_view rest, const std::string& place) {
    const std::string name(takeWord(rest));
    const auto count = wholeNumber<std::uint64_t>(takeWord(rest));
    if (!count) fail("has an element without a count" + place);
    m_header.elements.push_back({name, *count, {}});
}

void PlyChecker::endHeader(std::string_view lastLine) {
    const char* const begin = reinterpret_cast<const char*>(m_content.data());
    std::size_t end = static_cast<std::size_t>(lastLine.data() - begin) + lastLine.size();
    if (end < m_content.size() && m_content[end] == '\r') ++end;
    m_header.bodyStart = std::min(m_content.size(), end + 1);
    const bool hasVertices =
        std::any_of(m_header.elements.begin(), m_header.elements.end(),
                    [](const PlyElement& element) { return element.name == "vertex" && element.count > 0; });
    if (!hasVertices) fail("announces no vertices in its header");
}

void PlyChecker::readHeader() {
    TextLines lines(m_content);
    for (std::string_view line; lines.next(line);) {
        const std::string place = " in line " + std::to_string(lines.number());
        std::string_view rest = line;
        const std::string_view keyword = takeWord(rest);
        if (lines.number() == 1 && keyword != "ply")
            fail("does not begin with \"ply\", so it is no PLY file");
        if (keyword == "end_header") return endHeader(line);
        if (keyword == "format") readFormat(takeWord(rest));
        if (keyword == "property") readProperty(rest, place);
        if (keyword == "element") readElement(rest, place);
    }
    fail("is cut off: its header has no \"end_header\"");
}

void PlyChecker::keepFaceCoordinates(const std::vector<double>& numbers) {
    std::vector<Eigen::Vector2d>& corners = m_faceCoordinates.emplace_back();
    for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        corners.emplace_back(numbers[i], numbers[i + 1]);
}

void PlyChecker::checkText() {
    const Bytes body(m_content.begin() + static_cast<std::ptrdiff_t>(m_header.bodyStart), m_content.end());
    TextLines lines(body);
    for (const PlyElement& element : m_header.elements)
        for (std::uint64_t i = 0; i < element.count; ++i) {
            std::string_view line;
            bool there = false;
            while (!there && lines.next(line))
                there = line.find_first_not_of(" \t") != line.npos;
            for (const PlyProperty& property : element.properties) {
                const auto number = wholeNumber<double>(takeWord(line));
                there = there && number;
                if (!there || property.countBytes == 0) continue;
                std::vector<double> kept;
                for (double left = *number; there && left > 0; --left) {
                    const std::string_view word = takeWord(line);
                    there = !word.empty();
                    if (property.isOfFaceCorners)
                        kept.push_back(wholeNumber<double>(word).value_or(std::nan("")));
                }
                if (property.isOfFaceCorners) keepFaceCoordinates(kept);
            }
            if (!there)
                fail("is cut off or damaged: it announces " + std::to_string(element.count) + " of \"" +
                     element.name + "\", but number " + std::to_string(i) + " is not whole");
        }
}

/// Lists have their lengths within the data, so that sizes cannot be told from the header: each is read on
/// the way. An element without properties takes no bytes and is not walked, however many are announced.
void PlyChecker::checkBinary() {
    const ByteOrder order = m_header.form == PlyForm::BigEndian ? ByteOrder::Big : ByteOrder::Little;
    std::size_t at = m_header.bodyStart;
    const auto need = [&](std::uint64_t items, std::uint64_t bytes, const PlyElement& element) {
        if (items > (m_content.size() - at) / bytes)
            fail("is cut off: it announces " + std::to_string(element.count) + " of \"" + element.name +
                 "\", but ends within them at byte " + std::to_string(m_content.size()));
    };
    for (const PlyElement& element : m_header.elements) {
        if (element.properties.empty()) continue;
        need(element.count, 1, element);
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) {
                std::uint64_t items = 1;
                if (property.countBytes > 0) {
                    need(1, property.countBytes, element);
                    items = unsignedNumber(&m_content[at], property.countBytes, order);
                    at += property.countBytes;
                }
                need(items, property.bytes, element);
                if (property.isOfFaceCorners)
                    keepFaceCoordinates(realNumbers(&m_content[at], items, property.bytes, order));
                at += items * property.bytes;
            }
    }
}

} // namespace

std::optional<std::size_t> checkPly(const fs::path& file, const Bytes& content) {
    return PlyChecker(file, content).check();
}

FaceCoordinates plyFaceCoordinates(const fs::path& file, const Bytes& content) {
    PlyChecker checker(file, content);
    checker.check();
    return std::move(checker).faceCoordinates();
}

} // namespace esm
