#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include <optional>
#include <vector>

namespace esm {

/// Measured numbers: a row for each quantity, and beside it what it is compared with.
class FigureTable : public QWidget {
    Q_OBJECT

public:
    explicit FigureTable(QWidget* parent = nullptr);

    /// @param caption with its unit
    /// @param name by which the value is found, and under its own name followed by "Before" the other
    void addRow(const QString& caption, const QString& name, const QString& explained);
    /// None: a dash.
    void setRow(std::size_t row, std::optional<double> now, std::optional<double> before);

private:
    struct Row {
        QLabel *now, *before;
    };

    QLabel* addValue(int row, int column, const QString& name);

    QGridLayout* m_grid;
    std::vector<Row> m_rows;
};

} // namespace esm
