#include "app/editor/panels/projector_panel.h"

#include "app/editor/commands/angles.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"

namespace esm {

ProjectorPanel::ProjectorPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Projector"), parent), m_document(document), m_selection(selection),
      m_width(new NumberField(lengthFormat(smallestLength), this)),
      m_height(new NumberField(lengthFormat(smallestLength), this)),
      m_position(new VectorField(withoutUnit(lengthFormat(-1000)), this)),
      m_turned(new VectorField(withoutUnit(angleFormat()), this)),
      m_fromCamera(new QPushButton(tr("From &camera"), this)) {
    auto* rows = new ValueRows(this);
    rows->addField(tr("Width"), m_width);
    rows->addField(tr("Height"), m_height);
    rows->addWideField(tr("Position, mm"), m_position);
    rows->addWideField(tr("Turned, °"), m_turned);
    m_width->setObjectName(QStringLiteral("projectorWidth"));
    body()->addWidget(rows);
    body()->addWidget(m_fromCamera, 0, Qt::AlignLeft);

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
    for (NumberField* field : {m_width, m_height})
        connect(field, &NumberField::gestureFinished, &document, &Document::finishGesture);
    for (VectorField* field : {m_position, m_turned})
        connect(field, &VectorField::gestureFinished, &document, &Document::finishGesture);
    connect(&selection, &Selection::changed, this, &ProjectorPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.photos) show();
    });
    show();
}

void ProjectorPanel::show() {
    const auto selected = m_selection.photo();
    const Projector* projector = selected ? &m_document.project().photos[*selected].projector : nullptr;
    const QString why = tr("No photo is selected");
    enable(m_width, projector, tr("Width of the thrown photo"), why);
    enable(m_height, projector, tr("Height of the thrown photo"), why);
    enable(m_position, projector, tr("x, y, z"), why);
    enable(m_turned, projector, turnedToolTip(), why);
    m_width->setValue(projector ? std::optional(projector->width) : std::nullopt);
    m_height->setValue(projector ? std::optional(projector->height) : std::nullopt);
    using Vector = std::optional<Eigen::Vector3d>;
    m_position->setValue(projector ? Vector(projector->pose.translation()) : Vector());
    m_turned->setValue(projector ? Vector(degreesOf(projector->pose.linear())) : Vector());
}

void ProjectorPanel::setFromCameraAction(QAction* action) {
    follow(m_fromCamera, action);
}

void ProjectorPanel::edit(const QString& text, const std::function<void(Projector&)>& change,
                          const QString& mergeKey) {
    const auto selected = m_selection.photo();
    if (selected)
        m_document.edit(
            text, [&](Project& project) { change(project.photos[*selected].projector); },
            QStringLiteral("%1 %2").arg(mergeKey).arg(*selected));
}

} // namespace esm
