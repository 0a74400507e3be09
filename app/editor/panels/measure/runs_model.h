#pragma once

#include "core/dynamics/measure/measured_runs.h"

#include <QAbstractTableModel>

namespace esm {

/// The runs of a measurement as rows, in the measurement's order, and after them what was left out: method,
/// step, nodes, times real time, error.
class RunsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Method, Step, Nodes, Speed, Error };
    static constexpr int columns = Error + 1;
    static constexpr int sortRole = Qt::UserRole; ///< what a column is sorted by

    using QAbstractTableModel::QAbstractTableModel;

    void setTradeoff(const Tradeoff* tradeoff); ///< null: no row
    /// The one in use stands out.
    void setInUse(std::optional<std::size_t> run);
    bool isUnbeaten(int row) const { return m_unbeaten[static_cast<std::size_t>(row)]; }
    /// Why the tissue cannot move by a row's method and step; empty where it can.
    QString obstacle(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QVariant toolTip(int row) const;
    const LeftOutRun* leftOut(int row) const; ///< null: a run that was measured

    std::optional<Tradeoff> m_tradeoff;
    std::vector<bool> m_unbeaten; ///< of each row
    std::optional<std::size_t> m_inUse;
};

} // namespace esm
