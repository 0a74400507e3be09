#include "widgets/view/axis_cube.h"

#include <QCoreApplication>
#include <QTransform>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double faceText = 100; // a face's own coordinates run from 0 to this

struct Side {
    StandardView view;
    const char* name;
    Vector3d outwards, right, up;
};

std::vector<Side> sides() {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
    return {{StandardView::Front, QT_TRANSLATE_NOOP("esm::AxisCube", "FRONT"), z, x, y},
            {StandardView::Back, QT_TRANSLATE_NOOP("esm::AxisCube", "BACK"), -z, -x, y},
            {StandardView::Left, QT_TRANSLATE_NOOP("esm::AxisCube", "LEFT"), -x, z, y},
            {StandardView::Right, QT_TRANSLATE_NOOP("esm::AxisCube", "RIGHT"), x, -z, y},
            {StandardView::Top, QT_TRANSLATE_NOOP("esm::AxisCube", "TOP"), y, x, -z},
            {StandardView::Bottom, QT_TRANSLATE_NOOP("esm::AxisCube", "BOTTOM"), -y, x, z}};
}

QString nameOf(StandardView view) {
    for (const Side& side : sides())
        if (side.view == view) return QCoreApplication::translate("esm::AxisCube", side.name);
    return {};
}

QColor mixed(const QColor& from, const QColor& to, double share) {
    return QColor::fromRgbF(from.redF() + share * (to.redF() - from.redF()),
                            from.greenF() + share * (to.greenF() - from.greenF()),
                            from.blueF() + share * (to.blueF() - from.blueF()));
}

} // namespace

/// Drawn without perspective, a convex body hides itself rightly where its faces turn away: no order of
/// drawing is needed. Faces seen from less than about a degree aside are left out, as they are lines.
std::vector<CubeFace> visibleFaces(const Camera& camera, const QRectF& square) {
    const Eigen::Matrix3d toCamera = cameraAxes(camera).transpose();
    // A turned cube is wider than its face: its corners lie √3 halves of a side from the middle. All are
    // inside the square, but for one that points nearly straight up or down: up to 6 % of the square's side
    // of it stand out.
    const double half = square.width() / 2 / std::sqrt(3.0) * 1.12;
    std::vector<CubeFace> faces;
    for (const Side& side : sides()) {
        const double facing = (toCamera * side.outwards).z();
        if (facing < 0.02) continue;
        QPolygonF outline;
        for (const auto& [right, up] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
            const Vector3d corner = half * (toCamera * (side.outwards + right * side.right + up * side.up));
            outline << square.center() + QPointF(corner.x(), -corner.y());
        }
        faces.push_back({side.view, outline, facing});
    }
    return faces;
}

void paintAxisCube(QPainter& painter, const Camera& camera, const QRectF& square, const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(20);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    for (const CubeFace& face : visibleFaces(camera, square)) {
        painter.setPen(QPen(palette.color(QPalette::Mid), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(mixed(palette.color(QPalette::Dark), palette.color(QPalette::Button), face.facing));
        painter.drawPolygon(face.outline);
        QTransform onFace;
        const QPolygonF flat({{0, 0}, {faceText, 0}, {faceText, faceText}, {0, faceText}});
        if (face.facing < 0.3 || !QTransform::quadToQuad(flat, face.outline, onFace)) continue;
        painter.save();
        painter.setTransform(onFace, true);
        painter.setPen(palette.color(QPalette::WindowText));
        painter.drawText(QRectF(0, 0, faceText, faceText), Qt::AlignCenter, nameOf(face.view));
        painter.restore();
    }
    painter.restore();
}

std::optional<StandardView> viewAt(const QPointF& point, const Camera& camera, const QRectF& square) {
    for (const CubeFace& face : visibleFaces(camera, square))
        if (face.outline.containsPoint(point, Qt::OddEvenFill)) return face.view;
    return std::nullopt;
}

} // namespace esm
