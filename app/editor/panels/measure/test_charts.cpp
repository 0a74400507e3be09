#include "app/editor/panels/measure/test_charts.h"

#include "core/exchange/charts/press_chart.h"
#include "core/exchange/charts/strip_chart.h"
#include "core/exchange/charts/time_chart.h"
#include "core/probing/standing_finger.h"
#include "widgets/inputs/number_text.h"

namespace esm {

namespace {

ChartAxis timeAxis() {
    return {QObject::tr("time"), QStringLiteral("s")};
}
ChartAxis forceAxis() {
    return {QObject::tr("force"), QStringLiteral("N")};
}
ChartAxis depthAxis() {
    return {QObject::tr("depth"), QStringLiteral("mm")};
}

std::optional<ChartMark> markAt(const std::optional<double>& time, const TimeCurve& curve) {
    if (!time) return std::nullopt;
    return ChartMark{
        *time, QObject::tr("time constant %1").arg(withUnit(*curve.timeConstant, QStringLiteral("s"), 3))};
}

/// Under the names that stand beside what is measured.
template<typename Named, typename Of> std::vector<Named> named(const VirtualTest& test, const Of& of) {
    std::vector<Named> all{{"now", of(*test.latest())}};
    if (test.former() && test.former() != test.latest()) all.push_back({"before", of(*test.former())});
    return all;
}

std::vector<NamedPress> namedPresses(const VirtualTest& test) {
    return named<NamedPress>(test, [](const MeasuredPress& press) { return press.result.curve; });
}

std::vector<NamedStrip> namedStrips(const VirtualTest& test) {
    return named<NamedStrip>(test, [](const MeasuredPress& press) { return press.strip->result.curve; });
}

std::vector<NamedTimeCurve> namedTimeCurves(const VirtualTest& test) {
    return named<NamedTimeCurve>(test, [](const MeasuredPress& press) { return *press.inTime(); });
}

} // namespace

TestChart testChart(TestKind kind) {
    switch (kind) {
    case TestKind::Press:
        return {QObject::tr("Force over depth"), depthAxis(), forceAxis(),
                QObject::tr("What the finger bears at each depth; the arrow keys go from one to the next"),
                QObject::tr("Nothing is pressed yet. Click a place on the organ, then Press: here the force "
                            "on the finger rises with its depth.")};
    case TestKind::Stay:
        return {QObject::tr("Force over time"), timeAxis(), forceAxis(),
                QObject::tr("What the finger bears from when it stands at its depth; the arrow keys go from "
                            "one moment to the next"),
                QObject::tr("Nothing is measured yet. Click a place on the organ, then Press and stay: here "
                            "the force on the finger falls in time.")};
    case TestKind::Strip:
        return {QObject::tr("Force over elongation"),
                {QObject::tr("elongation"), QStringLiteral("mm")},
                forceAxis(),
                QObject::tr("What each clamp pulls with as the strip gets longer; the arrow keys go from one "
                            "elongation to the next"),
                QObject::tr("Nothing is measured yet. Click a place on the organ, then Pull: here the force "
                            "rises as a strip of it is stretched.")};
    case TestKind::Push:
        break;
    }
    return {QObject::tr("Depth over time"), timeAxis(), depthAxis(),
            QObject::tr("How deep the finger has sunk in; the arrow keys go from one moment to the next"),
            QObject::tr("Nothing is measured yet. Click a place on the organ, then Push: here the finger "
                        "sinks in with time.")};
}

ChartCurve chartCurve(const QString& name, const MeasuredPress& press) {
    ChartCurve curve{name, {}};
    switch (press.kind) {
    case TestKind::Press:
        for (const PressPoint& point : press.result.curve)
            curve.points.push_back({1000 * point.depth, point.force});
        break;
    case TestKind::Stay:
        for (const TimedPress& point : standingFinger(*press.inTime()).points)
            curve.points.push_back({point.time, point.force});
        curve.mark = markAt(fallenAt(*press.inTime()), *press.inTime());
        break;
    case TestKind::Push:
        for (const TimedPress& point : press.inTime()->points)
            curve.points.push_back({point.time, 1000 * point.depth});
        curve.mark = markAt(press.inTime()->timeConstant, *press.inTime());
        break;
    case TestKind::Strip:
        for (const StripPoint& point : press.strip->result.curve)
            curve.points.push_back({1000 * point.elongation, point.force});
        break;
    }
    return curve;
}

Drawing testDrawing(const VirtualTest& test) {
    if (test.kind() == TestKind::Press) return pressChart(namedPresses(test));
    if (test.kind() == TestKind::Strip) return stripChart(namedStrips(test));
    return test.kind() == TestKind::Stay ? relaxationChart(namedTimeCurves(test))
                                         : creepChart(namedTimeCurves(test));
}

std::string testCsv(const VirtualTest& test) {
    if (test.kind() == TestKind::Strip) return stripCsv(namedStrips(test));
    return test.kind() == TestKind::Press ? pressCsv(namedPresses(test)) : timeCsv(namedTimeCurves(test));
}

} // namespace esm
