#pragma once

#include "app/editor/panels/measure/figure_table.h"
#include "app/editor/workers/virtual_test.h"

namespace esm {

/// One quantity of a test: what it is called, with its unit, and what it means.
struct PressFigure {
    QString caption;
    QString name; ///< as of a row of the table
    QString explained;
    std::optional<double> (*value)(const MeasuredPress&); ///< in the caption's unit; none where there is none
};

/// What a finger met, in numbers.
class PressFigures : public FigureTable {
    Q_OBJECT

public:
    explicit PressFigures(std::vector<PressFigure> figures, QWidget* parent = nullptr);

    /// Null: dashes.
    void setResults(const MeasuredPress* now, const MeasuredPress* before);

private:
    std::vector<PressFigure> m_figures;
};

} // namespace esm
