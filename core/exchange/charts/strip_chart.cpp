#include "core/exchange/charts/strip_chart.h"

#include "core/exchange/charts/curve_drawing.h"
#include "core/exchange/charts/table_text.h"
#include "core/support/numbers.h"

namespace esm {

Drawing stripChart(const std::vector<NamedStrip>& strips) {
    std::vector<DrawnCurve> curves;
    for (const NamedStrip& strip : strips) {
        DrawnCurve curve{strip.name, {}, {}};
        for (const StripPoint& point : strip.curve)
            curve.points.push_back({1000 * point.elongation, point.force});
        curves.push_back(std::move(curve));
    }
    return curveDrawing({"elongation, mm", "force, N"}, curves);
}

std::string stripCsv(const std::vector<NamedStrip>& strips) {
    std::string text = "name,elongation_m,strain,force_n\n";
    for (const auto& [name, curve] : strips)
        for (const StripPoint& point : curve)
            text += quoted(name) + ',' + exactText(point.elongation) + ',' + exactText(point.strain) + ',' +
                    exactText(point.force) + '\n';
    return text;
}

} // namespace esm
