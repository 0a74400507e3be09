#include "app/editor/panels/measure/press_figures.h"

namespace esm {

PressFigures::PressFigures(std::vector<PressFigure> figures, QWidget* parent)
    : FigureTable(parent), m_figures(std::move(figures)) {
    for (const PressFigure& figure : m_figures)
        addRow(figure.caption, figure.name, figure.explained);
}

void PressFigures::setResults(const MeasuredPress* now, const MeasuredPress* before) {
    for (std::size_t row = 0; row < m_figures.size(); ++row) {
        const auto valueOf = [&](const MeasuredPress* press) {
            return press ? m_figures[row].value(*press) : std::nullopt;
        };
        setRow(row, valueOf(now), valueOf(before));
    }
}

} // namespace esm
