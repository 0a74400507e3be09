#pragma once

#include "app/editor/edits/preparation_edits.h"
#include "app/editor/workers/highlight_finder.h"
#include "widgets/inputs/value_slider.h"
#include "widgets/texture/photo_canvas.h"

#include <QCheckBox>
#include <QLabel>

namespace esm {

/// What stands above a photo while highlights are chosen: a slider, whose highlights are marked on the photo
/// while it moves, and filled once it is let go.
class HighlightPage : public QWidget {
    Q_OBJECT

public:
    HighlightPage(PreparationEdits& edits, PhotoCanvas& canvas, QWidget* parent = nullptr);

    void showHighlights(); ///< as they are by now; marked where the page is shown

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    double sensitivity() const;
    void mark();
    void fill();

    PreparationEdits& m_edits;
    PhotoCanvas& m_canvas;
    HighlightFinder m_finder;
    QCheckBox* m_fills;
    ValueSlider* m_slider;
    QLabel* m_words;
};

} // namespace esm
