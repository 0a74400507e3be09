#include "app/editor/window/landmark_controller.h"

namespace esm {

namespace {

std::size_t pairOf(int number) {
    return static_cast<std::size_t>(number - 1);
}

} // namespace

LandmarkController::LandmarkController(OrganView& organ, PhotoView& photo, Landmarking& landmarking)
    : QObject(&organ), m_organ(organ), m_photo(photo), m_landmarking(landmarking) {
    connectViews();
    connect(&landmarking, &Landmarking::changed, this, &LandmarkController::show);
    connect(&organ, &OrganView::toolChanged, this, &LandmarkController::showTool);
    showTool(organ.tool());
    show();
}

void LandmarkController::connectViews() {
    connect(&m_photo, &PhotoView::pixelPicked, &m_landmarking, &Landmarking::pickPixel);
    connect(&m_organ, &OrganView::landmarkPicked, &m_landmarking, &Landmarking::pickPoint);
    const auto select = [this](int number) { m_landmarking.select(pairOf(number)); };
    connect(&m_photo, &PhotoView::markSelected, this, select);
    connect(&m_organ, &OrganView::markSelected, this, select);
    connect(&m_photo, &PhotoView::markDragged, this, [this](int number, const Eigen::Vector2d& pixel) {
        m_landmarking.movePixel(pairOf(number), pixel);
    });
    connect(&m_organ, &OrganView::markDragged, this, [this](int number, const Eigen::Vector3d& point) {
        m_landmarking.movePoint(pairOf(number), point);
    });
    connect(&m_photo, &PhotoView::markDropped, &m_landmarking, &Landmarking::finishMove);
    connect(&m_organ, &OrganView::markDropped, &m_landmarking, &Landmarking::finishMove);
}

void LandmarkController::connectActions(const Actions& actions) {
    connect(actions.letGo, &QAction::triggered, &m_landmarking, &Landmarking::giveUpHalf);
}

void LandmarkController::showTool(ViewTool tool) {
    m_photo.setVisible(tool == ViewTool::Landmark);
    if (tool != ViewTool::Landmark) m_landmarking.giveUpHalf();
}

void LandmarkController::show() {
    const auto& pairs = m_landmarking.pairs();
    const PoseFit* fit = m_landmarking.fit();
    std::vector<PhotoMark> inPhoto;
    std::vector<OrganMark> onOrgan;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const MarkLook look{static_cast<int>(i) + 1, fit && fit->outliers[i], m_landmarking.selected() == i};
        inPhoto.push_back({pairs[i].photo, look});
        onOrgan.push_back({pairs[i].organ, look});
    }
    const MarkLook begun{static_cast<int>(pairs.size()) + 1, false, true};
    const auto& half = m_landmarking.half();
    if (half.photo) inPhoto.push_back({*half.photo, begun});
    if (half.organ) onOrgan.push_back({*half.organ, begun});
    m_photo.setPicture(m_landmarking.layer() ? pictureOf(*m_landmarking.layer()) : nullptr);
    m_photo.setMarks(std::move(inPhoto));
    m_photo.setHint(nextStep());
    m_organ.setMarks(std::move(onOrgan));
}

QString LandmarkController::nextStep() const {
    const auto& half = m_landmarking.half();
    if (half.photo) return tr("Now click the same point on the organ");
    if (half.organ) return tr("Now click the same point here");
    return tr("Click a point that you find on the organ too · wheel comes closer, a drag shifts");
}

} // namespace esm
