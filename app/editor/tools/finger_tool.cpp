#include "app/editor/tools/finger_tool.h"

#include "core/geometry/triangle_mesh.h"
#include "widgets/view/overlay.h"

#include <QRadialGradient>

namespace esm {

namespace {

constexpr int solidity = 190, hiddenSolidity = 70; // of 255, of the ball
constexpr int stripSolidity = 60;                  // the same of a strip
constexpr double clampWidth = 5;                   // pixels

/// Which way is out where the surface carries a place now; none without a surface.
std::optional<Eigen::Vector3d> outwardAt(const Sight& sight, const CarriedPlace& place) {
    std::vector<Eigen::Vector3d> corners;
    corners.reserve(3);
    for (int corner = 0; corner < 3; ++corner)
        corners.push_back(sight.picker.carried(sight.scene, {place.corners, Eigen::Vector3d::Unit(corner)}));
    const Eigen::Vector3d area = areaNormal(corners, {0, 1, 2});
    return area.norm() > 0 ? std::optional<Eigen::Vector3d>(area.stableNormalized()) : std::nullopt;
}

/// Lit from the upper left, as the organ is.
void paintBall(QPainter& painter, const QPointF& middle, double radius, QColor colour, int alpha) {
    QRadialGradient shade(middle, radius, middle - QPointF(0.4, 0.4) * radius);
    QColor light = colour.lighter(190), dark = colour.darker(150);
    for (QColor* tint : {&light, &colour, &dark})
        tint->setAlpha(alpha);
    shade.setColorAt(0, light);
    shade.setColorAt(0.6, colour);
    shade.setColorAt(1, dark);
    painter.setPen(QPen(QColor(0, 0, 0, alpha / 2), 1.2));
    painter.setBrush(shade);
    painter.drawEllipse(middle, radius, radius);
}

/// Its outline, and its clamps as broad strokes.
void paintStrip(QPainter& painter, const Sight& sight, const Eigen::Vector3d& place, const StripFrame& frame,
                const StripSettings& strip, const QColor& colour) {
    QPolygonF corners;
    for (const auto& [x, y] : {std::pair(-1, -1), {-1, 1}, {1, 1}, {1, -1}})
        if (const auto seen = sight.placeOf(place + x * strip.length / 2 * frame.along +
                                            y * strip.width / 2 * frame.across))
            corners << *seen;
    if (corners.size() < 4) return;
    QColor inside = colour;
    inside.setAlpha(stripSolidity);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(inside);
    painter.drawPolygon(corners);
    painter.setPen(QPen(colour, clampWidth, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(corners[0], corners[1]);
    painter.drawLine(corners[2], corners[3]);
}

} // namespace

FingerTool::FingerTool(const ToolContext& context) : m_test(context.virtualTest) {
    connect(&m_test, &VirtualTest::changed, this, &FingerTool::changed);
}

void FingerTool::click(const ToolMouse& mouse) {
    const auto picked = mouse.picked();
    if (picked) m_test.choosePlace(picked->carried, picked->normal.dot(picked->spot.outward) < 0);
}

/// As it first touches: its size tells what it will cover.
void FingerTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    if (!m_test.place()) return;
    const Eigen::Vector3d place = sight.picker.carried(sight.scene, *m_test.place());
    if (m_test.kind() == TestKind::Strip) {
        painter.save();
        if (m_test.stripFrame())
            paintStrip(painter, sight, place, *m_test.stripFrame(), m_test.stripSettings(),
                       palette.color(QPalette::Link));
        painter.restore();
        return;
    }
    const std::optional<Eigen::Vector3d> outward = outwardAt(sight, *m_test.place());
    if (!outward) return;
    const double radius = m_test.settings().radius;
    const Eigen::Vector3d centre = place + radius * *outward;
    const auto seen = sight.placeOf(centre);
    if (!seen) return;
    painter.save();
    paintBall(painter, *seen, radius / sight.pixelAt(centre), palette.color(QPalette::Link),
              sight.hides(centre) ? hiddenSolidity : solidity);
    painter.restore();
}

QString FingerTool::hint() const {
    if (!m_test.place())
        return m_test.kind() == TestKind::Strip ? tr("Click the organ: there the strip is cut") : QString();
    return m_test.kind() == TestKind::Strip
               ? tr("The column at the left measures · click elsewhere to cut there · a drag turns the view")
               : tr("The column at the left measures · click elsewhere to move the finger · a drag turns the "
                    "view");
}

} // namespace esm
