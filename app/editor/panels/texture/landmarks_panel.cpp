#include "app/editor/panels/texture/landmarks_panel.h"

#include "app/editor/dialogs/landmark_files.h"
#include "core/support/angles.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"
#include "widgets/inputs/number_text.h"

#include <QStyle>

#include <cmath>

namespace esm {

namespace {

constexpr std::size_t pairsForPose = 4;
const QColor agrees(0x3f, 0xb6, 0xa8), doubtful(0xe3, 0xa3, 0x3b), unknown(0x98, 0xa1, 0xab);

QString pixelText(double pixels) {
    if (!std::isfinite(pixels)) return QObject::tr("behind");
    return QObject::tr("%1 px").arg(decimalText(pixels, 1));
}

QString sourced(PartSource source, const QString& value) {
    switch (source) {
    case PartSource::Given:
        return QObject::tr("%1, as given").arg(value);
    case PartSource::Found:
        return QObject::tr("%1, found").arg(value);
    case PartSource::Assumed:
        return QObject::tr("%1, assumed").arg(value);
    }
    return {};
}

QString sureText(const PoseFit& fit) {
    if (!std::isfinite(fit.eyeWithin) || !std::isfinite(fit.turnWithin)) return QObject::tr("unknown");
    return QObject::tr("± %1 mm, %2°")
        .arg(numberText(1000 * fit.eyeWithin, 2), numberText(fit.turnWithin, 2));
}

QString fieldOfViewText(const PoseFit& fit, PhotoSize photo) {
    const double focalLength = intrinsicsOf(fit.projector, photo).fy;
    const double degrees = toDegrees(2 * std::atan(photo.height / (2 * focalLength)));
    return sourced(fit.focalLength, QObject::tr("%1° high").arg(decimalText(degrees, 1)));
}

/// Where the line of sight meets the photo, from its middle.
QString lineOfSightText(const PoseFit& fit, PhotoSize photo) {
    const Intrinsics camera = intrinsicsOf(fit.projector, photo);
    const double right = camera.cx - photo.width / 2.0, below = camera.cy - photo.height / 2.0;
    if (right == 0 && below == 0) return sourced(fit.principalPoint, QObject::tr("in the middle"));
    const QString across = right < 0 ? QObject::tr("%1 px left") : QObject::tr("%1 px right");
    const QString along = below < 0 ? QObject::tr("%1 px up") : QObject::tr("%1 px down");
    return sourced(fit.principalPoint, across.arg(decimalText(std::abs(right), 0)) + QStringLiteral(", ") +
                                           along.arg(decimalText(std::abs(below), 0)));
}

QString pixelsText(const PoseFit& fit, PhotoSize photo) {
    const Intrinsics camera = intrinsicsOf(fit.projector, photo);
    const double stretch = camera.fx / camera.fy;
    const bool isSquare = std::abs(stretch - 1) < 5e-4;
    return sourced(fit.pixelAspect,
                   isSquare ? QObject::tr("square")
                            : QObject::tr("photo stretched × %1 in width").arg(decimalText(stretch, 3)));
}

QString hangsOn(CameraPart part) {
    switch (part) {
    case CameraPart::FocalLength:
        return LandmarksPanel::tr("the focal length");
    case CameraPart::PrincipalPoint:
        return LandmarksPanel::tr("the line of sight");
    case CameraPart::PixelAspect:
        return LandmarksPanel::tr("the shape of the pixels");
    }
    return {};
}

QString adviceOn(Weakness weakness) {
    switch (weakness) {
    case Weakness::NearlyOnALine:
        return LandmarksPanel::tr("The landmarks lie nearly on a line: set some beside it");
    case Weakness::NearlyPlanar:
        return LandmarksPanel::tr("The landmarks lie nearly in a plane: set some nearer or further away");
    case Weakness::CloseTogether:
        return LandmarksPanel::tr("The landmarks lie close together: set some further out in the photo");
    }
    return {};
}

/// A label whose colour warns, or not.
void setWarning(QLabel* label, bool on) {
    if (label->property("warning").toBool() == on) return;
    label->setProperty("warning", on);
    label->style()->unpolish(label);
    label->style()->polish(label);
}

} // namespace

LandmarksPanel::LandmarksPanel(Landmarking& landmarking, QWidget* parent)
    : Section(tr("Landmarks"), parent), m_landmarking(landmarking), m_count(new QLabel(this)),
      m_remark(new QLabel(this)), m_list(new ItemList(QPalette::LinkVisited, this)),
      m_place(new QPushButton(tr("P&lace photo"), this)), m_load(new QPushButton(tr("Load…"), this)),
      m_save(new QPushButton(tr("Save…"), this)),
      m_refine(new QPushButton(tr("&Refine by the other photos"), this)) {
    layOut();
    connect(m_list, &ItemList::rowSelected, this, [this](int row) {
        m_landmarking.select(row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row)));
    });
    connect(m_list, &ItemList::removeRequested, this, &LandmarksPanel::removeSelected);
    connect(m_remove, &QToolButton::clicked, this, &LandmarksPanel::removeSelected);
    connect(m_place, &QPushButton::clicked, &landmarking, &Landmarking::place);
    connect(m_refine, &QPushButton::clicked, &landmarking, &Landmarking::refine);
    connect(m_load, &QPushButton::clicked, this, &LandmarksPanel::load);
    connect(m_save, &QPushButton::clicked, this, &LandmarksPanel::save);
    connect(&landmarking, &Landmarking::changed, this, &LandmarksPanel::show);
    show();
}

void LandmarksPanel::layOut() {
    m_count->setProperty("quiet", true);
    m_count->setObjectName(QStringLiteral("landmarkCount"));
    addToHeader(m_count);
    m_remove = addHeaderIcon(icon(QStringLiteral("remove")), tr("Remove the landmark"));
    m_tool = addHeaderButton(tr("+ set"), tr("Set landmarks"));
    m_list->setObjectName(QStringLiteral("landmarkList"));
    m_list->setAccessibleName(tr("Landmarks"));
    m_list->setToolTip(tr("Pairs of a point in the photo and one on the organ. Del removes one"));
    m_list->setEmptyText(tr("None yet. Four or more place the photo."));
    auto* rows = new ValueRows(this);
    m_error = rows->addText(tr("Mean error"), QStringLiteral("landmarkError"));
    m_error->setToolTip(tr("In photo pixels, root of the mean square over the landmarks that agree"));
    m_sure = rows->addText(tr("Sure within"), QStringLiteral("landmarkSure"));
    m_sure->setToolTip(
        tr("How near the true camera stands to the projector, and how little it is turned from "
           "it, with 95 % certainty. The clicks' errors tell it"));
    m_focalLength = rows->addText(tr("Field of view"), QStringLiteral("landmarkFocalLength"));
    m_lineOfSight = rows->addText(tr("Line of sight"), QStringLiteral("landmarkLineOfSight"));
    m_lineOfSight->setToolTip(tr("Where it meets the photo, from the photo's middle"));
    m_pixels = rows->addText(tr("Pixels"), QStringLiteral("landmarkPixels"));
    for (QLabel* part : {m_focalLength, m_pixels})
        part->setToolTip(
            tr("The more landmarks, spread over the photo and in depth, the more of the camera they "
               "tell. What they do not tell is assumed to be as usual"));
    m_remark->setObjectName(QStringLiteral("landmarkRemark"));
    m_remark->setWordWrap(true);
    m_remark->setAlignment(Qt::AlignTop);
    m_remark->setMinimumHeight(3 * m_remark->fontMetrics().lineSpacing());
    m_place->setObjectName(QStringLiteral("placeByLandmarks"));
    m_load->setObjectName(QStringLiteral("loadLandmarks"));
    m_save->setObjectName(QStringLiteral("saveLandmarks"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_place, m_load, m_save})
        buttons->addWidget(button);
    body()->addWidget(rows);
    body()->addWidget(m_list);
    body()->addWidget(m_remark);
    body()->addLayout(buttons);
    m_refine->setObjectName(QStringLiteral("refinePlacement"));
    body()->addWidget(m_refine);
}

void LandmarksPanel::setToolAction(QAction* action) {
    follow(m_tool, action);
}

void LandmarksPanel::show() {
    showRows();
    showResult();
    showUse();
}

void LandmarksPanel::showRows() {
    const PoseFit* fit = m_landmarking.fit();
    const std::size_t count = m_landmarking.pairs().size();
    std::vector<ItemRow> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const bool isOutlier = fit && fit->outliers[i];
        const QString name = isOutlier ? tr("Pair %1, check it").arg(i + 1) : tr("Pair %1").arg(i + 1);
        const QColor colour = !fit ? unknown : isOutlier ? doubtful : agrees;
        rows.push_back({name, fit ? pixelText(fit->errors[i]) : QString(), colour, {}, false});
    }
    if (m_landmarking.half().isBegun()) {
        const bool needsOrgan = m_landmarking.half().photo.has_value();
        rows.push_back(
            {tr("Pair %1").arg(count + 1), needsOrgan ? tr("organ?") : tr("photo?"), unknown, {}, false});
    }
    const auto selected = m_landmarking.selected();
    m_list->setRows(rows, selected ? static_cast<int>(*selected) : -1);
    m_count->setText(count == 1 ? tr("1 pair") : tr("%1 pairs").arg(count));
}

void LandmarksPanel::showResult() {
    const PoseFit* fit = m_landmarking.fit();
    m_error->setText(fit ? pixelText(fit->error) : QString(QChar(0x2013)));
    const QString none(QChar(0x2013));
    const PhotoSize photo = fit ? sizeOf(*pictureOf(*m_landmarking.layer())) : PhotoSize{1, 1};
    m_sure->setText(fit ? sureText(*fit) : none);
    m_focalLength->setText(fit ? fieldOfViewText(*fit, photo) : none);
    m_lineOfSight->setText(fit ? lineOfSightText(*fit, photo) : none);
    m_pixels->setText(fit ? pixelsText(*fit, photo) : none);
    showRemark();
}

/// What went wrong comes first, then what is under way, then what keeps the pose from being sure.
void LandmarksPanel::showRemark() {
    const QString failure = m_landmarking.failure();
    const QString doubt = failure.isEmpty() && state().isEmpty() ? this->doubt() : QString();
    m_remark->setText(!failure.isEmpty() ? tr("%1. The photo stays where it is.").arg(failure)
                      : doubt.isEmpty()  ? state()
                                         : doubt);
    setWarning(m_remark, !failure.isEmpty() || !doubt.isEmpty());
}

QString LandmarksPanel::state() const {
    const std::size_t count = m_landmarking.pairs().size();
    if (!m_landmarking.layer()) return {};
    if (m_landmarking.isRefining()) return tr("Comparing the photo with the others…");
    if (m_landmarking.wasRefinedInVain())
        return tr("The photo stays: it meets too little of the others, or agrees as well as it can");
    if (const PoseRefinement* refined = m_landmarking.refinement())
        return tr("Refined: moved by %1 px. It differs from the others by %2 % of the contrast, before by %3 "
                  "%")
            .arg(decimalText(refined->moved, 1), decimalText(100 * refined->errorAfter, 0),
                 decimalText(100 * refined->errorBefore, 0));
    if (count < pairsForPose) return tr("%1 of %2 that place the photo").arg(count).arg(pairsForPose);
    if (!m_landmarking.fit()) return tr("Looking for the pose…");
    return m_landmarking.isElsewhere() ? tr("The photo was moved from where they place it") : QString();
}

QString LandmarksPanel::doubt() const {
    const PoseFit* fit = m_landmarking.fit();
    if (!fit) return {};
    if (fit->dominating)
        return tr("How sure it is hangs on %1, which they hardly tell: set more, or choose a calibrated "
                  "camera")
            .arg(hangsOn(*fit->dominating));
    return fit->weaknesses.empty() ? QString() : adviceOn(fit->weaknesses.front());
}

void LandmarksPanel::showUse() {
    const QString noPhoto = tr("No photo is selected"), none = tr("There are no landmarks");
    const bool hasPhoto = m_landmarking.layer() != nullptr;
    const QString notPlaced =
        !m_landmarking.fit() ? tr("The landmarks give no pose") : tr("The photo stands where they place it");
    enable(m_place, hasPhoto && m_landmarking.isElsewhere(),
           tr("Project the photo from where the landmarks say it was taken"), hasPhoto ? notPlaced : noPhoto);
    enable(m_load, hasPhoto, tr("Load landmarks from a CSV file: photo_x,photo_y,x,y,z in pixels and metres"),
           noPhoto);
    enable(m_save, !m_landmarking.pairs().empty(), tr("Save the landmarks as CSV, for esmc texture fit"),
           hasPhoto ? none : noPhoto);
    enable(m_refine, hasPhoto && m_landmarking.mayRefine() && !m_landmarking.isRefining(),
           tr("Move the photo a little, to where it shows what the other photos show there"),
           !hasPhoto                    ? noPhoto
           : m_landmarking.isRefining() ? tr("It is being refined")
                                        : tr("No other photo is shown"));
    enable(m_remove, m_landmarking.selected().has_value(), tr("Remove the landmark (Del)"),
           tr("No landmark is selected"));
}

void LandmarksPanel::removeSelected() {
    if (const auto selected = m_landmarking.selected()) m_landmarking.remove(*selected);
}

void LandmarksPanel::load() {
    openLandmarks(window(), [this](std::vector<LandmarkPair> pairs) { m_landmarking.replace(pairs); });
}

void LandmarksPanel::save() {
    const QString name = QString::fromStdString(m_landmarking.layer()->name) + QStringLiteral(".csv");
    saveLandmarks(window(), name, m_landmarking.pairs());
}

} // namespace esm
