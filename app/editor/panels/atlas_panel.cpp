#include "app/editor/panels/atlas_panel.h"

#include "app/editor/commands/attempt.h"
#include "app/editor/commands/long_work.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

namespace esm {

AtlasPanel::AtlasPanel(Document& document, QWidget* parent)
    : Section(tr("Atlas"), parent), m_document(document), m_size(new QComboBox(this)),
      m_layout(new QComboBox(this)) {
    for (const int size : {512, 1024, 2048, 4096, 8192})
        m_size->addItem(tr("%1 × %1").arg(size), size);
    m_layout->addItem(tr("rows"), static_cast<int>(AtlasLayout::Rows));
    m_layout->addItem(tr("matched rows"), static_cast<int>(AtlasLayout::MatchedRows));
    m_layout->addItem(tr("unfolded groups"), static_cast<int>(AtlasLayout::UnfoldedGroups));
    for (QComboBox* choice : {m_size, m_layout})
        guardFromWheel(*choice);
    m_size->setObjectName(QStringLiteral("atlasSize"));
    m_layout->setObjectName(QStringLiteral("atlasLayout"));
    auto* rows = new ValueRows(this);
    rows->addField(tr("Si&ze"), m_size);
    rows->addField(tr("La&yout"), m_layout);
    m_used = rows->addText(tr("Used"), QStringLiteral("atlasUsed"));
    m_texel = rows->addText(tr("Texel"), QStringLiteral("atlasTexel"));
    m_seams = rows->addText(tr("Seams"), QStringLiteral("atlasSeams"));
    m_used->setToolTip(tr("Part of the texture that triangles cover"));
    m_texel->setToolTip(tr("Length on the organ of one pixel of the texture"));
    m_seams->setToolTip(tr("Part of the edges whose triangles lie apart in the texture"));
    body()->addWidget(rows);

    for (QComboBox* choice : {m_size, m_layout})
        connect(choice, qOverload<int>(&QComboBox::activated), this, &AtlasPanel::pack);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.texture || change.mesh) show();
    });
    show();
}

void AtlasPanel::show() {
    const Project& project = m_document.project();
    const auto& [size, pages, gap, layout, density] = project.texture.atlas;
    if (m_size->findData(size) < 0) m_size->addItem(tr("%1 × %1").arg(size), size);
    m_size->setCurrentIndex(m_size->findData(size));
    m_layout->setCurrentIndex(m_layout->findData(static_cast<int>(layout)));
    const QString noSurface = tr("This model has no surface to lay a texture on");
    const bool hasSurface = !project.mesh->triangles.empty();
    enable(m_size, hasSurface, tr("Size of the texture in pixels"), noSurface);
    enable(m_layout, hasSurface,
           tr("How the triangles lie side by side: matched rows use most of the texture, unfolded "
              "groups have the fewest seams"),
           noSurface);
    const Atlas* atlas = project.atlas.get();
    m_used->setText(atlas ? tr("%1 %").arg(qRound(atlas->utilisation * 100)) : tr("not packed"));
    m_texel->setText(atlas ? tr("%1 mm").arg(numberText(1000 / atlas->texelsPerMetre, 2))
                           : QString(QChar(0x2013)));
    m_seams->setText(atlas ? tr("%1 % of edges").arg(qRound(100 * seamShare(*project.mesh, *atlas)))
                           : QString(QChar(0x2013)));
}

void AtlasPanel::pack() {
    const AtlasOptions& before = m_document.project().texture.atlas;
    AtlasOptions options = before;
    options.size = m_size->currentData().toInt();
    options.layout = static_cast<AtlasLayout>(m_layout->currentData().toInt());
    const bool isSame = options.size == before.size && options.layout == before.layout;
    if (isSame && m_document.project().atlas) return;
    const auto mesh = m_document.project().mesh;
    attempt(window(), tr("The texture cannot be packed so"), [&] {
        auto atlas = std::make_shared<const Atlas>(computeLong(
            window(), tr("Packing the texture"), [&](const Progress&) { return packAtlas(*mesh, options); }));
        m_document.edit(tr("Pack the texture"), [&](Project& project) {
            project.texture.atlas = atlas->options;
            project.atlas = atlas;
        });
    });
    show();
}

} // namespace esm
