#include "core/decoders/obj_mesh.h"

#include "core/support/errors.h"
#include "core/support/text_lines.h"

#include <limits>

namespace esm {

namespace {

/// Points, places in a texture and faces are read: vertices keep the numbers that the file gives them, so
/// that what was welded stays so and what names no vertex can be told.
class ObjParser {
public:
    ObjParser(const std::filesystem::path& file, const Bytes& content) : m_file(file), m_lines(content) {}

    PolygonSoup parse() {
        for (std::string_view line; m_lines.next(line);) {
            std::string joined;
            std::string_view rest = withContinuation(line, joined);
            const std::string_view keyword = takeWord(rest);
            if (keyword == "v")
                addVertex(rest);
            else if (keyword == "vt")
                addPlace(rest);
            else if (keyword == "f")
                addFace(rest);
        }
        if (m_soup.vertices.empty())
            throw FileError(m_file, "has no vertex; it is no OBJ file or an empty one; choose another");
        checkIndices();
        placeCorners();
        return std::move(m_soup);
    }

private:
    [[noreturn]] void fail(std::size_t line, const std::string& problem) const {
        throw FileError(m_file, "has " + problem + " in line " + std::to_string(line) +
                                    "; the file may be cut off or damaged; export it again");
    }

    /// A line that ends in a backslash goes on in the next one.
    std::string_view withContinuation(std::string_view line, std::string& joined) {
        if (line.empty() || line.back() != '\\') return line;
        joined = line;
        while (!joined.empty() && joined.back() == '\\') {
            joined.back() = ' ';
            if (m_lines.next(line)) joined += line;
        }
        return joined;
    }

    void addVertex(std::string_view rest) {
        Eigen::Vector3d vertex;
        for (double& coordinate : vertex.reshaped()) {
            const auto number = wholeNumber<double>(takeWord(rest));
            if (!number) fail(m_lines.number(), "a vertex without three numbers");
            coordinate = *number;
        }
        m_soup.vertices.push_back(vertex);
    }

    /// Height and depth may be left out. What is no number is told where a corner names it, by having no
    /// place.
    void addPlace(std::string_view rest) {
        const auto u = wholeNumber<double>(takeWord(rest));
        const std::string_view height = takeWord(rest);
        const auto v = height.empty() ? 0 : wholeNumber<double>(height);
        m_places.emplace_back(u.value_or(unknown), v.value_or(unknown));
    }

    /// A corner is "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal"; a negative number
    /// counts back from the vertices read so far.
    std::uint32_t corner(std::string_view word) const {
        const auto number = wholeNumber<std::int64_t>(word.substr(0, word.find('/')));
        const auto known = static_cast<std::int64_t>(m_soup.vertices.size());
        const std::int64_t index = number.value_or(0) < 0 ? known + *number : number.value_or(0) - 1;
        if (index < 0 || index >= std::numeric_limits<std::uint32_t>::max())
            fail(m_lines.number(), "\"" + std::string(word.substr(0, 40)) + "\", which names no vertex,");
        return static_cast<std::uint32_t>(index);
    }

    /// What a corner says of its place, counted from 0; −1 where it says nothing or names none.
    std::int64_t placeOfCorner(std::string_view word) const {
        const std::size_t slash = word.find('/');
        if (slash == word.npos) return -1;
        word.remove_prefix(slash + 1);
        const auto number = wholeNumber<std::int64_t>(word.substr(0, word.find('/'))).value_or(0);
        return number < 0 ? static_cast<std::int64_t>(m_places.size()) + number : number - 1;
    }

    void addFace(std::string_view rest) {
        std::vector<std::uint32_t> polygon;
        std::vector<std::int64_t>& places = m_placesOfFace.emplace_back();
        for (std::string_view word = takeWord(rest); !word.empty() && word.front() != '#';
             word = takeWord(rest)) {
            polygon.push_back(corner(word));
            places.push_back(placeOfCorner(word));
        }
        if (polygon.size() < 3) fail(m_lines.number(), "a face of fewer than three corners");
        m_soup.polygons.push_back(std::move(polygon));
        m_lineOfFace.push_back(m_lines.number());
    }

    /// Faces may come before their vertices.
    void checkIndices() const {
        for (std::size_t i = 0; i < m_soup.polygons.size(); ++i)
            for (const std::uint32_t vertex : m_soup.polygons[i])
                if (vertex >= m_soup.vertices.size())
                    fail(m_lineOfFace[i], "a face that names vertex " +
                                              std::to_string(vertex + std::size_t{1}) + " of " +
                                              std::to_string(m_soup.vertices.size()));
    }

    /// A face has a place for each corner or none.
    void placeCorners() {
        if (m_places.empty()) return;
        for (const std::vector<std::int64_t>& ofFace : m_placesOfFace) {
            std::vector<Eigen::Vector2d>& places = m_soup.textureCoordinates.emplace_back();
            for (const std::int64_t place : ofFace)
                if (place >= 0 && place < static_cast<std::int64_t>(m_places.size()))
                    places.push_back(m_places[static_cast<std::size_t>(place)]);
            if (places.size() < ofFace.size()) places.clear();
        }
    }

    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    const std::filesystem::path& m_file;
    TextLines m_lines;
    PolygonSoup m_soup;
    std::vector<Eigen::Vector2d> m_places;
    std::vector<std::vector<std::int64_t>> m_placesOfFace;
    std::vector<std::size_t> m_lineOfFace;
};

} // namespace

PolygonSoup parseObj(const std::filesystem::path& file, const Bytes& content) {
    refuseBinary(file, content, "OBJ");
    return ObjParser(file, content).parse();
}

} // namespace esm
