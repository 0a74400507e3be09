#include "core/exchange/simulators/sofa/sofa_states.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"
#include "core/support/text_lines.h"

#include <cmath>

namespace esm {

namespace {

constexpr std::size_t mostBytesOfNumber = 32;
constexpr std::size_t mostBytesBesides = 256; ///< of a state, and once of the file

class SofaStateReader {
public:
    explicit SofaStateReader(std::size_t nodes) : m_nodes(nodes) {}

    std::vector<SofaState> read(const Bytes& content) {
        TextLines lines(content);
        for (std::string_view line; lines.next(line);) {
            m_line = lines.number();
            const std::string_view key = takeWord(line);
            if (key == "T=")
                m_time = nextNumber(line);
            else if (key == "X=")
                addState(line);
        }
        return std::move(m_states);
    }

private:
    void addState(std::string_view line) {
        if (!m_time) fail("has places without a time");
        SofaState state{*m_time, {}};
        while (!isAtEnd(line)) {
            Eigen::Vector3d place;
            for (double& coordinate : place)
                coordinate = nextNumber(line);
            state.positions.push_back(place);
        }
        if (state.positions.size() != m_nodes)
            fail("has " + std::to_string(state.positions.size()) + " nodes where " + std::to_string(m_nodes) +
                 " were handed over");
        m_states.push_back(std::move(state));
        m_time.reset();
    }

    static bool isAtEnd(std::string_view line) { return takeWord(line).empty(); }

    double nextNumber(std::string_view& line) const {
        const std::string_view word = takeWord(line);
        // C++ streams write "-nan" too.
        const bool isNone = word.ends_with("nan") || word.ends_with("inf");
        const auto number = isNone ? std::nullopt : wholeNumber<double>(word);
        if (isNone || (number && !std::isfinite(*number)))
            throw InvalidModel("is not finite" + (m_time ? " at " + roundedText(*m_time) + " s" : "") +
                               ": the motion blew up in SOFA; choose a shorter time step");
        if (!number) fail("has \"" + std::string(word.substr(0, mostBytesOfNumber)) + "\" for a number");
        return *number;
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw InvalidModel("in line " + std::to_string(m_line) + " " + problem +
                           "; SOFA's scene or its release may be another than was written");
    }

    std::size_t m_nodes, m_line = 0;
    std::optional<double> m_time; ///< s, whose places come next
    std::vector<SofaState> m_states;
};

/// A motion that was stopped or found no room ends within a line.
void dropUnfinishedLine(Bytes& content) {
    while (!content.empty() && content.back() != '\n')
        content.pop_back();
}

} // namespace

std::vector<SofaState> readSofaStates(const std::filesystem::path& file, std::size_t nodes, std::size_t most,
                                      const Progress& progress) {
    const std::size_t ofState = 3 * nodes * mostBytesOfNumber + mostBytesBesides;
    Bytes content = readFile(file, most * ofState + mostBytesBesides, progress);
    dropUnfinishedLine(content);
    return SofaStateReader(nodes).read(content);
}

} // namespace esm
