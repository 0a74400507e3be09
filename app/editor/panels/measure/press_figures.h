#pragma once

#include "core/probing/probe.h"

#include <QGridLayout>
#include <QLabel>
#include <QWidget>

#include <vector>

namespace esm {

/// What a finger met, in numbers: a row for each quantity, and beside it what it is compared with.
class PressFigures : public QWidget {
    Q_OBJECT

public:
    explicit PressFigures(QWidget* parent = nullptr);

    /// Null: dashes.
    void setResults(const ProbeResult* now, const ProbeResult* before);

private:
    struct Row {
        double (*value)(const ProbeResult&);
        QLabel *now, *before;
    };

    QLabel* addValue(int row, int column, const QString& name);
    void addRow(const QString& caption, const QString& name, const QString& explained,
                double (*value)(const ProbeResult&));

    QGridLayout* m_grid;
    std::vector<Row> m_rows;
};

} // namespace esm
