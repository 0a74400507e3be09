#include "app/editor/panels/texture/white_page.h"

#include "app/editor/panels/texture/page_row.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quiet_label.h"

#include <QSignalBlocker>

namespace esm {

WhitePage::WhitePage(Document& document, PreparationEdits& edits, QWidget* parent)
    : QWidget(parent), m_document(document), m_edits(edits), m_find(new QPushButton(tr("&Find"), this)),
      m_take(new QPushButton(tr("&Take over"), this)), m_none(new QPushButton(tr("&Not balanced"), this)),
      m_others(new QComboBox(this)) {
    m_find->setObjectName(QStringLiteral("findWhite"));
    m_find->setToolTip(tr("By the lamp's mirror images, or an instrument or drape"));
    m_take->setObjectName(QStringLiteral("whiteLike"));
    m_others->setObjectName(QStringLiteral("whiteOthers"));
    m_others->setToolTip(tr("Photo whose tissue has the right colour"));
    m_others->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_others->setMinimumContentsLength(16);
    guardFromWheel(*m_others);
    QHBoxLayout* row = pageRow(this);
    for (QPushButton* button : {m_find, m_take, m_none})
        button->setAutoDefault(false);
    row->addWidget(m_find);
    row->addWidget(quietLabel(tr("&As in"), this, m_others));
    row->addWidget(m_others);
    row->addWidget(m_take);
    row->addWidget(m_none);
    row->addStretch();
    connect(m_find, &QPushButton::clicked, this, [this] {
        m_edits.edit(tr("Balance white"), [](PreparationWish& wish) {
            wish.preparation.whiteBalance.reset();
            wish.find.whiteBalance = true;
        });
    });
    connect(m_take, &QPushButton::clicked, this, &WhitePage::takeFromAnother);
    connect(m_none, &QPushButton::clicked, this, [this] {
        m_edits.edit(tr("Undo white balance"),
                     [](PreparationWish& wish) { wish.preparation.whiteBalance.reset(); });
    });
}

void WhitePage::pick(const Eigen::Vector2d& place) {
    m_edits.edit(tr("Balance white by a spot"), [=](PreparationWish& wish) { wish.find.whiteSpot = place; });
}

void WhitePage::takeFromAnother() {
    const LayerId id{m_others->currentData().toUInt()};
    const TextureLayer* other = findPart(m_document.project().layers, id);
    if (!other) return;
    const std::shared_ptr<const Image> picture = pictureOf(*other);
    m_edits.edit(tr("Balance white as in another photo"),
                 [=](PreparationWish& wish) { wish.find.whiteLike = picture; });
}

void WhitePage::showBalance() {
    const QSignalBlocker quiet(m_others);
    const QVariant chosen = m_others->currentData();
    m_others->clear();
    const TextureLayer* shown = m_edits.layer();
    for (const TextureLayer& layer : m_document.project().layers)
        if (layer.photo && shown && layer.id != shown->id)
            m_others->addItem(QString::fromStdString(layer.name), layer.id.number);
    m_others->setCurrentIndex(std::max(0, m_others->findData(chosen)));
    const bool isBalanced = m_edits.wanted().preparation.whiteBalance.has_value();
    enable(m_take, m_others->count() > 0, tr("Give its tissue the colour that it has in another photo"),
           tr("There is no other photo"));
    enable(m_others, m_others->count() > 0, m_others->toolTip(), tr("There is no other photo"));
    enable(m_none, isBalanced, tr("Keep the colours of the photo"), tr("The photo has its own colours"));
}

} // namespace esm
