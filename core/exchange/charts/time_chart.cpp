#include "core/exchange/charts/time_chart.h"

#include "core/exchange/charts/curve_drawing.h"
#include "core/exchange/charts/table_text.h"
#include "core/probing/standing_finger.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

std::optional<DrawnMark> markAt(const std::optional<double>& time, const TimeCurve& curve) {
    if (!time) return std::nullopt;
    return DrawnMark{*time, "time constant " + roundedText(*curve.timeConstant, 3) + " s"};
}

} // namespace

Drawing relaxationChart(const std::vector<NamedTimeCurve>& tests) {
    std::vector<DrawnCurve> curves;
    for (const auto& [name, relaxation] : tests) {
        DrawnCurve curve{name, {}, markAt(fallenAt(relaxation), relaxation)};
        for (const TimedPress& point : standingFinger(relaxation).points)
            curve.points.push_back({point.time, point.force});
        curves.push_back(std::move(curve));
    }
    return curveDrawing({"time, s", "force, N"}, curves);
}

Drawing creepChart(const std::vector<NamedTimeCurve>& tests) {
    std::vector<DrawnCurve> curves;
    for (const auto& [name, creep] : tests) {
        DrawnCurve curve{name, {}, markAt(creep.timeConstant, creep)};
        for (const TimedPress& point : creep.points)
            curve.points.push_back({point.time, 1000 * point.depth});
        curves.push_back(std::move(curve));
    }
    return curveDrawing({"time, s", "depth, mm"}, curves);
}

std::string timeCsv(const std::vector<NamedTimeCurve>& tests) {
    std::string text = "name,time_s,depth_m,force_n\n";
    for (const auto& [name, test] : tests)
        for (const auto& [time, depth, force] : test.points)
            text +=
                quoted(name) + ',' + exactText(time) + ',' + exactText(depth) + ',' + exactText(force) + '\n';
    return text;
}

} // namespace esm
