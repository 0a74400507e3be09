#pragma once

#include "core/dynamics/measure/measured_runs.h"

#include <QAbstractTableModel>

#include <array>

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
    bool isUnbeaten(int row) const { return at(row).isUnbeaten; }
    /// Why the tissue cannot move by a row's method and step; empty where it can.
    QString obstacle(int row) const { return at(row).obstacle; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        Row(const TradeoffRun& run, bool isUnbeaten);
        explicit Row(const LeftOutRun& run);

        std::array<QString, columns> texts;
        std::array<QVariant, columns> sortKeys;
        QString obstacle, toolTip;
        bool isUnbeaten = false;
    };

    const Row& at(int row) const { return m_rows[static_cast<std::size_t>(row)]; }

    std::vector<Row> m_rows;
    std::optional<std::size_t> m_inUse;
};

} // namespace esm
