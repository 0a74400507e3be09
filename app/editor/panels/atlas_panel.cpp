#include "app/editor/panels/atlas_panel.h"

#include "app/editor/commands/attempt.h"
#include "app/editor/commands/long_work.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

namespace esm {

AtlasPanel::AtlasPanel(Document& document, QWidget* parent)
    : Section(tr("Atlas"), parent), m_document(document), m_size(new QComboBox(this)) {
    for (const int size : {512, 1024, 2048, 4096, 8192})
        m_size->addItem(tr("%1 × %1").arg(size), size);
    guardFromWheel(*m_size);
    m_size->setObjectName(QStringLiteral("atlasSize"));
    auto* rows = new ValueRows(this);
    rows->addField(tr("Si&ze"), m_size);
    m_used = rows->addText(tr("Used"), QStringLiteral("atlasUsed"));
    m_texel = rows->addText(tr("Texel"), QStringLiteral("atlasTexel"));
    m_used->setToolTip(tr("Part of the texture that triangles cover"));
    m_texel->setToolTip(tr("Length on the organ of one pixel of the texture"));
    body()->addWidget(rows);

    connect(m_size, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { pack(m_size->itemData(index).toInt()); });
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.texture || change.mesh) show();
    });
    show();
}

void AtlasPanel::show() {
    const Project& project = m_document.project();
    const int size = project.texture.atlas.size;
    if (m_size->findData(size) < 0) m_size->addItem(tr("%1 × %1").arg(size), size);
    m_size->setCurrentIndex(m_size->findData(size));
    enable(m_size, !project.mesh->triangles.empty(), tr("Size of the texture in pixels"),
           tr("This model has no surface to lay a texture on"));
    const Atlas* atlas = project.atlas.get();
    m_used->setText(atlas ? tr("%1 %").arg(qRound(atlas->utilisation * 100)) : tr("not packed"));
    m_texel->setText(atlas ? tr("%1 mm").arg(numberText(1000 / atlas->texelsPerMetre, 2))
                           : QString(QChar(0x2013)));
}

void AtlasPanel::pack(int size) {
    if (size == m_document.project().texture.atlas.size && m_document.project().atlas) return;
    AtlasOptions options = m_document.project().texture.atlas;
    options.size = size;
    const auto mesh = m_document.project().mesh;
    attempt(window(), tr("The texture cannot have this size"), [&] {
        auto atlas = std::make_shared<const Atlas>(computeLong(
            window(), tr("Packing the texture"), [&](const Progress&) { return packAtlas(*mesh, options); }));
        m_document.edit(tr("Change texture size"), [&](Project& project) {
            project.texture.atlas = options;
            project.atlas = atlas;
        });
    });
    show();
}

} // namespace esm
