#include "app/editor/tools/fix_panel.h"

#include "app/editor/tools/fix_tool.h"
#include "app/editor/tools/size_keys.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"

#include <algorithm>

namespace esm {

FixPanel::FixPanel(FixTool& tool, Document& document, QWidget* parent)
    : Section(tr("Fixed nodes"), parent), m_tool(tool), m_document(document),
      m_radius(new NumberField(lengthFormat(smallestLength), this)) {
    auto* rows = new ValueRows(this);
    rows->addField(tr("Radius"), m_radius);
    m_count = rows->addText(tr("Fixed nodes"), QStringLiteral("fixedCount"));
    m_radius->setObjectName(QStringLiteral("fixRadius"));
    m_radius->setToolTip(tr("Around the mouse, on the organ at rest; [ and ] make it smaller and larger"));
    body()->addWidget(rows);
    connect(m_radius, &NumberField::valueEdited, &tool, &FixTool::setRadius);
    sizeByBrackets(*this, [this](double factor) {
        m_tool.setRadius(std::max(factor * m_tool.radius(), smallestLength));
    });
    connect(&tool, &FixTool::changed, this, &FixPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.scene) show();
    });
    show();
}

void FixPanel::show() {
    const Project& project = m_document.project();
    NumberFormat radius = m_radius->format();
    radius.maximum = m_tool.largestRadius();
    m_radius->setFormat(radius);
    m_radius->setValue(m_tool.radius());
    m_count->setText(countText(fixedNodesOf(*project.network, project.scene).size()));
}

} // namespace esm
