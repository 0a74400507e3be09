#include "widgets/texture/field_tool.h"

#include "core/geometry/segment_distance.h"
#include "core/support/angles.h"
#include "widgets/texture/photo_canvas.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double turnHandleAway = 28;   ///< widget pixels from the rim
constexpr std::size_t mostHandles = 40; ///< corners; more hide what they lie on
constexpr double smallestRadius = 2;    ///< photo pixels
constexpr std::size_t fewestCorners = 3;

/// Of the first radius; the second lies a quarter of a turn on, towards y.
Eigen::Vector2d axisOf(const PhotoField& field) {
    const double angle = toRadians(field.angle);
    return {std::cos(angle), std::sin(angle)};
}

Eigen::Vector2d across(const Eigen::Vector2d& axis) {
    return {-axis.y(), axis.x()};
}

} // namespace

/// Middle, the ends of both radii, and of an ellipse the one that turns it; or a polygon's corners.
std::vector<Eigen::Vector2d> FieldTool::handles() const {
    const PhotoField& field = *m_canvas.field();
    if (field.shape == FieldShape::Polygon) return field.corners;
    const Eigen::Vector2d axis = axisOf(field);
    std::vector<Eigen::Vector2d> places{field.centre, field.centre + field.radii.x() * axis,
                                        field.centre + field.radii.y() * across(axis)};
    if (m_shape == Shape::Ellipse)
        places.emplace_back(field.centre +
                            (field.radii.x() + turnHandleAway / m_canvas.magnification()) * axis);
    return places;
}

void FieldTool::press(const QMouseEvent& event) {
    m_before = m_canvas.field();
    m_start = m_canvas.toPhoto(event.localPos());
    m_way = {m_start};
    m_part = Part::New;
    if (m_before) grasp(event.localPos());
}

void FieldTool::grasp(const QPointF& at) {
    m_part.reset();
    if (m_before->shape == FieldShape::Polygon)
        graspPolygon(at);
    else
        graspEllipse(at);
    if (!m_part && distanceInside(*m_before, m_start) > 0) m_part = Part::Whole;
}

void FieldTool::graspEllipse(const QPointF& at) {
    constexpr std::array<Part, 4> parts{Part::Whole, Part::FirstRadius, Part::SecondRadius, Part::Turn};
    const std::vector<Eigen::Vector2d> places = handles();
    for (std::size_t i = 0; i < places.size(); ++i)
        if (m_canvas.isAt(places[i], at)) m_part = parts[i];
}

/// A corner, or a new one in the side that is grasped.
void FieldTool::graspPolygon(const QPointF& at) {
    PhotoField field = *m_before;
    for (std::size_t i = 0; i < field.corners.size() && !m_part; ++i)
        if (m_canvas.isAt(field.corners[i], at)) {
            m_part = Part::Corner;
            m_corner = i;
        }
    for (std::size_t i = 0; i < field.corners.size() && !m_part; ++i) {
        const Eigen::Vector2d &from = field.corners[i], &to = field.corners[(i + 1) % field.corners.size()];
        if (distanceToSegment(m_start, from, to) * m_canvas.magnification() > PhotoCanvas::grip / 2.0 ||
            field.corners.size() >= mostFieldCorners)
            continue;
        m_part = Part::Corner;
        m_corner = i + 1;
        field.corners.insert(field.corners.begin() + static_cast<std::ptrdiff_t>(m_corner), m_start);
        m_canvas.setField(field);
    }
}

void FieldTool::drag(const QMouseEvent& event) {
    if (!m_part) return;
    const Eigen::Vector2d to = m_canvas.toPhoto(event.localPos());
    if (m_part == Part::New) {
        const PhotoField field = begun(to);
        if (!validate(field).empty()) return;
        m_canvas.setField(field);
    } else {
        PhotoField field = *m_canvas.field();
        shapeTo(field, to);
        m_canvas.setField(field);
    }
    emit m_canvas.fieldDrawn(*m_canvas.field());
}

PhotoField FieldTool::begun(const Eigen::Vector2d& to) {
    PhotoField field;
    if (m_shape == Shape::Polygon) {
        m_way.push_back(to);
        field.shape = FieldShape::Polygon;
        field.corners = simplified(m_way, 2 / m_canvas.magnification());
        return field;
    }
    field.centre = m_start;
    const Eigen::Vector2d way = (to - m_start).cwiseAbs();
    field.radii = m_shape == Shape::Circle ? Eigen::Vector2d::Constant(way.norm()) : way;
    field.radii = field.radii.cwiseMax(smallestRadius);
    return field;
}

void FieldTool::shapeTo(PhotoField& field, const Eigen::Vector2d& to) {
    const Eigen::Vector2d fromCentre = to - field.centre;
    switch (*m_part) {
    case Part::Whole:
        field.centre = m_before->centre + to - m_start;
        for (std::size_t i = 0; i < field.corners.size(); ++i)
            field.corners[i] = m_before->corners[i] + to - m_start;
        break;
    case Part::FirstRadius:
        field.radii.x() = std::max(smallestRadius, fromCentre.norm());
        break;
    case Part::SecondRadius:
        field.radii.y() = std::max(smallestRadius, fromCentre.norm());
        break;
    case Part::Turn:
        field.angle = toDegrees(std::atan2(fromCentre.y(), fromCentre.x()));
        break;
    case Part::Corner:
        field.corners[m_corner] = to;
        break;
    case Part::New:
        break;
    }
    if (m_shape == Shape::Circle && m_part == Part::FirstRadius) field.radii.y() = field.radii.x();
    if (m_shape == Shape::Circle && m_part == Part::SecondRadius) field.radii.x() = field.radii.y();
}

void FieldTool::release() {
    if (!m_part) return;
    m_part.reset();
    emit m_canvas.shapeFinished();
}

bool FieldTool::takeBack() {
    if (!m_canvas.field() || m_canvas.field()->corners.size() <= fewestCorners) return false;
    PhotoField field = *m_canvas.field();
    m_corner = std::min(m_corner, field.corners.size() - 1);
    field.corners.erase(field.corners.begin() + static_cast<std::ptrdiff_t>(m_corner));
    m_canvas.setField(field);
    emit m_canvas.fieldDrawn(field);
    emit m_canvas.shapeFinished();
    return true;
}

bool FieldTool::drop() {
    if (!m_part) return false;
    m_part.reset();
    m_canvas.setField(m_before);
    emit m_canvas.fieldDropped(m_before);
    return true;
}

void FieldTool::paint(QPainter& painter) const {
    if (!m_canvas.field()) return;
    const std::vector<Eigen::Vector2d> places = handles();
    if (places.size() > mostHandles) return;
    for (const Eigen::Vector2d& place : places)
        m_canvas.drawHandle(painter, place);
}

} // namespace esm
