#include "app/editor/dialogs/export_texts.h"

#include "app/editor/dialogs/sentence.h"
#include "widgets/inputs/number_text.h"

#include <QObject>

#include <cmath>

namespace esm {

namespace {

QString inMilliseconds(double seconds) {
    constexpr double millisecondsPerSecond = 1000;
    return QObject::tr("%1 ms").arg(numberText(millisecondsPerSecond * seconds));
}

} // namespace

QString searchText(double share, bool exports) {
    const QString text = exports ? QObject::tr("Looking for what will differ, and exporting then … %1 %")
                                 : QObject::tr("Looking for what will differ … %1 %");
    return text.arg(qRound(100 * share));
}

QString differencesText(const Differences& differences) {
    if (!differences.refusal.empty())
        return QObject::tr("It cannot be handed over. %1.")
            .arg(sentence(differences.refusal))
            .toHtmlEscaped();
    if (differences.list.empty())
        return differences.scheme.empty()
                   ? QObject::tr("Nothing is left out.")
                   : QObject::tr("Nothing is left out; steps alone make the motion differ a little.");
    QString text;
    for (const auto& [what, instead] : differences.list)
        text += QStringLiteral("<li>%1:<br/>%2.</li>")
                    .arg(sentence(what).toHtmlEscaped(), QString::fromStdString(instead).toHtmlEscaped());
    return QStringLiteral("<ul style='margin-left: 14px; -qt-list-indent: 0'>%1</ul>").arg(text);
}

QString stepsText(const Differences& differences) {
    if (differences.scheme.empty()) return {};
    const QString limit =
        std::isfinite(differences.largestStep)
            ? QObject::tr("Steps longer than %1 are not stable.").arg(inMilliseconds(differences.largestStep))
            : QObject::tr("Steps of any length are stable; shorter ones are nearer to the motion here.");
    return QObject::tr("%1 Stepped by %2.").arg(limit, QString::fromStdString(differences.scheme));
}

QString poorStepText(const Differences& differences) {
    if (!differences.hasPoorStep()) return {};
    if (!differences.blowsUp())
        return QObject::tr("The motion may be far from that here: %1.")
            .arg(QString::fromStdString(differences.caution));
    return QObject::tr(
               "The motion will blow up there: steps of %1 are too long. Steps of up to %2 are stable.")
        .arg(inMilliseconds(differences.timeStep), inMilliseconds(differences.largestStep));
}

} // namespace esm
