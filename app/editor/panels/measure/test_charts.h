#pragma once

#include "app/editor/workers/virtual_test.h"
#include "core/exchange/charts/drawing.h"
#include "widgets/plot/curve_chart.h"

namespace esm {

/// What a chart of one kind of test says.
struct TestChart {
    QString title; ///< "Force over depth"
    ChartAxis x, y;
    QString toolTip;
    QString empty; ///< before anything is measured
};
TestChart testChart(TestKind kind);

/// In the units of its kind's axes; of tests in time marked where 1/e of the way is left.
ChartCurve chartCurve(const QString& name, const MeasuredPress& press);

/// What was measured last of the kind that is chosen, and what it is compared with, as `esmc probe` draws
/// organs that it compares.
Drawing testDrawing(const VirtualTest& test);
/// The same as a table.
std::string testCsv(const VirtualTest& test);

} // namespace esm
