#include "app/editor/tools/landmark_tool.h"

#include <utility>

namespace esm {

namespace {

std::size_t pairOf(int number) {
    return static_cast<std::size_t>(number - 1);
}

QString nextStep(const Landmarking::Half& half) {
    if (half.photo) return LandmarkTool::tr("Now click the same point on the organ");
    if (half.organ) return LandmarkTool::tr("Now click the same point here");
    return LandmarkTool::tr(
        "Click a point that you find on the organ too · wheel comes closer, a drag shifts");
}

} // namespace

LandmarkTool::LandmarkTool(const ToolContext& context)
    : m_selection(context.selection), m_landmarking(context.landmarking) {
    connect(&m_landmarking, &Landmarking::changed, this, &LandmarkTool::show);
    show();
}

QWidget* LandmarkTool::makeOptions() {
    m_photo = new PhotoView;
    connect(m_photo, &PhotoView::pixelPicked, &m_landmarking, &Landmarking::pickPixel);
    connect(m_photo, &PhotoView::markSelected, this,
            [this](int number) { m_landmarking.select(pairOf(number)); });
    connect(m_photo, &PhotoView::markDragged, this, [this](int number, const Eigen::Vector2d& pixel) {
        m_landmarking.movePixel(pairOf(number), pixel);
    });
    connect(m_photo, &PhotoView::markDropped, &m_landmarking, &Landmarking::finishMove);
    show();
    return m_photo;
}

Hold LandmarkTool::press(const ToolMouse& mouse) {
    m_dragged = markAt(painted(mouse.sight), mouse.place);
    return m_dragged ? Hold::Drag : Hold::Nothing;
}

void LandmarkTool::move(const ToolMouse& mouse) {
    if (!m_dragged) return;
    if (const auto picked = mouse.picked()) m_landmarking.movePoint(pairOf(*m_dragged), picked->spot.point);
}

void LandmarkTool::release() {
    if (m_dragged) m_landmarking.finishMove();
    m_dragged.reset();
}

void LandmarkTool::click(const ToolMouse& mouse) {
    if (const auto mark = markAt(painted(mouse.sight), mouse.place))
        return m_landmarking.select(pairOf(*mark));
    if (const auto picked = mouse.picked()) m_landmarking.pickPoint(picked->spot.point);
}

/// A mark that is dragged goes back to where it was; else the point that waits for its other half is given
/// up.
void LandmarkTool::cancel() {
    const bool isInPhoto = m_photo && m_photo->letGo();
    m_landmarking.dropMove();
    if (!std::exchange(m_dragged, std::nullopt) && !isInPhoto) m_landmarking.giveUpHalf();
}

void LandmarkTool::show() {
    const auto& pairs = m_landmarking.pairs();
    const PoseFit* fit = m_landmarking.fit();
    std::vector<PhotoMark> inPhoto;
    m_marks.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const MarkLook look{static_cast<int>(i) + 1, fit && fit->outliers[i], m_landmarking.selected() == i};
        inPhoto.push_back({pairs[i].photo, look});
        m_marks.push_back({pairs[i].organ, look});
    }
    const MarkLook begun{static_cast<int>(pairs.size()) + 1, false, true};
    const auto& half = m_landmarking.half();
    if (half.photo) inPhoto.push_back({*half.photo, begun});
    if (half.organ) m_marks.push_back({*half.organ, begun});
    emit changed();
    if (!m_photo) return;
    m_photo->setPicture(m_landmarking.layer() ? pictureOf(*m_landmarking.layer()) : nullptr);
    m_photo->setMarks(std::move(inPhoto));
    m_photo->setHint(nextStep(half));
}

void LandmarkTool::draw(QPainter& painter, const Sight& sight, const QPalette& palette) const {
    paintMarks(painter, painted(sight), palette);
}

std::vector<PaintedMark> LandmarkTool::painted(const Sight& sight) const {
    std::vector<PaintedMark> painted;
    for (const OrganMark& mark : m_marks)
        if (const auto place = sight.placeOf(mark.point))
            painted.push_back({*place, mark.look, sight.hides(mark.point)});
    return painted;
}

} // namespace esm
