#pragma once

#include "app/editor/workers/virtual_test.h"

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include <vector>

namespace esm {

/// One quantity of a test: what it is called, with its unit, and what it means.
struct PressFigure {
    QString caption;
    QString name; ///< finds its value in tests; with "Before" that which it is compared with
    QString explained;
    std::optional<double> (*value)(const MeasuredPress&); ///< in the caption's unit; none where there is none
};

/// What a finger met, in numbers: a row for each quantity, and beside it what it is compared with.
class PressFigures : public QWidget {
    Q_OBJECT

public:
    explicit PressFigures(const std::vector<PressFigure>& figures, QWidget* parent = nullptr);

    /// Null: dashes.
    void setResults(const MeasuredPress* now, const MeasuredPress* before);

private:
    struct Row {
        std::optional<double> (*value)(const MeasuredPress&);
        QLabel *now, *before;
    };

    QLabel* addValue(int row, int column, const QString& name);
    void addRow(const PressFigure& figure);

    QGridLayout* m_grid;
    std::vector<Row> m_rows;
};

} // namespace esm
