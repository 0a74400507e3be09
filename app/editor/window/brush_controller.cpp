#include "app/editor/window/brush_controller.h"

namespace esm {

BrushController::BrushController(OrganView& view, Painting& painting)
    : QObject(&view), m_view(view), m_painting(painting) {
    connect(&view, &OrganView::brushStarted, &painting, &Painting::begin);
    connect(&view, &OrganView::brushMoved, &painting, &Painting::goOn);
    connect(&view, &OrganView::brushLifted, &painting, &Painting::finish);
    connect(&view, &OrganView::brushDropped, &painting, &Painting::drop);
    connect(&view, &OrganView::brushSourcePicked, &painting, &Painting::setSource);
    connect(&painting, &Painting::changed, this, &BrushController::show);
    show();
}

void BrushController::show() {
    const BrushStroke brush = m_painting.brush();
    ViewBrush shown{brush.radius, brush.softness, std::nullopt};
    if (brush.kind == BrushKind::Clone) shown.source = m_painting.source();
    m_view.setBrush(shown);
}

} // namespace esm
