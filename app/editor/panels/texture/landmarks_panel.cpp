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

constexpr std::size_t pairsForPose = 4, pairsForFocalLength = 6;
const QColor agrees(0x3f, 0xb6, 0xa8), doubtful(0xe3, 0xa3, 0x3b), unknown(0x98, 0xa1, 0xab);

QString pixelText(double pixels) {
    if (!std::isfinite(pixels)) return QObject::tr("behind");
    return QObject::tr("%1 px").arg(decimalText(pixels, 1));
}

QString focalLengthText(const PoseFit& fit) {
    switch (fit.focalLength) {
    case FocalLength::Given:
        return QObject::tr("as measured");
    case FocalLength::Measured:
        return QObject::tr("found, %1° high").arg(decimalText(fit.projector.fieldOfView, 1));
    case FocalLength::Assumed:
        return QObject::tr("assumed, %1° high").arg(decimalText(assumedFieldOfView, 0));
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
      m_save(new QPushButton(tr("Save…"), this)) {
    layOut();
    connect(m_list, &ItemList::rowSelected, this, [this](int row) {
        m_landmarking.select(row < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row)));
    });
    connect(m_list, &ItemList::removeRequested, this, &LandmarksPanel::removeSelected);
    connect(m_remove, &QToolButton::clicked, this, &LandmarksPanel::removeSelected);
    connect(m_place, &QPushButton::clicked, &landmarking, &Landmarking::place);
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
    m_focalLength = rows->addText(tr("Focal length"), QStringLiteral("landmarkFocalLength"));
    m_focalLength->setToolTip(tr("Six landmarks or more tell it, where they do not lie in a plane"));
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
    m_focalLength->setText(fit ? focalLengthText(*fit) : QString(QChar(0x2013)));
    m_remark->setText(remark());
    setWarning(m_remark, !m_landmarking.failure().isEmpty());
}

QString LandmarksPanel::remark() const {
    const std::size_t count = m_landmarking.pairs().size();
    const QString failure = m_landmarking.failure();
    if (!failure.isEmpty()) return tr("%1. The photo stays where it is.").arg(failure);
    if (!m_landmarking.layer()) return {};
    if (count < pairsForPose) return tr("%1 of %2 that place the photo").arg(count).arg(pairsForPose);
    const PoseFit* fit = m_landmarking.fit();
    if (!fit) return tr("Looking for the pose…");
    if (fit->focalLength == FocalLength::Assumed)
        return count < pairsForFocalLength
                   ? tr("The focal length is assumed: %1 landmarks tell it").arg(pairsForFocalLength)
                   : tr("The focal length is assumed: these landmarks do not tell it");
    return m_landmarking.isElsewhere() ? tr("The photo was moved from where they place it") : QString();
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
