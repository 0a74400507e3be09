#include "widgets/texture/line_tool.h"

#include "widgets/texture/photo_canvas.h"

namespace esm {

LineTool::~LineTool() {
    if (!m_canvas.drawnLines().empty()) m_canvas.drawnLines().back().clear();
}

void LineTool::press(const QMouseEvent& event) {
    std::vector<DrawnLine>& lines = m_canvas.drawnLines();
    if (lines.empty()) lines.emplace_back();
    lines.back().push_back(m_canvas.toPhoto(event.localPos()));
    emit m_canvas.linesChanged();
}

bool LineTool::finish() {
    std::vector<DrawnLine>& lines = m_canvas.drawnLines();
    if (lines.empty()) return false;
    if (!lines.back().empty()) lines.emplace_back();
    emit m_canvas.linesChanged();
    return true;
}

bool LineTool::takeBack() {
    std::vector<DrawnLine>& lines = m_canvas.drawnLines();
    if (lines.empty()) return false;
    if (!lines.back().empty()) lines.back().pop_back();
    if (lines.back().empty()) lines.pop_back();
    emit m_canvas.linesChanged();
    return true;
}

void LineTool::paint(QPainter& painter) const {
    const QColor colour = m_canvas.palette().color(QPalette::Highlight).lighter(140);
    for (const DrawnLine& line : m_canvas.drawnLines()) {
        QPolygonF points;
        for (const Eigen::Vector2d& place : line)
            points << m_canvas.toWidget(place);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, 1.5));
        painter.drawPolyline(points);
        painter.setBrush(colour);
        painter.setPen(QPen(Qt::black, 1));
        for (const QPointF& point : points)
            painter.drawEllipse(point, 4, 4);
    }
}

} // namespace esm
