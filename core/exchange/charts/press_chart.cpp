#include "core/exchange/charts/press_chart.h"

#include "core/exchange/charts/curve_drawing.h"
#include "core/exchange/charts/table_text.h"
#include "core/support/numbers.h"

namespace esm {

Drawing pressChart(const std::vector<NamedPress>& presses) {
    std::vector<DrawnCurve> curves;
    for (const NamedPress& press : presses) {
        DrawnCurve curve{press.name, {}, {}};
        for (const PressPoint& point : press.curve)
            curve.points.push_back({1000 * point.depth, point.force});
        curves.push_back(std::move(curve));
    }
    return curveDrawing({"depth, mm", "force, N"}, curves);
}

std::string pressCsv(const std::vector<NamedPress>& presses) {
    std::string text = "name,depth_m,force_n\n";
    for (const auto& [name, curve] : presses)
        for (const PressPoint& point : curve)
            text += quoted(name) + ',' + exactText(point.depth) + ',' + exactText(point.force) + '\n';
    return text;
}

} // namespace esm
