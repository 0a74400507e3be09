#include "app/editor/panels/model_panel.h"

#include "widgets/inputs/number_text.h"

namespace esm {

namespace {

NumberFormat massFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("kg");
    format.minimum = 1e-9;
    format.maximum = 1e4;
    return format;
}

/// Three lengths in mm with as many decimals as the largest needs to be read, at most one.
QString millimetres(const Eigen::Vector3d& metres, const QString& between) {
    const Eigen::Vector3d mm = metres * 1000;
    const double largest = mm.cwiseAbs().maxCoeff();
    const int decimals = largest >= 100 ? 0 : largest >= 1 ? 1 : 2;
    return decimalText(mm.x(), decimals) + between + decimalText(mm.y(), decimals) + between +
           decimalText(mm.z(), decimals) + QStringLiteral(" mm");
}

} // namespace

ModelPanel::ModelPanel(Document& document, QWidget* parent)
    : Section(tr("Model"), parent), m_document(document), m_mass(new NumberField(massFormat(), this)) {
    auto* rows = new ValueRows(this);
    m_nodes = rows->addText(tr("Nodes"), QStringLiteral("nodeCount"));
    m_springs = rows->addText(tr("Springs"), QStringLiteral("springCount"));
    m_size = rows->addText(tr("Size"), QStringLiteral("modelSize"));
    m_centre = rows->addText(tr("Centre"), QStringLiteral("modelCentre"));
    m_fixed = rows->addText(tr("Fixed nodes"), QStringLiteral("fixedCount"));
    rows->addField(tr("M&ass"), m_mass);
    m_mass->setAccessibleName(tr("Total mass"));
    m_mass->setToolTip(tr("Total mass, spread evenly over the nodes"));
    m_fixed->setToolTip(tr("Nodes held in space. Model → Fix nodes in region adds some."));
    body()->addWidget(rows);

    connect(m_mass, &NumberField::valueEdited, this, [this](double mass) {
        m_document.edit(tr("Change mass"), [mass](Project& project) { project.base.mass = mass; });
    });
    connect(&document, &Document::changed, this, &ModelPanel::show);
    show(Change::everything());
}

void ModelPanel::show(const Change& change) {
    if (change.mesh) showMesh();
    if (change.tissue || change.mesh) m_mass->setValue(m_document.project().base.mass);
    if (change.scene || change.mesh)
        m_fixed->setText(countText(evaluateModel(m_document.project()).fixedNodes.size()));
}

void ModelPanel::showMesh() {
    const Project& project = m_document.project();
    const auto box = boundingBox(project.network->restPositions);
    m_nodes->setText(countText(project.network->restPositions.size()));
    m_springs->setText(countText(project.network->springs.size()));
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
