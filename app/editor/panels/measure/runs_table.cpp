#include "app/editor/panels/measure/runs_table.h"

#include <QHeaderView>
#include <QKeyEvent>

namespace esm {

class RunsTable::SortedRuns : public QSortFilterProxyModel {
public:
    explicit SortedRuns(QObject* parent) : QSortFilterProxyModel(parent) { setSortRole(RunsModel::sortRole); }

    void setOnlyUnbeaten(bool only) {
        m_onlyUnbeaten = only;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex&) const override {
        return !m_onlyUnbeaten || static_cast<RunsModel*>(sourceModel())->isUnbeaten(row);
    }

private:
    bool m_onlyUnbeaten = false;
};

RunsTable::RunsTable(QWidget* parent)
    : QTableView(parent), m_model(new RunsModel(this)), m_sorted(new SortedRuns(this)) {
    setObjectName(QStringLiteral("runsTable"));
    setAccessibleName(tr("Measured runs"));
    setToolTip(tr("Every run that was measured. A click on a column's name sorts by it"));
    m_sorted->setSourceModel(m_model);
    setModel(m_sorted);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setTabKeyNavigation(false);
    setShowGrid(false);
    setWordWrap(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // its width is known before there are rows
    setSortingEnabled(true);
    sortByColumn(RunsModel::Speed, Qt::DescendingOrder);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
    horizontalHeader()->setHighlightSections(false);
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, &RunsTable::markChanged);
    connect(this, &QTableView::doubleClicked, this, &RunsTable::choose);
}

void RunsTable::setTradeoff(const Tradeoff* tradeoff) {
    m_model->setTradeoff(tradeoff);
    shareWidth();
}

void RunsTable::setOnlyUnbeaten(bool only) {
    m_sorted->setOnlyUnbeaten(only);
}

void RunsTable::mark(std::optional<std::size_t> run) {
    if (run == marked()) return;
    const QModelIndex row =
        run ? m_sorted->mapFromSource(m_model->index(static_cast<int>(*run), 0)) : QModelIndex();
    setCurrentIndex(row);
    if (row.isValid()) scrollTo(row);
}

std::optional<std::size_t> RunsTable::marked() const {
    const QModelIndex row = m_sorted->mapToSource(currentIndex());
    return row.isValid() ? std::optional<std::size_t>(row.row()) : std::nullopt;
}

QString RunsTable::obstacle() const {
    return m_model->obstacle(m_sorted->mapToSource(currentIndex()).row());
}

void RunsTable::choose(const QModelIndex& index) {
    if (const QModelIndex row = m_sorted->mapToSource(index); row.isValid())
        emit chosen(static_cast<std::size_t>(row.row()));
}

void RunsTable::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        choose(currentIndex());
    else
        QTableView::keyPressEvent(event);
}

// The numbers are as wide as they need; the method takes what is left.
void RunsTable::shareWidth() {
    int left = viewport()->width();
    for (int column = RunsModel::Step; column < RunsModel::columns; ++column) {
        const int width =
            std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column)) + 4;
        setColumnWidth(column, width);
        left -= width;
    }
    constexpr int narrowestMethod = 90; // pixels
    setColumnWidth(RunsModel::Method, std::max(left, narrowestMethod));
}

void RunsTable::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    shareWidth();
}

} // namespace esm
