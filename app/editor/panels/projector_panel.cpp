#include "app/editor/panels/projector_panel.h"

#include "app/editor/commands/angles.h"
#include "app/editor/commands/photo_edits.h"
#include "core/support/angles.h"
#include "core/texture/texture_limits.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"

#include <cmath>

namespace esm {

namespace {

NumberFormat viewFormat() {
    NumberFormat format = angleFormat();
    format.decimals = 1;
    format.minimum = texture_limits::narrowestView;
    format.maximum = texture_limits::widestView;
    return format;
}

} // namespace

ProjectorPanel::ProjectorPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Projector"), parent), m_document(document), m_selection(selection),
      m_kind(new QComboBox(this)), m_width(new NumberField(lengthFormat(smallestLength), this)),
      m_height(new NumberField(lengthFormat(smallestLength), this)),
      m_fieldOfView(new NumberField(viewFormat(), this)), m_parallelRows(new ValueRows(this)),
      m_perspectiveRows(new ValueRows(this)),
      m_position(new VectorField(withoutUnit(lengthFormat(-1000)), this)),
      m_turned(new VectorField(withoutUnit(angleFormat()), this)),
      m_fromCamera(new QPushButton(tr("From &camera"), this)) {
    auto* rows = new ValueRows(this);
    auto* kindRows = new ValueRows(this);
    kindRows->addField(tr("&Kind"), m_kind);
    m_parallelRows->addField(tr("Width"), m_width);
    m_parallelRows->addField(tr("Height"), m_height);
    m_perspectiveRows->addField(tr("Field of view"), m_fieldOfView);
    m_kind->addItem(tr("parallel"), static_cast<int>(ProjectorKind::Parallel));
    m_kind->addItem(tr("perspective"), static_cast<int>(ProjectorKind::Perspective));
    guardFromWheel(*m_kind);
    m_kind->setObjectName(QStringLiteral("projectorKind"));
    m_fieldOfView->setObjectName(QStringLiteral("projectorFieldOfView"));
    rows->addWideField(tr("Position, mm"), m_position);
    rows->addWideField(tr("Turned, °"), m_turned);
    m_width->setObjectName(QStringLiteral("projectorWidth"));
    for (QWidget* part : {kindRows, m_parallelRows, m_perspectiveRows, rows})
        body()->addWidget(part);
    body()->addWidget(m_fromCamera, 0, Qt::AlignLeft);

    connect(m_kind, qOverload<int>(&QComboBox::activated), this, &ProjectorPanel::chooseKind);
    connect(m_fieldOfView, &NumberField::valueEdited, this, [this](double degrees) {
        edit(
            tr("Set field of view"),
            [=](Projector& projector) {
                projector.intrinsics.reset();
                projector.fieldOfView = degrees;
            },
            QStringLiteral("projector size"));
    });
    connect(m_width, &NumberField::valueEdited, this, [this](double width) {
        edit(
            tr("Resize projector"), [=](Projector& projector) { projector.width = width; },
            QStringLiteral("projector size"));
    });
    connect(m_height, &NumberField::valueEdited, this, [this](double height) {
        edit(
            tr("Resize projector"), [=](Projector& projector) { projector.height = height; },
            QStringLiteral("projector size"));
    });
    connect(m_position, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& position) {
        edit(
            tr("Move projector"), [&](Projector& projector) { projector.pose.translation() = position; },
            QStringLiteral("projector position"));
    });
    connect(m_turned, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& degrees) {
        edit(
            tr("Turn projector"),
            [&](Projector& projector) { projector.pose.linear() = rotationOf(degrees); },
            QStringLiteral("projector turn"));
    });
    for (NumberField* field : {m_width, m_height, m_fieldOfView})
        connect(field, &NumberField::gestureFinished, &document, &Document::finishGesture);
    for (VectorField* field : {m_position, m_turned})
        connect(field, &VectorField::gestureFinished, &document, &Document::finishGesture);
    connect(&selection, &Selection::changed, this, &ProjectorPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.layers) show();
    });
    show();
}

void ProjectorPanel::show() {
    const auto selected = m_selection.photo();
    const TextureLayer* layer = selected ? &m_document.project().layers[*selected] : nullptr;
    const Projector* projector = layer && layer->photo ? &layer->projector : nullptr;
    const QString why = tr("No photo is selected");
    enable(m_width, projector, tr("Width of the thrown photo"), why);
    enable(m_height, projector, tr("Height of the thrown photo"), why);
    enable(m_position, projector, tr("x, y, z"), why);
    enable(m_turned, projector, turnedToolTip(), why);
    showKind(projector);
    m_width->setValue(projector ? std::optional(projector->width) : std::nullopt);
    m_height->setValue(projector ? std::optional(projector->height) : std::nullopt);
    using Vector = std::optional<Eigen::Vector3d>;
    m_position->setValue(projector ? Vector(projector->pose.translation()) : Vector());
    m_turned->setValue(projector ? Vector(degreesOf(projector->pose.linear())) : Vector());
}

void ProjectorPanel::showKind(const Projector* projector) {
    const QString why = tr("No photo is selected");
    const ProjectorKind kind = projector ? projector->kind : ProjectorKind::Parallel;
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(kind)));
    enable(m_kind, projector,
           tr("Thrown straight ahead, or from an eye as the camera took it; the photo stays where it lies"),
           why);
    m_parallelRows->setVisible(kind == ProjectorKind::Parallel);
    m_perspectiveRows->setVisible(kind == ProjectorKind::Perspective);
    const bool isMeasured = projector && projector->intrinsics;
    enable(m_fieldOfView, projector,
           isMeasured ? tr("Vertical; the camera was measured, which a typed value replaces")
                      : tr("Vertical angle that the photo spans at the eye"),
           why);
    m_fieldOfView->setValue(projector ? std::optional(verticalFieldOfView()) : std::nullopt);
}

/// Degrees; of measured intrinsics, what they come to.
double ProjectorPanel::verticalFieldOfView() const {
    const TextureLayer& layer = m_document.project().layers[*m_selection.photo()];
    const Image& photo = layer.photo->image;
    if (!layer.projector.intrinsics) return layer.projector.fieldOfView;
    return toDegrees(2 * std::atan(photo.height / (2 * layer.projector.intrinsics->fy)));
}

void ProjectorPanel::chooseKind() {
    const auto selected = m_selection.photo();
    if (!selected) return;
    const auto kind = static_cast<ProjectorKind>(m_kind->currentData().toInt());
    m_document.edit(tr("Choose kind of projector"), [&](Project& project) {
        TextureLayer& layer = project.layers[*selected];
        if (!layer.photo) return;
        layer.projector = ofKind(kind, layer.projector, layer.photo->image, *project.mesh);
    });
}

void ProjectorPanel::setFromCameraAction(QAction* action) {
    follow(m_fromCamera, action);
}

void ProjectorPanel::edit(const QString& text, const std::function<void(Projector&)>& change,
                          const QString& mergeKey) {
    const auto selected = m_selection.photo();
    if (selected)
        m_document.edit(
            text, [&](Project& project) { change(project.layers[*selected].projector); },
            QStringLiteral("%1 %2").arg(mergeKey).arg(*selected));
}

} // namespace esm
