#pragma once

#include "app/editor/tools/painting.h"
#include "widgets/view/organ_view.h"

namespace esm {

/// Between the brush in the view and what it paints.
class BrushController : public QObject {
    Q_OBJECT

public:
    BrushController(OrganView& view, Painting& painting);

private:
    void show();

    OrganView& m_view;
    Painting& m_painting;
};

} // namespace esm
