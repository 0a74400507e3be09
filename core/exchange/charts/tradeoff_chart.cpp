#include "core/exchange/charts/tradeoff_chart.h"

#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Place = Drawing::Place;

constexpr int pictureWidth = 1000, pictureHeight = 600; ///< room for the longest name at the right
constexpr double left = 80, right = 740, top = 30, bottom = 540;
constexpr double legendText = right + 38;
constexpr double dotRadius = 4, coarserRadius = 2.5, lineHeight = 18;
constexpr Drawing::Colour gridColour{225, 225, 225}, frontColour{60, 60, 60};

/// One of the two wishes: the line that it asks for, and the ring around what is recommended for it. Both
/// rings may lie around one run.
struct WishStyle {
    Drawing::Colour colour;
    double ringRadius;
};
constexpr WishStyle realTimeStyle{{200, 60, 60}, 8}, errorStyle{{0, 100, 170}, 11};

Drawing::Colour colourOf(Integrator integrator) {
    const auto& [red, green, blue] = traitsOf(integrator).colour;
    return {red, green, blue};
}

constexpr double mostDecades = 20; ///< to either side of 1
constexpr int mostLabels = 10;     ///< of an axis

/// Whole decades from the lowest value to the highest. What is beyond all measure lies at the edge.
class LogAxis {
public:
    LogAxis(double start, double end) : m_start(start), m_end(end) {}

    void include(double value) {
        m_low = std::min(m_low, static_cast<int>(std::floor(exponentOf(value))));
        m_high = std::max(m_high, static_cast<int>(std::ceil(exponentOf(value))));
    }

    int low() const { return m_low; }
    int high() const { return std::max(m_high, m_low + 1); }
    /// From one label to the next, so that none runs into another.
    int decadesApart() const { return 1 + (high() - low()) / mostLabels; }

    /// In pixels.
    double operator()(double value) const {
        return m_start + (m_end - m_start) * (exponentOf(value) - low()) / (high() - low());
    }

private:
    static double exponentOf(double value) {
        return std::clamp(std::log10(value), -mostDecades, mostDecades);
    }

    double m_start, m_end;
    int m_low = 300, m_high = -300;
};

class Chart {
public:
    Chart(const Tradeoff& tradeoff, const TradeoffWishes& wishes) : m_tradeoff(tradeoff), m_wishes(wishes) {
        include(wishes.realTimeFactor, wishes.mostError);
        for (const TradeoffRun& run : tradeoff.runs)
            if (isShown(run)) include(run.realTimeFactor(), run.error);
    }

    Drawing draw() {
        drawGrid();
        drawWishes();
        drawFront();
        drawRuns();
        drawLegend();
        return std::move(m_drawing);
    }

private:
    /// What has no place on a logarithmic axis is left out.
    static bool isShown(const TradeoffRun& run) {
        const double cost = run.wallPerSimulatedSecond;
        return run.stable && run.error > 0 && std::isfinite(run.error) && cost > 0 && std::isfinite(cost);
    }

    void include(double speed, double error) {
        m_speed.include(speed);
        m_error.include(100 * error);
    }

    Place placeOf(const TradeoffRun& run) const {
        return {m_speed(run.realTimeFactor()), m_error(100 * run.error)};
    }

    void drawGrid() {
        for (int decade = m_speed.low(); decade <= m_speed.high(); decade += m_speed.decadesApart()) {
            const double x = m_speed(std::pow(10, decade));
            m_drawing.lines.push_back({{x, top}, {x, bottom}, gridColour});
            m_drawing.labels.push_back({{x, bottom + lineHeight}, nameOf(decade), Drawing::Anchor::Middle});
        }
        for (int decade = m_error.low(); decade <= m_error.high(); decade += m_error.decadesApart()) {
            const double y = m_error(std::pow(10, decade));
            m_drawing.lines.push_back({{left, y}, {right, y}, gridColour});
            m_drawing.labels.push_back({{left - 6, y + 4}, nameOf(decade), Drawing::Anchor::End});
        }
        m_drawing.labels.push_back({{(left + right) / 2, bottom + 2.3 * lineHeight},
                                    "speed, times real time",
                                    Drawing::Anchor::Middle});
        m_drawing.labels.push_back({{left - 60, top - 12}, "error, % of the motion"});
    }

    /// A power of ten, in full where it is short.
    static std::string nameOf(int decade) {
        return decade >= -4 && decade <= 5 ? roundedText(std::pow(10, decade))
                                           : "1e" + std::to_string(decade);
    }

    void drawWishes() {
        const double x = m_speed(m_wishes.realTimeFactor), y = m_error(100 * m_wishes.mostError);
        m_drawing.lines.push_back({{x, top}, {x, bottom}, realTimeStyle.colour});
        m_drawing.lines.push_back({{left, y}, {right, y}, errorStyle.colour});
    }

    void drawFront() {
        const TradeoffRun* last = nullptr;
        for (const std::size_t i : m_tradeoff.pareto) {
            const TradeoffRun& run = m_tradeoff.runs[i];
            if (!isShown(run)) continue;
            if (last) m_drawing.lines.push_back({placeOf(*last), placeOf(run), frontColour, 2});
            last = &run;
        }
    }

    void drawRuns() {
        for (const TradeoffRun& run : m_tradeoff.runs)
            if (isShown(run))
                m_drawing.dots.push_back({placeOf(run), run.coarser ? coarserRadius : dotRadius,
                                          colourOf(run.stepping.integrator),
                                          run.stepping.precision == Precision::Double});
        drawRing(m_tradeoff.bestInRealTime, realTimeStyle);
        drawRing(m_tradeoff.fastestToError, errorStyle);
    }

    void drawRing(const std::optional<std::size_t>& recommended, const WishStyle& style) {
        if (recommended && isShown(m_tradeoff.runs[*recommended]))
            m_drawing.dots.push_back(
                {placeOf(m_tradeoff.runs[*recommended]), style.ringRadius, style.colour, false});
    }

    template<class Condition> bool isAnyRun(const Condition& condition) const {
        return std::any_of(m_tradeoff.runs.begin(), m_tradeoff.runs.end(), condition);
    }

    static std::string speedText(double realTimeFactor) {
        return realTimeFactor == 1 ? "real time" : roundedText(realTimeFactor) + " times real time";
    }

    void drawLegend() {
        double y = top + lineHeight;
        const auto explain = [&](const Drawing::Dot& dot, const std::string& text) {
            m_drawing.dots.push_back({{right + 20, y - 4}, dot.radius, dot.colour, dot.filled});
            m_drawing.labels.push_back({{legendText, y}, text});
            y += lineHeight;
        };
        for (const Integrator integrator : allIntegrators)
            if (isAnyRun([&](const TradeoffRun& run) { return run.stepping.integrator == integrator; }))
                explain({{}, dotRadius, colourOf(integrator)}, traitsOf(integrator).title);
        explain({{}, dotRadius, frontColour, false}, "single precision");
        if (isAnyRun([](const TradeoffRun& run) { return run.coarser.has_value(); }))
            explain({{}, coarserRadius, frontColour}, "on fewer nodes");
        y += lineHeight / 2;
        explain({{}, realTimeStyle.ringRadius, realTimeStyle.colour, false}, "least error in");
        m_drawing.labels.push_back({{legendText, y}, speedText(m_wishes.realTimeFactor)});
        y += 1.5 * lineHeight;
        explain({{}, errorStyle.ringRadius, errorStyle.colour, false}, "fastest within");
        m_drawing.labels.push_back({{legendText, y}, roundedText(100 * m_wishes.mostError) + " % error"});
    }

    const Tradeoff& m_tradeoff;
    const TradeoffWishes& m_wishes;
    LogAxis m_speed{left, right}, m_error{bottom, top};
    Drawing m_drawing{pictureWidth, pictureHeight, {}, {}, {}};
};

} // namespace

Drawing tradeoffChart(const Tradeoff& tradeoff, const TradeoffWishes& wishes) {
    return Chart(tradeoff, wishes).draw();
}

} // namespace esm
