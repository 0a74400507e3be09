#include "app/editor/panels/texture/preparation_panel.h"

#include "app/editor/panels/texture/adjust_page.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/enabling.h"

#include <QPainter>
#include <QSignalBlocker>

#include <cmath>

namespace esm {

namespace {

constexpr int picturesHeight = 104;
constexpr double usualEvenLight = 0.7;

NumberFormat strengthFormat() {
    NumberFormat format;
    format.decimals = 2;
    format.minimum = 0;
    format.maximum = 1;
    format.step = 0.05;
    return format;
}

QLabel* pictureLabel(const QString& name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setFixedHeight(picturesHeight);
    label->setAlignment(Qt::AlignCenter);
    label->setProperty("quiet", true);
    label->setWordWrap(true);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return label;
}

QPixmap fitting(const QImage& picture, const QLabel* label) {
    const double ratio = label->devicePixelRatioF();
    const QSize room = QSize(label->width() > 40 ? label->width() : 140, picturesHeight) * ratio;
    QPixmap pixmap = QPixmap::fromImage(picture.scaled(room, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}

QString gainsText(const ColourGains& gains) {
    return PreparationPanel::tr("red × %1, blue × %2").arg(gains[0], 0, 'f', 2).arg(gains[2], 0, 'f', 2);
}

/// How far the lens moves what is seen at the photo's corner.
StepWords lensWords(const Lens& lens, const Image& photo) {
    const Eigen::Vector2d corner(photo.width, photo.height);
    const double moved = (distorted(lens, corner) - corner).norm();
    QString kind =
        lens.kind == LensKind::Fisheye ? PreparationPanel::tr("fisheye") : PreparationPanel::tr("pinhole");
    if (!std::isfinite(moved)) return {kind};
    return {kind, PreparationPanel::tr("The corner moves by %1 px").arg(std::round(moved), 0, 'f', 0)};
}

QString strokesText(std::size_t strokes) {
    return strokes == 1 ? PreparationPanel::tr("1 part") : PreparationPanel::tr("%1 parts").arg(strokes);
}

QString fieldText(const PhotoField& field) {
    if (field.shape == FieldShape::Polygon) return PreparationPanel::tr("polygon");
    return field.isCircle() ? PreparationPanel::tr("circle") : PreparationPanel::tr("ellipse");
}

} // namespace

PreparationPanel::PreparationPanel(PreparationEdits& edits, QWidget* parent)
    : Section(tr("Photo"), parent), m_edits(edits),
      m_before(pictureLabel(QStringLiteral("photoBefore"), this)),
      m_after(pictureLabel(QStringLiteral("photoAfter"), this)), m_warning(new QLabel(this)),
      m_remark(new QLabel(this)), m_steps(new QGridLayout),
      m_evenLightField(new NumberField(strengthFormat(), this)), m_field(addStep(tr("Fiel&d"), "roundField")),
      m_strokes(addStep(tr("Erased"), "brushedOut")), m_highlights(addStep(tr("Hi&ghlights"), "highlights")),
      m_evenLight(addStep(tr("Even light"), "evenLight", m_evenLightField)),
      m_whiteBalance(addStep(tr("&White balance"), "whiteBalance")),
      m_match(addStep(tr("Match colour beneath"), "matchColour")), m_lens(addStep(tr("Lens"), "lens")),
      m_crop(addStep(tr("Crop"), "crop")), m_adjustment(addStep(tr("Adjusted"), "adjustColours")),
      m_large(new QPushButton(tr("Show large…"), this)) {
    layOut();
    connectControls();
    connect(&edits, &PreparationEdits::changed, this, &PreparationPanel::show);
    show();
}

PreparationPanel::Step PreparationPanel::addStep(const QString& text, const char* name, QWidget* beside) {
    auto* box = new QCheckBox(text, this);
    auto* words = new ElidedLabel(this);
    box->setObjectName(QLatin1String(name));
    words->setObjectName(QLatin1String(name) + QLatin1String("Words"));
    words->setProperty("quiet", true);
    words->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const int row = m_steps->rowCount();
    m_steps->addWidget(box, row, 0);
    if (beside) {
        words->hide();
        m_steps->addWidget(beside, row, 1, Qt::AlignRight);
    } else {
        m_steps->addWidget(words, row, 1);
    }
    return {box, words};
}

void PreparationPanel::layOut() {
    auto* caption = new QLabel(tr("before | after"), this);
    caption->setProperty("quiet", true);
    addToHeader(caption);
    auto* pictures = new QHBoxLayout;
    pictures->setSpacing(8);
    pictures->addWidget(m_before, 1);
    pictures->addWidget(m_after, 1);
    m_steps->setColumnStretch(1, 1);
    m_steps->setHorizontalSpacing(8);
    m_steps->setVerticalSpacing(6);
    m_evenLightField->setObjectName(QStringLiteral("evenLightStrength"));
    m_evenLightField->setAccessibleName(tr("Even light, strength"));
    m_large->setObjectName(QStringLiteral("largePhoto"));
    m_warning->setObjectName(QStringLiteral("preparationWarning"));
    m_warning->setProperty("warning", true);
    m_warning->setWordWrap(true);
    body()->addLayout(pictures);
    body()->addWidget(m_warning);
    m_remark->setObjectName(QStringLiteral("preparationRemark"));
    m_remark->setProperty("quiet", true);
    m_remark->setWordWrap(true);
    body()->addLayout(m_steps);
    body()->addWidget(m_remark);
    body()->addWidget(m_large, 0, Qt::AlignLeft);
}

template<typename Part>
void PreparationPanel::connectKept(Step& step, Part PhotoPreparation::*part, const QString& text) {
    connect(step.box, &QCheckBox::clicked, this, [this, part, text](bool on) {
        const Part value = on ? m_last.*part : Part();
        m_edits.edit(text, [=](PreparationWish& wish) { wish.preparation.*part = value; });
    });
}

void PreparationPanel::connectControls() {
    connect(m_field.box, &QCheckBox::clicked, this, [this](bool on) {
        m_edits.edit(on ? tr("Mask field") : tr("Show photo outside its field"), [=](PreparationWish& wish) {
            wish.preparation.field.reset();
            wish.find.field = on;
        });
    });
    connect(m_whiteBalance.box, &QCheckBox::clicked, this, [this](bool on) {
        m_edits.edit(on ? tr("Balance white") : tr("Undo white balance"), [=](PreparationWish& wish) {
            wish.preparation.whiteBalance.reset();
            wish.find.whiteBalance = on;
        });
    });
    connect(m_highlights.box, &QCheckBox::clicked, this, [this](bool on) {
        m_edits.edit(on ? tr("Fill highlights") : tr("Show highlights"), [=](PreparationWish& wish) {
            wish.preparation.highlightThreshold.reset();
            wish.preparation.highlightSensitivity =
                on ? std::optional<double>(usualSensitivity) : std::nullopt;
        });
    });
    connect(m_evenLight.box, &QCheckBox::clicked, this, [this](bool on) {
        const double strength = on ? m_last.evenLight : 0;
        m_edits.edit(on ? tr("Even light") : tr("Leave light uneven"),
                     [=](PreparationWish& wish) { wish.preparation.evenLight = strength; });
    });
    connect(m_evenLightField, &NumberField::valueEdited, this, [this](double strength) {
        m_edits.edit(
            tr("Even light"), [=](PreparationWish& wish) { wish.preparation.evenLight = strength; },
            EditKind::EvenLight);
    });
    connect(m_evenLightField, &NumberField::gestureFinished, &m_edits, &PreparationEdits::finishGesture);
    connect(m_match.box, &QCheckBox::clicked, this, [this](bool on) {
        m_edits.edit(on ? tr("Match colour beneath") : tr("Keep colour"), [=](PreparationWish& wish) {
            wish.preparation.match.reset();
            wish.find.match = on;
        });
    });
    connectKept(m_strokes, &PhotoPreparation::strokes, tr("Erase parts of photo"));
    connectKept(m_lens, &PhotoPreparation::lens, tr("Correct lens"));
    connectKept(m_crop, &PhotoPreparation::crop, tr("Crop photo"));
    connectKept(m_adjustment, &PhotoPreparation::adjustment, tr("Adjust colours"));
    connect(m_large, &QPushButton::clicked, this, &PreparationPanel::largeViewAsked);
}

/// The pictures take the room that there is.
void PreparationPanel::resizeEvent(QResizeEvent* event) {
    Section::resizeEvent(event);
    showPictures(m_edits.layer());
}

void PreparationPanel::show() {
    const TextureLayer* layer = m_edits.layer();
    setTitle(layer ? tr("Photo · %1").arg(QString::fromStdString(layer->name)) : tr("Photo"));
    showFailure();
    showPictures(layer);
    showSteps(layer);
}

void PreparationPanel::showFailure() {
    const QString failure = m_edits.failure();
    m_warning->setText(failure.isEmpty() ? QString() : tr("Not prepared: %1").arg(failure));
    m_warning->setVisible(!failure.isEmpty());
}

void PreparationPanel::showPictures(const TextureLayer* layer) {
    const PreparedPhoto* shown = m_edits.shown();
    m_before->setToolTip(layer ? tr("%1, %2 × %3 pixels")
                                     .arg(QString::fromStdString(layer->photo->fileName))
                                     .arg(layer->photo->image.width)
                                     .arg(layer->photo->image.height)
                               : QString());
    m_after->setToolTip(layer ? tr("As it is laid on the organ") : QString());
    if (shown && !shown->before.isNull()) {
        m_before->setPixmap(fitting(shown->before, m_before));
        m_after->setPixmap(fitting(shown->after, m_after));
        return;
    }
    m_before->setText(layer ? QString() : tr("Select or add a photo"));
    m_after->clear();
}

QString PreparationPanel::highlightWords(const PhotoPreparation& wanted) const {
    const PreparedPhoto* shown = m_edits.shown();
    if (!wanted.fillsHighlights()) return {};
    if (!shown || !shown->preparation.fillsHighlights()) return tr("filling…");
    if (shown->highlightShare == 0) return tr("none found");
    return tr("%1 % filled").arg(100 * shown->highlightShare, 0, 'f', shown->highlightShare < 0.0995 ? 1 : 0);
}

void PreparationPanel::showWords(Step& step, bool on, const StepWords& words) {
    step.box->setChecked(on);
    step.words->setText(words.shown);
    step.words->setToolTip(words.inFull.isEmpty() ? words.shown : words.inFull);
}

/// What was looked for in vain, and what to do about it, in as many lines as it takes.
void PreparationPanel::showRemark(const PreparationWish& wish) {
    const SoughtSteps missing = m_edits.missing();
    const PhotoPreparation& wanted = wish.preparation;
    QStringList remarks;
    if (missing.field && !wanted.field && !wish.find.field)
        remarks << tr("No field is found. Draw it in the large view.");
    if (missing.whiteBalance && !wanted.whiteBalance && !wish.find.whiteBalance)
        remarks << tr("Nothing shows the lamp's colour for sure. Pick something white in the large view.");
    if (missing.match && !wanted.match && !wish.find.match)
        remarks << tr("The photo meets too little of the surface to match its colour.");
    m_remark->setText(remarks.join('\n'));
    m_remark->setVisible(!remarks.isEmpty());
}

void PreparationPanel::showSteps(const TextureLayer* layer) {
    const PreparationWish wish = m_edits.wanted();
    const PhotoPreparation& wanted = wish.preparation;
    const SoughtSteps missing = m_edits.missing();
    if (!layer || layer->photo != m_lastOf) {
        m_last = {};
        m_last.evenLight = usualEvenLight;
        m_lastOf = layer ? layer->photo : nullptr;
    }
    if (!wanted.strokes.empty()) m_last.strokes = wanted.strokes;
    if (wanted.evenLight > 0) m_last.evenLight = wanted.evenLight;
    if (wanted.lens) m_last.lens = wanted.lens;
    if (wanted.crop) m_last.crop = wanted.crop;
    const bool isAdjusted = wanted.adjustment != ColourAdjustment();
    if (isAdjusted) m_last.adjustment = wanted.adjustment;

    showWords(m_field, wanted.field || wish.find.field,
              wish.find.field ? StepWords{tr("looking…")}
              : wanted.field
                  ? StepWords{fieldText(*wanted.field), tr("%1 % trimmed").arg(wanted.field->trim, 0, 'g', 3)}
              : missing.field ? StepWords{tr("not found")}
                              : StepWords{});
    showWords(m_highlights, wanted.fillsHighlights(), {highlightWords(wanted)});
    showWords(m_evenLight, wanted.evenLight > 0, {});
    showWords(m_whiteBalance, wanted.whiteBalance || wish.find.whiteBalance,
              {wish.find.whiteBalance ? tr("looking…")
               : wanted.whiteBalance  ? gainsText(*wanted.whiteBalance)
               : missing.whiteBalance ? tr("unsure")
                                      : QString()});
    showWords(m_match, wanted.match || wish.find.match,
              {wish.find.match ? tr("comparing…")
               : wanted.match  ? tr("matched")
               : missing.match ? tr("not matched")
                               : QString()});
    showWords(m_strokes, !wanted.strokes.empty(),
              {wanted.strokes.empty() ? QString() : strokesText(wanted.strokes.size())});
    showWords(m_lens, wanted.lens.has_value(),
              wanted.lens && layer ? lensWords(*wanted.lens, layer->photo->image) : StepWords{});
    showWords(m_crop, wanted.crop.has_value(),
              {wanted.crop ? tr("%1 × %2 px").arg(wanted.crop->width).arg(wanted.crop->height) : QString()});
    showWords(m_adjustment, isAdjusted,
              isAdjusted ? StepWords{tr("changed"), adjustmentText(wanted.adjustment)} : StepWords{});
    showRemark(wish);
    m_evenLightField->setValue(layer ? std::optional(wanted.evenLight) : std::nullopt);
    enableSteps(layer);
}

void PreparationPanel::enableSteps(const TextureLayer* layer) {
    const QString none = tr("No photo is selected");
    const QString first = layer ? tr("Open the large view first, by the button below") : none;
    enable(m_field.box, layer,
           tr("Find the endoscope's picture, round or not, and erase what is dark around it"), none);
    enable(m_highlights.box, layer, tr("Fill what the lamp burnt out from the tissue around it"), none);
    enable(m_evenLight.box, layer, tr("Take slow changes of brightness over the photo away"), none);
    enable(m_evenLightField, layer, tr("From 0, as it is, to 1, as even as can be"), none);
    enable(m_whiteBalance.box, layer,
           tr("Make white what the lamp shines on, by its mirror images or a grey thing"), none);
    enable(m_match.box, layer,
           tr("Give the photo the mean colour and contrast of what lies beneath it now; tick anew when that "
              "changes"),
           none);
    enable(m_strokes.box, layer && !m_last.strokes.empty(), tr("Erase what was painted over or outlined"),
           first);
    enable(m_lens.box, layer && m_last.lens,
           tr("Correct the distortion of the lens; it does not turn the photo"), first);
    enable(m_crop.box, layer && m_last.crop, tr("Keep only a part of the photo"), first);
    enable(m_adjustment.box, layer && m_last.adjustment != ColourAdjustment(),
           tr("Hue, saturation, contrast and levels as they were chosen"), first);
    enable(m_large, layer,
           tr("Show the photo large: set its field, erase text and instruments, choose highlights, white "
              "and colours, correct its lens, crop"),
           none);
}

} // namespace esm
