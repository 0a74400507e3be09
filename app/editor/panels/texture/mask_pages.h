#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "widgets/inputs/number_field.h"
#include "widgets/texture/photo_canvas.h"

#include <QPushButton>

namespace esm {

/// What stands above a photo while a brush leaves something of it out.
class BrushPage : public QWidget {
    Q_OBJECT

public:
    explicit BrushPage(PhotoCanvas& canvas, QWidget* parent = nullptr);

    void fitTo(const Image& photo); ///< a radius that does for a photo of that size

private:
    void change(double factor);

    PhotoCanvas& m_canvas;
    NumberField *m_radius, *m_softness;
};

/// What stands above it while outlines and boxes do, or text is looked for.
class OutlinePage : public QWidget {
    Q_OBJECT

public:
    explicit OutlinePage(PreparationEdits& edits, QWidget* parent = nullptr);
};

/// What stands above it while a click leaves out what hangs together with a place.
class RegionPage : public QWidget {
    Q_OBJECT

public:
    explicit RegionPage(PreparationEdits& edits, QWidget* parent = nullptr);

    void grow(const Eigen::Vector2d& place);

private:
    PreparationEdits& m_edits;
    NumberField* m_tolerance;
};

} // namespace esm
