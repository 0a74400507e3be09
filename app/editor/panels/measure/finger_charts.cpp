#include "app/editor/panels/measure/finger_charts.h"

#include "core/exchange/charts/press_chart.h"
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

std::vector<NamedTimeCurve> namedTimeCurves(const VirtualTest& test) {
    return named<NamedTimeCurve>(test, [](const MeasuredPress& press) { return *press.inTime(); });
}

} // namespace

FingerChart fingerChart(FingerTest kind) {
    switch (kind) {
    case FingerTest::Press:
        return {QObject::tr("Force over depth"), depthAxis(), forceAxis(),
                QObject::tr("What the finger bears at each depth; the arrow keys go from one to the next"),
                QObject::tr("Nothing is pressed yet. Click a place on the organ, then Press: here the force "
                            "on the finger rises with its depth.")};
    case FingerTest::Stay:
        return {QObject::tr("Force over time"), timeAxis(), forceAxis(),
                QObject::tr("What the finger bears from when it stands at its depth; the arrow keys go from "
                            "one moment to the next"),
                QObject::tr("Nothing is measured yet. Click a place on the organ, then Press and stay: here "
                            "the force on the finger falls in time.")};
    case FingerTest::Push:
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
    case FingerTest::Press:
        for (const PressPoint& point : press.result.curve)
            curve.points.push_back({1000 * point.depth, point.force});
        break;
    case FingerTest::Stay:
        for (const TimedPress& point : standingFinger(*press.inTime()).points)
            curve.points.push_back({point.time, point.force});
        curve.mark = markAt(fallenAt(*press.inTime()), *press.inTime());
        break;
    case FingerTest::Push:
        for (const TimedPress& point : press.inTime()->points)
            curve.points.push_back({point.time, 1000 * point.depth});
        curve.mark = markAt(press.inTime()->timeConstant, *press.inTime());
        break;
    }
    return curve;
}

Drawing fingerDrawing(const VirtualTest& test) {
    if (test.kind() == FingerTest::Press) return pressChart(namedPresses(test));
    return test.kind() == FingerTest::Stay ? relaxationChart(namedTimeCurves(test))
                                           : creepChart(namedTimeCurves(test));
}

std::string fingerCsv(const VirtualTest& test) {
    return test.kind() == FingerTest::Press ? pressCsv(namedPresses(test)) : timeCsv(namedTimeCurves(test));
}

} // namespace esm
