#include "app/editor/panels/texture/projector_panel.h"

#include "app/editor/edits/angles.h"
#include "app/editor/edits/photo_edits.h"
#include "core/support/angles.h"
#include "core/texture/texture_limits.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"
#include "widgets/inputs/quantity_formats.h"

#include <algorithm>
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

NumberFormat intrinsicFormat(double minimum) {
    NumberFormat format;
    format.unit = ProjectorPanel::tr("px");
    format.decimals = 1;
    format.minimum = minimum;
    format.maximum = texture_limits::longestFocalLength;
    format.step = 1;
    return format;
}

/// What the panel offers: a camera that was measured is a kind of its own.
enum class Kind { Parallel, Perspective, Measured };

Kind kindOf(const Projector& projector) {
    if (projector.kind == ProjectorKind::Parallel) return Kind::Parallel;
    return projector.intrinsics ? Kind::Measured : Kind::Perspective;
}

PhotoSize sizeOfPicture(const TextureLayer& layer) {
    const Image& picture = *pictureOf(layer);
    return {picture.width, picture.height};
}

double verticalView(const TextureLayer& layer) {
    const Intrinsics camera = intrinsicsOf(layer.projector, sizeOfPicture(layer));
    return toDegrees(2 * std::atan(sizeOfPicture(layer).height / (2 * camera.fy)));
}

/// The picture stays where it lies, as far as the kind can say it.
Projector ofShownKind(Kind kind, const TextureLayer& layer, const TriangleMesh& mesh) {
    const bool isParallel = kind == Kind::Parallel;
    Projector projector = ofKind(isParallel ? ProjectorKind::Parallel : ProjectorKind::Perspective,
                                 layer.projector, layer.photo->image, mesh);
    projector.areIntrinsicsFound = false;
    if (kind == Kind::Measured) projector.intrinsics = intrinsicsOf(projector, sizeOfPicture(layer));
    if (kind == Kind::Perspective && projector.intrinsics) {
        projector.fieldOfView =
            std::clamp(verticalView(layer), texture_limits::narrowestView, texture_limits::widestView);
        projector.intrinsics.reset();
    }
    return projector;
}

} // namespace

ProjectorPanel::ProjectorPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Projector"), parent), m_document(document), m_selection(selection),
      m_kind(new QComboBox(this)), m_width(new NumberField(lengthFormat(smallestLength), this)),
      m_height(new NumberField(lengthFormat(smallestLength), this)),
      m_fieldOfView(new NumberField(viewFormat(), this)), m_keepProportions(new QToolButton(this)),
      m_intrinsics(), m_sizeRows(new ValueRows(this)), m_perspectiveRows(new ValueRows(this)),
      m_measuredRows(new ValueRows(this)), m_size(new QWidget(this)),
      m_position(new VectorField(withoutUnit(lengthFormat(-1000)), this)),
      m_turned(new VectorField(withoutUnit(angleFormat()), this)),
      m_fromCamera(new QPushButton(tr("From &camera"), this)),
      m_lookThrough(new QPushButton(tr("Look through"), this)) {
    layOut();
    connectFields();
    connectIntrinsics();
    connect(&selection, &Selection::changed, this, &ProjectorPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.layers) show();
    });
    show();
}

void ProjectorPanel::layOut() {
    auto* rows = new ValueRows(this);
    auto* kindRows = new ValueRows(this);
    kindRows->addField(tr("&Kind"), m_kind);
    layOutSize();
    m_perspectiveRows->addField(tr("Field of view"), m_fieldOfView);
    const std::array<QString, 4> captions{tr("Focal length x"), tr("Focal length y"), tr("Principal point x"),
                                          tr("Principal point y")};
    for (std::size_t i = 0; i < captions.size(); ++i) {
        m_intrinsics[i] =
            new NumberField(intrinsicFormat(i < 2 ? 1 : -texture_limits::longestFocalLength), this);
        m_intrinsics[i]->setObjectName(QStringLiteral("projectorIntrinsic%1").arg(i));
        m_measuredRows->addField(captions[i], m_intrinsics[i]);
    }
    m_kind->addItem(tr("parallel"), static_cast<int>(Kind::Parallel));
    m_kind->addItem(tr("perspective"), static_cast<int>(Kind::Perspective));
    m_kind->addItem(tr("calibrated camera"), static_cast<int>(Kind::Measured));
    guardFromWheel(*m_kind);
    m_kind->setObjectName(QStringLiteral("projectorKind"));
    m_fieldOfView->setObjectName(QStringLiteral("projectorFieldOfView"));
    m_position->setCaption(tr("Position"));
    m_position->setToolTip(tr("Where the projector stands"));
    m_turned->setCaption(tr("Turned"));
    m_turned->setToolTip(tr("How far the projector is turned about x, y and z"));
    rows->addWideField(tr("Position, mm"), m_position);
    rows->addWideField(tr("Turned, °"), m_turned);
    m_width->setObjectName(QStringLiteral("projectorWidth"));
    for (QWidget* part :
         std::initializer_list<QWidget*>{kindRows, m_size, m_perspectiveRows, m_measuredRows, rows})
        body()->addWidget(part);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_fromCamera);
    buttons->addWidget(m_lookThrough);
    buttons->addStretch();
    body()->addLayout(buttons);
}

/// The lock stands beside both fields that it ties together.
void ProjectorPanel::layOutSize() {
    m_sizeRows->addField(tr("Width"), m_width);
    m_sizeRows->addField(tr("Height"), m_height);
    m_keepProportions->setObjectName(QStringLiteral("keepProportions"));
    m_keepProportions->setIcon(icon(QStringLiteral("lock")));
    m_keepProportions->setAccessibleName(tr("Keep proportions"));
    m_keepProportions->setCheckable(true);
    m_keepProportions->setChecked(true);
    auto* row = new QHBoxLayout(m_size);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_sizeRows, 1);
    row->addWidget(m_keepProportions);
}

void ProjectorPanel::connectFields() {
    connect(m_kind, qOverload<int>(&QComboBox::activated), this, &ProjectorPanel::chooseKind);
    connect(m_fieldOfView, &NumberField::valueEdited, this, [this](double degrees) {
        edit(
            tr("Set field of view"), [=](Projector& projector) { projector.fieldOfView = degrees; },
            EditKind::ProjectorSize);
    });
    connect(m_width, &NumberField::valueEdited, this,
            [this](double width) { resize(&Projector::width, &Projector::height, width); });
    connect(m_height, &NumberField::valueEdited, this,
            [this](double height) { resize(&Projector::height, &Projector::width, height); });
    connect(m_position, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& position) {
        edit(
            tr("Move projector"), [&](Projector& projector) { projector.pose.translation() = position; },
            EditKind::ProjectorPosition);
    });
    connect(m_turned, &VectorField::valueEdited, this, [this](const Eigen::Vector3d& degrees) {
        edit(
            tr("Turn projector"),
            [&](Projector& projector) { projector.pose.linear() = rotationOf(degrees); },
            EditKind::ProjectorTurn);
    });
    for (NumberField* field : {m_width, m_height, m_fieldOfView})
        connect(field, &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    for (VectorField* field : {m_position, m_turned})
        connect(field, &VectorField::gestureFinished, &m_document, &Document::finishGesture);
}

void ProjectorPanel::connectIntrinsics() {
    for (std::size_t i = 0; i < m_intrinsics.size(); ++i) {
        connect(m_intrinsics[i], &NumberField::valueEdited, this, [this, i](double pixels) {
            Intrinsics camera = shownIntrinsics();
            const std::array<double*, 4> values{&camera.fx, &camera.fy, &camera.cx, &camera.cy};
            *values[i] = pixels;
            edit(
                tr("Set calibration"),
                [=](Projector& projector) {
                    projector.intrinsics = camera;
                    projector.areIntrinsicsFound = false;
                },
                EditKind::ProjectorCalibration, i);
        });
        connect(m_intrinsics[i], &NumberField::gestureFinished, &m_document, &Document::finishGesture);
    }
}

void ProjectorPanel::show() {
    const TextureLayer* layer = m_selection.selectedLayer();
    const Projector* projector = layer && layer->photo ? &layer->projector : nullptr;
    const QString why = tr("No photo is selected");
    enable(m_width, projector, tr("Width of the projected photo"), why);
    enable(m_height, projector, tr("Height of the projected photo"), why);
    enable(m_keepProportions, projector,
           tr("Keep proportions: what is set of width or height is set of the other as well"), why);
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
    const Kind kind = projector ? kindOf(*projector) : Kind::Parallel;
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(kind)));
    enable(
        m_kind, projector,
        tr("Projected straight ahead, or from an eye as the camera took it, whose calibration may be known; "
           "the photo stays where it lies"),
        tr("No photo is selected"));
    m_size->setVisible(kind == Kind::Parallel);
    m_perspectiveRows->setVisible(kind == Kind::Perspective);
    m_measuredRows->setVisible(kind == Kind::Measured);
    showCamera(projector);
}

void ProjectorPanel::showCamera(const Projector* projector) {
    const QString why = tr("No photo is selected");
    enable(m_fieldOfView, projector, tr("Vertical angle that the photo spans at the eye"), why);
    m_fieldOfView->setValue(projector ? std::optional(projector->fieldOfView) : std::nullopt);
    const Intrinsics camera = projector ? shownIntrinsics() : Intrinsics{};
    const std::array<double, 4> values{camera.fx, camera.fy, camera.cx, camera.cy};
    for (std::size_t i = 0; i < values.size(); ++i) {
        enable(m_intrinsics[i], projector,
               i < 2 ? tr("In pixels of the photo; landmarks take it as it is")
                     : tr("Where the line of sight meets the photo, pixels from its top left corner"),
               why);
        m_intrinsics[i]->setValue(projector ? std::optional(values[i]) : std::nullopt);
    }
}

void ProjectorPanel::resize(double Projector::*edited, double Projector::*other, double metres) {
    const bool isKept = m_keepProportions->isChecked();
    edit(
        tr("Resize projector"),
        [=](Projector& projector) {
            const double share = metres / projector.*edited;
            projector.*edited = metres;
            if (isKept)
                projector.*other = std::clamp(share * projector.*other, texture_limits::shortestPhoto,
                                              texture_limits::longestPhoto);
        },
        EditKind::ProjectorSize);
}

Intrinsics ProjectorPanel::shownIntrinsics() const {
    const TextureLayer& layer = *m_selection.selectedLayer();
    return intrinsicsOf(layer.projector, sizeOfPicture(layer));
}

void ProjectorPanel::chooseKind() {
    const auto selected = m_selection.photo();
    if (!selected) return;
    const auto kind = static_cast<Kind>(m_kind->currentData().toInt());
    m_document.edit(tr("Choose kind of projector"), [&](Project& project) {
        TextureLayer& layer = partOf(project.layers, *selected);
        if (layer.photo) layer.projector = ofShownKind(kind, layer, *project.mesh);
    });
}

void ProjectorPanel::setFromCameraAction(QAction* action) {
    follow(m_fromCamera, action);
}

void ProjectorPanel::setLookThroughAction(QAction* action) {
    follow(m_lookThrough, action);
}

void ProjectorPanel::edit(const QString& text, const std::function<void(Projector&)>& change, EditKind kind,
                          std::uint64_t place) {
    const auto selected = m_selection.photo();
    if (selected)
        m_document.edit(text, [&](Project& project) { change(partOf(project.layers, *selected).projector); },
                        {kind, *selected, place});
}

} // namespace esm
