#pragma once

#include "app/editor/panels/measure/runs_model.h"

#include <QSortFilterProxyModel>
#include <QTableView>

namespace esm {

/// The runs of a measurement, to be sorted by any column, and marked and chosen as in the chart beside it.
class RunsTable : public QTableView {
    Q_OBJECT

public:
    explicit RunsTable(QWidget* parent = nullptr);

    void setTradeoff(const Tradeoff* tradeoff);
    void setInUse(std::optional<std::size_t> run) { m_model->setInUse(run); }
    void setOnlyUnbeaten(bool only);
    /// Brings it into sight; where the table has no row for it, none is marked.
    void mark(std::optional<std::size_t> run);
    std::optional<std::size_t> marked() const;
    /// Why the tissue cannot move by a run, or by what was left out; empty where it can.
    QString obstacle(std::size_t run) const { return m_model->obstacle(static_cast<int>(run)); }

signals:
    void markChanged();
    void chosen(std::size_t run);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class SortedRuns;

    void shareWidth();
    void choose(const QModelIndex& index);

    RunsModel* m_model;
    SortedRuns* m_sorted;
};

} // namespace esm
