#include "app/editor/panels/texture/lens_page.h"

#include "app/editor/dialogs/lens_files.h"
#include "app/editor/panels/texture/page_row.h"
#include "core/support/errors.h"
#include "core/texture/photo/straightening.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quiet_label.h"

namespace esm {

LensPage::LensPage(PreparationEdits& edits, PhotoCanvas& canvas, QWidget* parent)
    : QWidget(parent), m_edits(edits), m_canvas(canvas), m_kind(new QComboBox(this)),
      m_count(new QLabel(this)), m_straighten(new QPushButton(tr("&Correct lens"), this)),
      m_clear(new QPushButton(tr("Clear lines"), this)), m_load(new QPushButton(tr("Load lens…"), this)),
      m_save(new QPushButton(tr("Save lens…"), this)) {
    layOut();
    connect(m_straighten, &QPushButton::clicked, this, &LensPage::straighten);
    connect(m_clear, &QPushButton::clicked, &canvas, &PhotoCanvas::clearLines);
    connect(m_load, &QPushButton::clicked, this, &LensPage::load);
    connect(m_save, &QPushButton::clicked, this, &LensPage::save);
}

void LensPage::layOut() {
    m_kind->addItem(tr("pinhole"), static_cast<int>(LensKind::Pinhole));
    m_kind->addItem(tr("fisheye"), static_cast<int>(LensKind::Fisheye));
    m_kind->setToolTip(tr("How the lens bends: a little, or as one that sees very wide"));
    guardFromWheel(*m_kind);
    m_straighten->setObjectName(QStringLiteral("straightenPhoto"));
    m_load->setObjectName(QStringLiteral("loadLens"));
    m_save->setObjectName(QStringLiteral("saveLens"));
    m_load->setToolTip(
        tr("A lens that is known: its coefficients in a JSON file, as esmc texture photo --lens "
           "reads it"));
    m_count->setProperty("quiet", true);
    QHBoxLayout* row = pageRow(this);
    row->addWidget(quietLabel(tr("L&ens"), this, m_kind));
    row->addWidget(m_kind);
    row->addWidget(m_count);
    for (QPushButton* button : {m_straighten, m_clear, m_load, m_save}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    row->addStretch();
}

void LensPage::showLines() {
    const std::size_t lines = m_canvas.lines().size();
    m_count->setText(lines == 1 ? tr("1 line") : tr("%1 lines").arg(lines));
    enable(m_straighten, lines >= 2,
           tr("Find the lens that makes these lines straight, and take its distortion away; it does not "
              "turn the photo"),
           tr("Draw two lines of three places each first"));
    enable(m_clear, lines > 0, tr("Draw anew"), tr("No line is drawn"));
    enable(m_save, m_edits.wanted().preparation.lens.has_value(),
           tr("Save the lens for other photos of the same endoscope"), tr("No lens is corrected yet"));
}

void LensPage::straighten() {
    const Image& photo = m_edits.layer()->photo->image;
    const auto kind = static_cast<LensKind>(m_kind->currentData().toInt());
    try {
        const Lens lens = straighteningLens(kind, {photo.width, photo.height}, m_canvas.lines());
        m_edits.edit(tr("Correct lens"), [=](PreparationWish& wish) { wish.preparation.lens = lens; });
    } catch (const InvalidModel& error) {
        QString reason = QString::fromStdString(error.problems().front());
        emit failed(reason.replace(0, 1, reason.at(0).toUpper()));
    }
}

void LensPage::load() {
    openLens(window(), [this](const Lens& lens) {
        m_edits.edit(tr("Correct lens"), [=](PreparationWish& wish) { wish.preparation.lens = lens; });
    });
}

void LensPage::save() {
    const std::optional<Lens> lens = m_edits.wanted().preparation.lens;
    if (lens) saveLens(window(), QStringLiteral("lens.json"), *lens);
}

} // namespace esm
