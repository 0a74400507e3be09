#include "app/editor/panels/texture/atlas_panel.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/sentence.h"
#include "core/support/errors.h"
#include "core/texture/atlas/distortion.h"
#include "core/texture/atlas/own_layout.h"
#include "core/texture/texture_limits.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

#include <QMessageBox>
#include <QPushButton>
#include <QStandardItemModel>

namespace esm {

namespace {

/// The length on the organ of a pixel of the texture, m, shown in mm.
NumberFormat texelFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("mm");
    format.shownPerValue = 1000;
    format.minimum = 1 / texture_limits::mostTexelsPerMetre;
    format.maximum = 1;
    return format;
}

QString distortionText(const TriangleMesh& mesh, const Atlas& atlas) {
    if (!isStretched(atlas.options.layout)) return QObject::tr("none");
    const DistortionSpread angle = distortionOf(mesh, atlas).angle;
    return QObject::tr("%1, up to %2").arg(angle.mean, 0, 'f', 2).arg(angle.percentile95, 0, 'f', 2);
}

QString seamText(const TriangleMesh& mesh, const Atlas& atlas) {
    const double percent = 100 * seamShare(mesh, atlas);
    return QObject::tr("%1 % of edges").arg(decimalText(percent, percent < 10 ? 1 : 0));
}

bool mayPackAnew(QWidget& window, const std::string& problem) {
    return ask(window, [&] {
        QMessageBox box(QMessageBox::Question, QObject::tr("The mesh's own layout"),
                        QObject::tr("The mesh's own layout cannot be painted."), QMessageBox::Cancel,
                        &window);
        setUpBox(box, "ownLayoutBox");
        box.setInformativeText(
            QObject::tr("%1.\nPacked in matched rows, every triangle gets a place of its own.")
                .arg(sentence(problem)));
        QPushButton* repack = box.addButton(QObject::tr("&Pack in matched rows"), QMessageBox::AcceptRole);
        box.setDefaultButton(repack);
        box.exec();
        return box.clickedButton() == repack;
    });
}

} // namespace

AtlasPanel::AtlasPanel(Document& document, QWidget* parent)
    : Section(tr("Atlas"), parent), m_document(document), m_size(new QComboBox(this)),
      m_layout(new QComboBox(this)), m_texel(new NumberField(texelFormat(), this)),
      m_fills(new QCheckBox(tr("As fine as the pages allow"), this)), m_flaws(new QLabel(this)) {
    for (const int size : {512, 1024, 2048, 4096, 8192})
        m_size->addItem(tr("%1 × %1").arg(size), size);
    m_layout->addItem(tr("rows"), static_cast<int>(AtlasLayout::Rows));
    m_layout->addItem(tr("matched rows"), static_cast<int>(AtlasLayout::MatchedRows));
    m_layout->addItem(tr("unfolded groups"), static_cast<int>(AtlasLayout::UnfoldedGroups));
    m_layout->addItem(tr("charts"), static_cast<int>(AtlasLayout::Charts));
    m_layout->setItemData(m_layout->count() - 1, tr("Few seams; triangles are stretched a little"),
                          Qt::ToolTipRole);
    m_layout->addItem(tr("the mesh's own"), static_cast<int>(AtlasLayout::Own));
    for (QComboBox* choice : {m_size, m_layout})
        guardFromWheel(*choice);
    m_size->setObjectName(QStringLiteral("atlasSize"));
    m_layout->setObjectName(QStringLiteral("atlasLayout"));
    m_texel->setObjectName(QStringLiteral("atlasTexel"));
    m_fills->setObjectName(QStringLiteral("atlasFills"));
    auto* rows = new ValueRows(this);
    rows->addField(tr("Si&ze"), m_size);
    rows->addField(tr("La&yout"), m_layout);
    rows->addField(tr("Pi&xel"), m_texel);
    auto* results = new ValueRows(this);
    m_pages = results->addText(tr("Pages"), QStringLiteral("atlasPages"));
    m_used = results->addText(tr("Used"), QStringLiteral("atlasUsed"));
    m_seams = results->addText(tr("Seams"), QStringLiteral("atlasSeams"));
    m_distortion = results->addText(tr("Distortion"), QStringLiteral("atlasDistortion"));
    m_pages->setToolTip(tr("Pictures that the texture takes, each of the size above"));
    m_used->setToolTip(tr("Part of the texture that triangles cover"));
    m_seams->setToolTip(tr("Part of the edges whose triangles lie apart in the texture"));
    m_distortion->setToolTip(
        tr("How much longer the texture makes triangles one way than the other: on average, and what 95 % of "
           "the surface stays under"));
    m_flaws->setObjectName(QStringLiteral("atlasFlaws"));
    m_flaws->setProperty("warning", true);
    m_flaws->setWordWrap(true);
    for (QWidget* part : std::initializer_list<QWidget*>{rows, m_fills, results, m_flaws})
        body()->addWidget(part);
    connectControls();
    show();
}

void AtlasPanel::connectControls() {
    connect(m_size, qOverload<int>(&QComboBox::activated), this, [this] {
        AtlasOptions options = m_document.project().texture.atlas;
        options.size = m_size->currentData().toInt();
        pack(options);
    });
    connect(m_layout, qOverload<int>(&QComboBox::activated), this, [this] {
        AtlasOptions options = m_document.project().texture.atlas;
        options.layout = static_cast<AtlasLayout>(m_layout->currentData().toInt());
        if (options.layout == AtlasLayout::Own)
            packAsOwn();
        else
            pack(options);
    });
    connect(m_texel, &NumberField::valueEdited, this, [this](double metres) {
        AtlasOptions options = m_document.project().texture.atlas;
        options.texelsPerMetre = 1 / metres;
        pack(options);
    });
    connect(m_fills, &QCheckBox::clicked, this, &AtlasPanel::fill);
    connect(&m_document, &Document::changed, this, [this](const Change& change) {
        if (change.texture || change.mesh) show();
    });
}

/// From a texel that is asked for back to one page, which is filled; or the texel that there is from now on.
void AtlasPanel::fill(bool on) {
    const Project& project = m_document.project();
    AtlasOptions options = project.texture.atlas;
    if (on) options.pages = 1;
    options.texelsPerMetre = on || !project.atlas ? 0 : project.atlas->texelsPerMetre;
    pack(options);
}

void AtlasPanel::show() {
    const Project& project = m_document.project();
    const AtlasOptions& asked = project.texture.atlas;
    const int size = asked.size;
    if (m_size->findData(size) < 0) m_size->addItem(tr("%1 × %1").arg(size), size);
    m_size->setCurrentIndex(m_size->findData(size));
    m_layout->setCurrentIndex(m_layout->findData(static_cast<int>(asked.layout)));
    const QString unknown(QChar(0x2013));
    const Atlas* atlas = project.atlas.get();
    m_texel->setValue(atlas ? std::optional(1 / atlas->texelsPerMetre) : std::nullopt);
    m_fills->setChecked(!(asked.texelsPerMetre > 0));
    m_pages->setText(atlas ? QString::number(atlas->options.pages) : unknown);
    m_used->setText(atlas ? tr("%1 %").arg(qRound(atlas->utilisation * 100)) : tr("not packed"));
    if (m_measured != project.atlas || !atlas) showMeasured();
    showUse();
}

void AtlasPanel::showMeasured() {
    const Project& project = m_document.project();
    const QString unknown(QChar(0x2013));
    m_measured = project.atlas;
    m_seams->setText(m_measured ? seamText(*project.mesh, *m_measured) : unknown);
    m_distortion->setText(m_measured ? distortionText(*project.mesh, *m_measured) : unknown);
    QStringList flaws;
    if (m_measured && m_measured->options.layout == AtlasLayout::Own)
        for (const std::string& warning : ownLayoutWarnings(*project.mesh))
            flaws.append(sentence(warning));
    m_flaws->setText(flaws.join('\n'));
    m_flaws->setVisible(!flaws.isEmpty());
}

void AtlasPanel::showUse() {
    const QString noSurface = tr("This model has no surface to lay a texture on");
    const bool hasSurface = !m_document.project().mesh->triangles.empty();
    enable(m_size, hasSurface, tr("Size of a page of the texture in pixels"), noSurface);
    enable(
        m_layout, hasSurface,
        tr("How the triangles lie side by side: matched rows use most of the texture, unfolded groups have "
           "fewer seams, charts still fewer but stretch triangles a little; the mesh's own is where its file "
           "has them, stretched as its maker left them"),
        noSurface);
    const bool hasOwn = !m_document.project().mesh->textureCoordinates.empty();
    const int ownPlace = m_layout->findData(static_cast<int>(AtlasLayout::Own));
    qobject_cast<QStandardItemModel*>(m_layout->model())->item(ownPlace)->setEnabled(hasOwn);
    m_layout->setItemData(ownPlace,
                          hasOwn ? tr("By the texture coordinates that the mesh's file has, stretched as its "
                                      "maker left them")
                                 : tr("The mesh brought no texture coordinates"),
                          Qt::ToolTipRole);
    const bool isOwn = m_document.project().texture.atlas.layout == AtlasLayout::Own;
    const QString ownDensity =
        tr("The mesh's own layout fills one page, whose size says how large pixels are");
    enable(
        m_texel, hasSurface && !isOwn,
        tr("Length on the organ of one pixel of the texture; type the one that you need, and as many pages "
           "are made as it takes"),
        isOwn ? ownDensity : noSurface);
    const bool isPacked = m_document.project().atlas != nullptr;
    enable(m_fills, hasSurface && isPacked && !isOwn,
           tr("Fill one page, however small its pixels come to be; otherwise their size stays and the pages "
              "follow"),
           !hasSurface ? noSurface
           : isOwn     ? ownDensity
                       : tr("The texture is not packed yet"));
}

void AtlasPanel::pack(const AtlasOptions& options) {
    const Project& project = m_document.project();
    if (options != project.texture.atlas || !project.atlas) packAs(options);
    show();
}

/// What keeps the mesh's own layout from being painted is said, and another one offered, with the pages and
/// the pixels that were asked for before.
void AtlasPanel::packAsOwn() {
    AtlasOptions options = m_document.project().texture.atlas;
    const auto mesh = m_document.project().mesh;
    attempt(window(), tr("The texture cannot be packed"), [&] {
        const std::vector<std::string> problems = computeLong(
            window(), tr("Packing the texture"), [&](const Progress&) { return ownLayoutProblems(*mesh); });
        if (problems.empty()) {
            options.pages = 1;
            options.texelsPerMetre = 0;
        }
        options.layout = problems.empty() ? AtlasLayout::Own : AtlasLayout::MatchedRows;
        if (problems.empty() || mayPackAnew(*window(), InvalidModel(problems).what())) pack(options);
    });
    show();
}

void AtlasPanel::packAs(const AtlasOptions& options) {
    const auto mesh = m_document.project().mesh;
    attempt(window(), tr("The texture cannot be packed"), [&] {
        auto atlas = std::make_shared<const Atlas>(computeLong(
            window(), tr("Packing the texture"),
            [&](const Progress& progress) { return packAtlas(*mesh, options, progress); },
            Cancelling::Offered));
        const QString layout = m_layout->itemText(m_layout->findData(static_cast<int>(options.layout)));
        m_document.edit(tr("Pack the texture: %1").arg(layout), [&](Project& edited) {
            edited.texture.atlas = atlas->options;
            edited.atlas = atlas;
        });
    });
}

} // namespace esm
