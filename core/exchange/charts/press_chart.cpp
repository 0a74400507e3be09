#include "core/exchange/charts/press_chart.h"

#include "core/support/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

constexpr int pressWidth = 800, pressHeight = 500;
constexpr double pressLeft = 80, pressRight = 770, pressTop = 30, pressBottom = 440, textHeight = 18;
constexpr Drawing::Colour pressGrid{225, 225, 225};
/// Told apart by people who see few colours as well (Okabe and Ito 2008).
constexpr std::array<Drawing::Colour, 4> pressColours{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}}};

/// From 0 to a value, with some five marks at 1, 2 or 5 times a power of ten.
class LinearAxis {
public:
    LinearAxis(double most, double start, double end) : m_start(start), m_end(end) {
        const double rough = std::max(most, 1e-12) / 5;
        const double decade = std::pow(10, std::floor(std::log10(rough)));
        m_apart = rough > 5 * decade ? 10 * decade : rough > 2 * decade ? 5 * decade : 2 * decade;
        m_marks = static_cast<int>(std::ceil(std::max(most, 1e-12) / m_apart));
    }

    int marks() const { return m_marks; }
    double valueOf(int mark) const { return mark * m_apart; }
    /// In pixels.
    double operator()(double value) const {
        return m_start + (m_end - m_start) * value / (m_marks * m_apart);
    }

private:
    double m_start, m_end, m_apart;
    int m_marks;
};

double mostOf(const std::vector<NamedPress>& presses, double PressPoint::*value) {
    double most = 0;
    for (const NamedPress& press : presses)
        for (const PressPoint& point : press.curve)
            most = std::max(most, point.*value);
    return most;
}

void drawAxes(Drawing& drawing, const LinearAxis& depth, const LinearAxis& force) {
    for (int mark = 0; mark <= depth.marks(); ++mark) {
        const double x = depth(depth.valueOf(mark));
        drawing.lines.push_back({{x, pressTop}, {x, pressBottom}, pressGrid});
        drawing.labels.push_back(
            {{x, pressBottom + textHeight}, roundedText(depth.valueOf(mark), 3), Drawing::Anchor::Middle});
    }
    for (int mark = 0; mark <= force.marks(); ++mark) {
        const double y = force(force.valueOf(mark));
        drawing.lines.push_back({{pressLeft, y}, {pressRight, y}, pressGrid});
        drawing.labels.push_back(
            {{pressLeft - 6, y + 4}, roundedText(force.valueOf(mark), 3), Drawing::Anchor::End});
    }
    drawing.labels.push_back({{(pressLeft + pressRight) / 2, pressBottom + 2.3 * textHeight},
                              "depth, mm",
                              Drawing::Anchor::Middle});
    drawing.labels.push_back({{pressLeft - 60, pressTop - 12}, "force, N"});
}

} // namespace

Drawing pressChart(const std::vector<NamedPress>& presses) {
    Drawing drawing{pressWidth, pressHeight, {}, {}, {}};
    const LinearAxis depth(1000 * mostOf(presses, &PressPoint::depth), pressLeft, pressRight);
    const LinearAxis force(mostOf(presses, &PressPoint::force), pressBottom, pressTop);
    drawAxes(drawing, depth, force);
    for (std::size_t i = 0; i < presses.size(); ++i) {
        const Drawing::Colour& colour = pressColours.at(i % pressColours.size());
        std::optional<Drawing::Place> last;
        for (const PressPoint& point : presses[i].curve) {
            const Drawing::Place place{depth(1000 * point.depth), force(point.force)};
            if (last) drawing.lines.push_back({*last, place, colour, 2});
            drawing.dots.push_back({place, 3, colour});
            last = place;
        }
        const double y = pressTop + textHeight * (static_cast<double>(i) + 1);
        drawing.dots.push_back({{pressLeft + 20, y - 4}, 4, colour});
        drawing.labels.push_back({{pressLeft + 32, y}, presses[i].name});
    }
    return drawing;
}

namespace {

/// As tables have names that may hold commas, quotes or line breaks.
std::string quoted(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
    std::string text = "\"";
    for (const char c : name)
        text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + '"';
}

} // namespace

std::string pressCsv(const std::vector<NamedPress>& presses) {
    std::string text = "name,depth_m,force_n\n";
    for (const auto& [name, curve] : presses)
        for (const PressPoint& point : curve)
            text += quoted(name) + ',' + exactText(point.depth) + ',' + exactText(point.force) + '\n';
    return text;
}

} // namespace esm
