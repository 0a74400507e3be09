#include "core/exchange/charts/curve_drawing.h"

#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int curvesWidth = 800, curvesHeight = 500;
constexpr double curvesLeft = 80, curvesRight = 770, curvesTop = 30, curvesBottom = 440, textHeight = 18;
constexpr std::size_t mostDots = 50; ///< of a curve: more would be a thick line
constexpr double legendWidth = 160;
constexpr Drawing::Colour curvesGrid{225, 225, 225};
/// Told apart by people who see few colours as well (Okabe and Ito 2008).
constexpr std::array<Drawing::Colour, 4> curveColours{
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

double mostOf(const std::vector<DrawnCurve>& curves, double Drawing::Place::*value) {
    double most = 0;
    for (const DrawnCurve& curve : curves)
        for (const Drawing::Place& point : curve.points)
            most = std::max(most, point.*value);
    return most;
}

/// Of letters that every drawing can show, and no longer than there is room: names come of files.
std::string shownName(const std::string& name) {
    constexpr std::size_t most = 20;
    std::string shown;
    for (const char letter : name)
        if ((letter & 0xc0) != 0x80) // else a further byte of one letter
            shown += letter >= ' ' && letter <= '~' ? letter : '?';
    return shown.size() <= most ? shown : shown.substr(0, most - 3) + "...";
}

class CurveDrawing {
public:
    explicit CurveDrawing(const std::vector<DrawnCurve>& curves)
        : m_x(mostOf(curves, &Drawing::Place::x), curvesLeft, curvesRight),
          m_y(mostOf(curves, &Drawing::Place::y), curvesBottom, curvesTop) {}

    void drawAxes(const CurveAxes& axes) {
        for (int mark = 0; mark <= m_x.marks(); ++mark) {
            const double x = m_x(m_x.valueOf(mark));
            drawing.lines.push_back({{x, curvesTop}, {x, curvesBottom}, curvesGrid});
            drawing.labels.push_back(
                {{x, curvesBottom + textHeight}, roundedText(m_x.valueOf(mark), 3), Drawing::Anchor::Middle});
        }
        for (int mark = 0; mark <= m_y.marks(); ++mark) {
            const double y = m_y(m_y.valueOf(mark));
            drawing.lines.push_back({{curvesLeft, y}, {curvesRight, y}, curvesGrid});
            drawing.labels.push_back(
                {{curvesLeft - 6, y + 4}, roundedText(m_y.valueOf(mark), 3), Drawing::Anchor::End});
        }
        drawing.labels.push_back({{(curvesLeft + curvesRight) / 2, curvesBottom + 2.3 * textHeight},
                                  axes.x,
                                  Drawing::Anchor::Middle});
        drawing.labels.push_back({{curvesLeft - 60, curvesTop - 12}, axes.y});
    }

    void drawCurve(const DrawnCurve& curve, const Drawing::Colour& colour) {
        std::optional<Drawing::Place> last;
        for (const Drawing::Place& point : curve.points) {
            const Drawing::Place place{m_x(point.x), m_y(point.y)};
            if (last) drawing.lines.push_back({*last, place, colour, 2});
            if (curve.points.size() <= mostDots) drawing.dots.push_back({place, 3, colour});
            last = place;
        }
    }

    /// The next row of the names, and beneath it what its mark means: marks may lie close together. They
    /// stand at the left, which rising curves leave free, or at the right.
    void drawName(const DrawnCurve& curve, bool isAtRight, const Drawing::Colour& colour) {
        const double x = isAtRight ? curvesRight - legendWidth : curvesLeft + 20;
        drawing.dots.push_back({{x, nextRow() - 4}, 4, colour});
        drawing.labels.push_back({{x + 12, m_row}, shownName(curve.name)});
        if (curve.mark) drawing.labels.push_back({{x + 12, nextRow()}, curve.mark->text});
    }

    void drawMark(const DrawnMark& mark, const Drawing::Colour& colour) {
        const double x = m_x(mark.x);
        drawing.lines.push_back({{x, curvesTop}, {x, curvesBottom}, colour});
    }

    Drawing drawing{curvesWidth, curvesHeight, {}, {}, {}};

private:
    double nextRow() { return m_row += textHeight; }

    LinearAxis m_x, m_y;
    double m_row = curvesTop; ///< pixels, of the last text in the names
};

/// Whether a curve is higher in its first half than at its end.
bool falls(const DrawnCurve& curve) {
    const auto& points = curve.points;
    if (points.empty()) return false;
    const auto isLower = [](const Drawing::Place& a, const Drawing::Place& b) { return a.y < b.y; };
    const auto highest = std::max_element(points.begin(), points.end(), isLower);
    return highest->x < points.back().x / 2 && highest->y > points.back().y;
}

} // namespace

Drawing curveDrawing(const CurveAxes& axes, const std::vector<DrawnCurve>& curves) {
    CurveDrawing chart(curves);
    chart.drawAxes(axes);
    const bool isFalling = !curves.empty() && falls(curves.front());
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Drawing::Colour& colour = curveColours.at(i % curveColours.size());
        chart.drawCurve(curves[i], colour);
        if (curves[i].mark) chart.drawMark(*curves[i].mark, colour);
        chart.drawName(curves[i], isFalling, colour);
    }
    return chart.drawing;
}

} // namespace esm
