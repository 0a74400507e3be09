#include "app/editor/panels/measure/test_figures.h"

#include "core/probing/standing_finger.h"

namespace esm {

namespace {

using Value = std::optional<double>;

PressFigure figure(const QString& caption, const char* name, const QString& explained,
                   Value (*value)(const MeasuredPress&)) {
    return {caption, QString::fromLatin1(name), explained, value};
}

QString tissueTimeCaption() {
    return QObject::tr("Relaxation time of the tissue, s");
}

Value tissueTime(const MeasuredPress& press) {
    return press.tissueTime;
}

Value timeConstant(const MeasuredPress& press) {
    return press.inTime()->timeConstant;
}

std::vector<PressFigure> figuresOfPress() {
    return {
        figure(QObject::tr("Depth, mm"), "pressDepth",
               QObject::tr("How deep the finger came, from first touch"),
               [](const MeasuredPress& press) -> Value { return 1000 * press.result.curve.back().depth; }),
        figure(QObject::tr("Force, N"), "pressForce",
               QObject::tr("With which the organ resists at that depth"),
               [](const MeasuredPress& press) -> Value { return press.result.curve.back().force; }),
        figure(QObject::tr("Stiffness at the start, N/mm"), "stiffnessAtStart",
               QObject::tr("How steeply the force rises at the start"),
               [](const MeasuredPress& press) -> Value { return press.result.stiffnessAtStart / 1000; }),
        figure(QObject::tr("Stiffness at the end, N/mm"), "stiffnessAtEnd",
               QObject::tr("How steeply the force rises at the full depth"),
               [](const MeasuredPress& press) -> Value { return press.result.stiffness / 1000; }),
        figure(QObject::tr("Modulus of an even solid, kPa"), "equivalentModulus",
               QObject::tr("Young's modulus of one that is wide and deep beside the finger and would resist "
                           "as much. Of a hollow organ it says how firm it feels, not how firm its wall is"),
               [](const MeasuredPress& press) -> Value { return press.result.youngsModulus / 1000; })};
}

std::vector<PressFigure> figuresOfStay() {
    return {figure(QObject::tr("Depth, mm"), "stayDepth",
                   QObject::tr("How deep the finger stays, from first touch"),
                   [](const MeasuredPress& press) -> Value { return 1000 * press.inTime()->end.depth; }),
            figure(QObject::tr("Largest force, N"), "stayLargestForce",
                   QObject::tr("Once the finger stands; what the tissue bears while it moves is left out"),
                   [](const MeasuredPress& press) -> Value {
                       return standingFinger(*press.inTime()).largest.force;
                   }),
            figure(QObject::tr("Force at rest, N"), "stayRestForce",
                   QObject::tr("With which the organ resists however long the finger stays"),
                   [](const MeasuredPress& press) -> Value { return press.inTime()->end.force; }),
            figure(QObject::tr("Time constant, s"), "stayTimeConstant",
                   QObject::tr(
                       "From the largest force on, until a third (1/e) of the way down to the force at rest "
                       "is left"),
                   timeConstant),
            figure(tissueTimeCaption(), "stayTissueTime",
                   QObject::tr(
                       "Viscosity over spring constant at the place, as the workspace Tissue says it. One "
                       "stretched spring that stays so is at rest at once: what falls here is how the "
                       "tissue around the finger finds its place, which takes a time of its own"),
                   tissueTime)};
}

std::vector<PressFigure> figuresOfPush() {
    return {figure(QObject::tr("Force, N"), "pushForce", QObject::tr("With which the finger is pushed"),
                   [](const MeasuredPress& press) -> Value { return press.inTime()->end.force; }),
            figure(QObject::tr("Depth at the end, mm"), "pushDepth",
                   QObject::tr("How deep the finger was when the time was over"),
                   [](const MeasuredPress& press) -> Value {
                       return 1000 * press.inTime()->points.back().depth;
                   }),
            figure(QObject::tr("Depth at rest, mm"), "pushRestDepth",
                   QObject::tr("How deep the finger sinks however long it is pushed"),
                   [](const MeasuredPress& press) -> Value { return 1000 * press.inTime()->end.depth; }),
            figure(QObject::tr("Time constant, s"), "pushTimeConstant",
                   QObject::tr("Until a third (1/e) of the way to the depth at rest is left"), timeConstant),
            figure(tissueTimeCaption(), "pushTissueTime",
                   QObject::tr(
                       "Viscosity over spring constant at the place, as the workspace Tissue says it: how "
                       "long stretched tissue takes. A dent takes longer, as it also moves the organ in its "
                       "tethers; several times as long in a hollow organ, whose wall it bends and hardly "
                       "stretches"),
                   tissueTime)};
}

Value inThousands(const Value& value) {
    return value ? Value(*value / 1000) : std::nullopt;
}

std::vector<PressFigure> figuresOfStrip() {
    return {
        figure(QObject::tr("Elongation, mm"), "stripElongation",
               QObject::tr("By which the clamps are further apart at the end"),
               [](const MeasuredPress& test) -> Value {
                   return 1000 * test.strip->result.curve.back().elongation;
               }),
        figure(
            QObject::tr("Strain in the middle, %"), "stripStrain",
            QObject::tr("By which the tissue in the middle is longer, which the clamps do not disturb. Less "
                        "than what was asked where the strip was bent and is first straightened"),
            [](const MeasuredPress& test) -> Value { return 100 * test.strip->result.curve.back().strain; }),
        figure(QObject::tr("Force, N"), "stripForce", QObject::tr("With which each clamp pulls at the end"),
               [](const MeasuredPress& test) -> Value { return test.strip->result.curve.back().force; }),
        figure(QObject::tr("Stiffness at the end, N/mm"), "stripStiffness",
               QObject::tr("How steeply the force rises at the end"),
               [](const MeasuredPress& test) -> Value { return test.strip->result.stiffness / 1000; }),
        figure(QObject::tr("Stiffness of the wall, N/m"), "membraneStiffness",
               QObject::tr("Of a hollow organ: Young's modulus times thickness, by the last step"),
               [](const MeasuredPress& test) { return test.strip->result.membraneStiffness; }),
        figure(
            QObject::tr("Young's modulus, kPa"), "stripModulus",
            QObject::tr("Of the tissue that was cut out, by the last step; of a hollow organ with the wall "
                        "thickness that the workspace Tissue states"),
            [](const MeasuredPress& test) { return inThousands(test.strip->result.youngsModulus); })};
}

} // namespace

std::vector<PressFigure> testFigures(TestKind kind) {
    switch (kind) {
    case TestKind::Press:
        return figuresOfPress();
    case TestKind::Stay:
        return figuresOfStay();
    case TestKind::Push:
        return figuresOfPush();
    case TestKind::Strip:
        break;
    }
    return figuresOfStrip();
}

} // namespace esm
