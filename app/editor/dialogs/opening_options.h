#pragma once

#include "app/editor/workers/imported_surface.h"
#include "core/geometry/length_unit.h"
#include "widgets/inputs/number_field.h"

#include <QCheckBox>
#include <QLabel>
#include <QWidget>

namespace esm {

/// What is open in a surface, and whether slits are to be closed and holes to be filled.
class OpeningOptions : public QWidget {
    Q_OBJECT

public:
    /// @param found the surface before any repair that is offered here
    OpeningOptions(std::shared_ptr<const ImportedSurface> found, LengthUnit unit, QWidget* parent = nullptr);

    /// What a unit of the file means decides how wide a slit may be.
    void setUnit(LengthUnit unit);
    /// What became of it by the options; null while that is not known yet.
    void showDone(const ImportedSurface* surface);

    double slitWidth() const;      ///< m; 0: none is closed
    std::size_t holeEdges() const; ///< 0: none is filled

signals:
    void changed();

private:
    QString foundText(LengthUnit unit) const;
    double proposedWidth(LengthUnit unit) const;
    void connectRow(QCheckBox* chosen, NumberField* number);

    std::shared_ptr<const ImportedSurface> m_found;
    QLabel* m_open;
    QCheckBox *m_closes, *m_fills;
    NumberField *m_width, *m_edges;
    QLabel *m_widthLimits, *m_closed, *m_filled, *m_left;
    bool m_isWidthTyped = false;
};

} // namespace esm
