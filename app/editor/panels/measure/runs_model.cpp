#include "app/editor/panels/measure/runs_model.h"

#include "app/editor/panels/measure/stepping_text.h"
#include "widgets/inputs/number_text.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>

#include <limits>

namespace esm {

namespace {

QString missing() {
    return QString(QChar(0x2013));
}

QString errorText(const TradeoffRun& run) {
    if (!run.stable) return RunsModel::tr("ran wild");
    return (run.isErrorBound ? QStringLiteral("≤ %1 %") : QStringLiteral("%1 %"))
        .arg(numberText(100 * run.error, 2));
}

QString obstacleOf(const TradeoffRun& run) {
    if (!run.stable) return RunsModel::tr("With this step the motion ran wild");
    return run.isOfUse() ? QString() : RunsModel::tr("As far off as tissue that never moves: of no use");
}

QString explained(const Stepping& stepping, const QString& what) {
    return methodName(stepping) + '\n' + methodText(stepping.integrator) + '\n' + what;
}

} // namespace

// The fastest and the most exact stand together; what ran wild, then what was left out, at the other end.

RunsModel::Row::Row(const TradeoffRun& run, bool isUnbeaten)
    : texts{methodName(run.stepping), durationText(run.stepping.timeStep), countText(run.nodes),
            run.stable ? QStringLiteral("%1×").arg(numberText(run.realTimeFactor(), 2)) : missing(),
            errorText(run)},
      sortKeys{texts[Method], run.stepping.timeStep, qulonglong(run.nodes),
               run.stable ? run.realTimeFactor() : 0.0,
               run.stable ? run.error : std::numeric_limits<double>::max()},
      obstacle(obstacleOf(run)), isUnbeaten(isUnbeaten) {
    const QString use = tr("Enter or a double click: use this method and step");
    toolTip = explained(run.stepping, !obstacle.isEmpty() ? obstacle
                                      : isUnbeaten ? tr("No other is both as fast and as exact.") + '\n' + use
                                                   : use);
}

RunsModel::Row::Row(const LeftOutRun& run)
    : texts{methodName(run.stepping), durationText(run.stepping.timeStep), countText(run.nodes), missing(),
            tr("left out")},
      sortKeys{texts[Method], run.stepping.timeStep, qulonglong(run.nodes), -1.0,
               std::numeric_limits<double>::infinity()},
      obstacle(tr("Left out: %1").arg(QString::fromStdString(run.reason))),
      toolTip(explained(run.stepping, obstacle)) {}

void RunsModel::setTradeoff(const Tradeoff* tradeoff) {
    beginResetModel();
    m_rows.clear();
    if (tradeoff) {
        m_rows.reserve(tradeoff->runs.size() + tradeoff->leftOut.size());
        const std::vector<bool> unbeaten = unbeatenRuns(*tradeoff);
        for (std::size_t i = 0; i < tradeoff->runs.size(); ++i)
            m_rows.emplace_back(tradeoff->runs[i], unbeaten[i]);
        for (const LeftOutRun& run : tradeoff->leftOut)
            m_rows.emplace_back(run);
    }
    endResetModel();
}

void RunsModel::setInUse(std::optional<std::size_t> run) {
    if (run == m_inUse) return;
    m_inUse = run;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1), {Qt::FontRole});
}

int RunsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int RunsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

QVariant RunsModel::data(const QModelIndex& index, int role) const {
    const Row& row = at(index.row());
    const auto column = static_cast<std::size_t>(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return row.texts[column];
    case sortRole:
        return row.sortKeys[column];
    case Qt::ToolTipRole:
        return row.toolTip;
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (column == Method ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::ForegroundRole:
        return row.isUnbeaten ? QVariant(QGuiApplication::palette().link()) : QVariant();
    case Qt::FontRole: {
        QFont font;
        font.setBold(m_inUse == static_cast<std::size_t>(index.row()));
        return font;
    }
    default:
        return {};
    }
}

QVariant RunsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) return {};
    const QStringList names{tr("method"), tr("step"), tr("nodes"), tr("speed"), tr("error")};
    const QStringList tips{tr("How the motion is computed"), tr("Length of a step, in ms or µs"),
                           tr("Nodes that were simulated"), tr("Times real time, on this machine"),
                           tr("How far the motion was off, in % of the motion")};
    if (role == Qt::DisplayRole) return names.value(section);
    if (role == Qt::ToolTipRole) return tr("%1. A click sorts by it").arg(tips.value(section));
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (section == Method ? Qt::AlignLeft : Qt::AlignRight));
    return {};
}

} // namespace esm
