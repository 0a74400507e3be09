#include "app/editor/panels/organ/model_panel.h"

#include "app/editor/dialogs/thin_wall_text.h"
#include "app/editor/panels/parameter_row.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"

#include <numeric>

namespace esm {

namespace {

/// Three lengths in mm with as many decimals as the largest needs to be read, at most one.
QString millimetres(const Eigen::Vector3d& metres, const QString& between) {
    const Eigen::Vector3d mm = metres * 1000;
    const double largest = mm.cwiseAbs().maxCoeff();
    const int decimals = largest >= 100 ? 0 : largest >= 1 ? 1 : 2;
    return decimalText(mm.x(), decimals) + between + decimalText(mm.y(), decimals) + between +
           decimalText(mm.z(), decimals) + QStringLiteral(" mm");
}

/// How the simulated nodes move what is drawn.
QString carryingText(const Detail& detail) {
    const Detail::Kind kind = detail.kind;
    if (kind == Detail::Kind::Nodes)
        return QObject::tr("Fewer nodes are simulated and carry the full surface");
    if (detail.filling && isWall(*detail.filling))
        return QObject::tr("A wall of prisms lies beneath the surface; every vertex is a node");
    if (kind == Detail::Kind::Filled) return QObject::tr("A lattice fills the body and carries the surface");
    if (kind == Detail::Kind::Rigid) return QObject::tr("A few springs move the surface as one stiff piece");
    return QObject::tr("Every vertex is a node");
}

/// @param isThinner whether a wall often is than asked for
QString insideText(const Detail& detail, bool isThinner) {
    if (!detail.filling) return QObject::tr("hollow");
    if (isWall(*detail.filling))
        return (isThinner ? QObject::tr("wall, up to %1 mm") : QObject::tr("wall, %1 mm"))
            .arg(numberText(1000 * detail.filling->wallThickness, 2));
    return QObject::tr("solid, %1 mm apart").arg(numberText(1000 * detail.filling->spacing, 2));
}

/// How nodes are fixed where none is, and freed where some are.
QString fixingText(const TissueModel& model) {
    if (!model.fixedNodes.empty()) return QObject::tr("Model → Free all fixed nodes lets them go.");
    return model.tethers.empty()
               ? QObject::tr("Nothing holds the organ. The tool Fix nodes holds parts of it.")
               : QObject::tr("Tethers hold the organ. The tool Fix nodes holds parts of it.");
}

} // namespace

ModelPanel::ModelPanel(Document& document, Preview& preview, QWidget* parent)
    : Section(tr("Model"), parent), m_document(document), m_preview(preview),
      m_baseMass(new NumberField(massFormat(), this)) {
    auto* rows = new ValueRows(this);
    m_nodes = rows->addText(tr("Nodes"), QStringLiteral("nodeCount"));
    m_springs = rows->addText(tr("Springs"), QStringLiteral("springCount"));
    m_vertices = rows->addText(tr("Vertices drawn"), QStringLiteral("vertexCount"));
    m_inside = rows->addText(tr("Inside"), QStringLiteral("modelInside"));
    m_size = rows->addText(tr("Size"), QStringLiteral("modelSize"));
    m_centre = rows->addText(tr("Centre"), QStringLiteral("modelCentre"));
    m_fixed = rows->addText(tr("Fixed nodes"), QStringLiteral("fixedCount"));
    m_totalMass = rows->addText(tr("Total mass"), QStringLiteral("totalMass"));
    rows->addField(tr("B&ase mass"), m_baseMass);
    m_totalMass->setToolTip(tr("Mass of all nodes, with what the regions set"));
    m_baseMass->setAccessibleName(tr("Base mass"));
    m_baseMass->setToolTip(tr("Spread evenly over the nodes, before the regions set theirs"));
    m_fixed->setToolTip(tr("Nodes held in space: the white dots with a dark edge in the picture"));
    body()->addWidget(rows);
    m_fixing = new QLabel(this);
    m_fixing->setObjectName(QStringLiteral("fixing"));
    m_fixing->setProperty("quiet", true);
    m_fixing->setWordWrap(true);
    m_fixing->ensurePolished(); // the style's font is the one to be measured
    m_fixing->setFixedHeight(2 * m_fixing->fontMetrics().lineSpacing() + 2);
    m_fixing->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    body()->addWidget(m_fixing);

    connect(m_baseMass, &NumberField::valueEdited, this, [this](double mass) {
        m_document.edit(
            tr("Set %1").arg(parameterName(Parameter::Mass, Extent::Base)),
            [mass](Project& project) { project.base.mass = mass; },
            MergeKey(EditKind::BaseTissue, static_cast<std::uint64_t>(Parameter::Mass)));
    });
    connect(m_baseMass, &NumberField::gestureFinished, &document, &Document::finishGesture);
    connect(&document, &Document::changed, this, &ModelPanel::show);
    connect(&preview, &Preview::tissueReady, this, &ModelPanel::showTissue);
    show(Change::everything());
    showTissue(); // it may have been ready before there was a panel
}

void ModelPanel::show(const Change& change) {
    if (change.mesh) showMesh();
    if (change.tissue || change.mesh) m_baseMass->setValue(m_document.project().base.mass);
}

void ModelPanel::showTissue() {
    const std::shared_ptr<const TissueModel> tissue = m_preview.tissue();
    if (!tissue) return;
    const double mass = std::accumulate(tissue->mass.begin(), tissue->mass.end(), 0.0);
    m_totalMass->setText(tr("%1 kg").arg(numberText(mass)));
    m_fixed->setText(countText(tissue->fixedNodes.size()));
    m_fixing->setText(fixingText(*tissue));
}

void ModelPanel::showMesh() {
    const Project& project = m_document.project();
    const auto box = organBox(*project.mesh, *project.network);
    m_nodes->setText(countText(project.network->restPositions.size()));
    m_springs->setText(countText(project.network->springs.size()));
    m_vertices->setText(countText(project.mesh->vertices.size()));
    m_vertices->setToolTip(carryingText(detailOf(*project.network)));
    const QString thin = thinWallWarning(project);
    m_inside->setText(insideText(detailOf(*project.network), !thin.isEmpty()));
    m_inside->setToolTip((thin + ' ' + tr("Model → Inside… chooses what fills the organ")).trimmed());
    m_size->setText(millimetres(box.sizes(), QStringLiteral(" × ")));
    m_centre->setText(millimetres(box.center(), QStringLiteral(", ")));
    const QString warnings = [&] {
        QStringList lines;
        for (const auto& warning : project.importReport->warnings)
            lines << QString::fromStdString(warning);
        return lines.join('\n');
    }();
    m_nodes->setToolTip(warnings.isEmpty() ? tr("Nodes of the spring network") : warnings);
}

} // namespace esm
