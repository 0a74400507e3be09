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

QString speedText(const TradeoffRun& run) {
    return run.stable ? QStringLiteral("%1×").arg(numberText(run.realTimeFactor(), 2)) : missing();
}
QString speedText(const LeftOutRun&) {
    return missing();
}

QString errorText(const TradeoffRun& run) {
    if (!run.stable) return RunsModel::tr("ran wild");
    return (run.isErrorBound ? QStringLiteral("≤ %1 %") : QStringLiteral("%1 %"))
        .arg(numberText(100 * run.error, 2));
}
QString errorText(const LeftOutRun&) {
    return RunsModel::tr("left out");
}

double speedKey(const TradeoffRun& run) {
    return run.stable ? run.realTimeFactor() : 0;
}
double speedKey(const LeftOutRun&) {
    return -1;
}

double errorKey(const TradeoffRun& run) {
    return run.stable ? run.error : std::numeric_limits<double>::max();
}
double errorKey(const LeftOutRun&) {
    return std::numeric_limits<double>::infinity();
}

template<class Run> QString cellText(const Run& run, int column) {
    switch (column) {
    case RunsModel::Method:
        return methodName(run.stepping);
    case RunsModel::Step:
        return durationText(run.stepping.timeStep);
    case RunsModel::Nodes:
        return countText(run.nodes);
    case RunsModel::Speed:
        return speedText(run);
    default:
        return errorText(run);
    }
}

/// The fastest and the most exact stand together; what ran wild, then what was left out, at the other end.
template<class Run> QVariant sortKey(const Run& run, int column) {
    switch (column) {
    case RunsModel::Method:
        return cellText(run, column);
    case RunsModel::Step:
        return run.stepping.timeStep;
    case RunsModel::Nodes:
        return static_cast<qulonglong>(run.nodes);
    case RunsModel::Speed:
        return speedKey(run);
    default:
        return errorKey(run);
    }
}

} // namespace

void RunsModel::setTradeoff(const Tradeoff* tradeoff) {
    beginResetModel();
    m_tradeoff = tradeoff ? std::optional(*tradeoff) : std::nullopt;
    m_unbeaten = tradeoff ? unbeatenRuns(*tradeoff) : std::vector<bool>();
    m_unbeaten.resize(static_cast<std::size_t>(rowCount()), false);
    endResetModel();
}

void RunsModel::setInUse(std::optional<std::size_t> run) {
    if (run == m_inUse) return;
    m_inUse = run;
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1), {Qt::FontRole});
}

int RunsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_tradeoff
               ? 0
               : static_cast<int>(m_tradeoff->runs.size() + m_tradeoff->leftOut.size());
}

const LeftOutRun* RunsModel::leftOut(int row) const {
    const auto place = static_cast<std::size_t>(row), measured = m_tradeoff->runs.size();
    return place < measured ? nullptr : &m_tradeoff->leftOut[place - measured];
}

QString RunsModel::obstacle(int row) const {
    if (const LeftOutRun* run = leftOut(row))
        return tr("Left out: %1").arg(QString::fromStdString(run->reason));
    const TradeoffRun& run = m_tradeoff->runs[static_cast<std::size_t>(row)];
    if (!run.stable) return tr("With this step the motion ran wild");
    return run.error < 1 ? QString() : tr("As far off as tissue that never moves: of no use");
}

int RunsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

QVariant RunsModel::toolTip(int row) const {
    const LeftOutRun* out = leftOut(row);
    const Stepping& stepping = out ? out->stepping : m_tradeoff->runs[static_cast<std::size_t>(row)].stepping;
    QString text = methodName(stepping) + '\n' + methodText(stepping.integrator);
    if (const QString why = obstacle(row); !why.isEmpty()) return text + '\n' + why;
    if (isUnbeaten(row)) text += '\n' + tr("No other is both as fast and as exact.");
    return text + '\n' + tr("Enter or a double click: use this method and step");
}

QVariant RunsModel::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    const LeftOutRun* out = leftOut(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return out ? cellText(*out, index.column()) : cellText(m_tradeoff->runs[row], index.column());
    case sortRole:
        return out ? sortKey(*out, index.column()) : sortKey(m_tradeoff->runs[row], index.column());
    case Qt::ToolTipRole:
        return toolTip(index.row());
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (index.column() == Method ? Qt::AlignLeft : Qt::AlignRight));
    case Qt::ForegroundRole:
        return isUnbeaten(index.row()) ? QVariant(QGuiApplication::palette().link()) : QVariant();
    case Qt::FontRole: {
        QFont font;
        font.setBold(m_inUse == row);
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
