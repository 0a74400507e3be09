#include "app/editor/panels/texture/photo_dialog.h"

#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/refused_numbers.h"
#include "widgets/texture/image_conversion.h"

#include <QShortcut>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

NumberFormat radiusFormat() {
    NumberFormat format = pixelFormat();
    format.minimum = 1;
    format.maximum = 2000;
    return format;
}

QHBoxLayout* pageRow(QWidget* page) {
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    return row;
}

QLabel* quietLabel(const QString& text, QWidget* buddy, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("quiet", true);
    label->setBuddy(buddy);
    return label;
}

} // namespace

PhotoDialog::PhotoDialog(Document& document, PreparationEdits& edits, QWidget* parent)
    : QDialog(parent), m_edits(edits), m_canvas(new PhotoCanvas(this)), m_pages(new QStackedWidget(this)),
      m_tools(new QButtonGroup(this)), m_radius(new NumberField(radiusFormat(), this)),
      m_softness(new NumberField(shareFormat(), this)), m_lensPage(new LensPage(edits, *m_canvas, this)),
      m_whole(new QPushButton(tr("Whole photo"), this)), m_hint(new QLabel(this)) {
    setObjectName(QStringLiteral("photoDialog"));
    setWindowFlag(Qt::WindowContextHelpButtonHint, false);
    resize(960, 680);
    for (QWidget* page : {brushPage(), static_cast<QWidget*>(m_lensPage), cropPage()})
        m_pages->addWidget(page);
    m_pages->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(this);
    column->addLayout(toolRow());
    column->addWidget(m_pages);
    column->addWidget(m_canvas, 1);
    column->addLayout(closeRow(document));

    connect(m_canvas, &PhotoCanvas::strokeDrawn, this, [this](const PhotoStroke& stroke) {
        m_edits.edit(stroke.takesBack ? tr("Take back part of photo") : tr("Leave out part of photo"),
                     [=](PreparationWish& wish) { wish.preparation.strokes.push_back(stroke); });
    });
    connect(m_canvas, &PhotoCanvas::cropDrawn, this, &PhotoDialog::setCrop);
    connect(m_canvas, &PhotoCanvas::frameFinished, &m_edits, &PreparationEdits::finishGesture);
    connect(m_canvas, &PhotoCanvas::frameDropped, this, [this](const std::optional<PhotoCrop>& before) {
        setCrop(before);
        m_edits.finishGesture();
    });
    connect(m_canvas, &PhotoCanvas::linesChanged, this, [this] { showHint(); });
    connect(m_lensPage, &LensPage::failed, this, &PhotoDialog::showHint);
    connect(&edits, &PreparationEdits::changed, this, &PhotoDialog::showPhoto);
    chooseTool(PhotoTool::LeaveOut);
    showPhoto();
    m_canvas->setFocus();
}

QHBoxLayout* PhotoDialog::toolRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    const auto add = [&](PhotoTool tool, const QString& text, const QKeySequence& key, const QString& does) {
        auto* button = new QPushButton(text, this);
        button->setCheckable(true);
        button->setAutoDefault(false);
        button->setObjectName(QStringLiteral("quietButton"));
        button->setToolTip(tr("%1 (%2)").arg(does, key.toString(QKeySequence::NativeText)));
        m_tools->addButton(button, static_cast<int>(tool));
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, tool] { chooseTool(tool); });
        connect(new QShortcut(key, this), &QShortcut::activated, button, &QPushButton::click);
    };
    add(PhotoTool::LeaveOut, tr("Leave out"), Qt::Key_B, tr("Brush over text, overlays and instruments"));
    add(PhotoTool::TakeBack, tr("Take back"), Qt::Key_E, tr("Brush over what was left out to show it again"));
    add(PhotoTool::Straighten, tr("Straighten"), Qt::Key_L, tr("Draw along what should be straight"));
    add(PhotoTool::Crop, tr("Crop"), Qt::Key_C, tr("Frame the part that is kept"));
    row->addStretch();
    return row;
}

QWidget* PhotoDialog::brushPage() {
    auto* page = new QWidget(this);
    QHBoxLayout* row = pageRow(page);
    m_radius->setObjectName(QStringLiteral("photoBrushRadius"));
    m_radius->setToolTip(tr("Of the brush, in pixels of the photo; [ and ] make it smaller and larger"));
    m_softness->setToolTip(tr("Share of the radius over which the brush fades"));
    m_radius->setValue(20);
    m_softness->setValue(0.3);
    row->addWidget(quietLabel(tr("&Radius"), m_radius, page));
    row->addWidget(m_radius);
    row->addWidget(quietLabel(tr("So&ftness"), m_softness, page));
    row->addWidget(m_softness);
    row->addStretch();
    for (NumberField* field : {m_radius, m_softness})
        connect(field, &NumberField::valueEdited, this, [this] { changeBrush(1); });
    for (const auto& [key, factor] : {std::pair(Qt::Key_BracketLeft, 0.8), {Qt::Key_BracketRight, 1.25}})
        connect(new QShortcut(key, this), &QShortcut::activated, this,
                [this, factor = factor] { changeBrush(factor); });
    return page;
}

QWidget* PhotoDialog::cropPage() {
    auto* page = new QWidget(this);
    QHBoxLayout* row = pageRow(page);
    const auto add = [&](const QString& caption, int PhotoCrop::*part, const char* name) {
        auto* field = new NumberField(withoutUnit(pixelFormat()), page);
        field->setObjectName(QLatin1String(name));
        field->setToolTip(tr("Pixels of the photo, from its top left corner"));
        field->setAccessibleName(tr("%1, %2").arg(withoutMnemonic(caption), field->format().unit));
        row->addWidget(quietLabel(caption, field, page));
        row->addWidget(field);
        m_cropFields.emplace_back(part, field);
        connect(field, &NumberField::valueEdited, this,
                [this, part = part](double value) { editCropField(part, value); });
        connect(field, &NumberField::gestureFinished, &m_edits, &PreparationEdits::finishGesture);
    };
    add(tr("&Left"), &PhotoCrop::x, "cropLeft");
    add(tr("&Top"), &PhotoCrop::y, "cropTop");
    add(tr("&Width"), &PhotoCrop::width, "cropWidth");
    add(tr("&Height"), &PhotoCrop::height, "cropHeight");
    m_whole->setAutoDefault(false);
    row->addWidget(m_whole);
    row->addStretch();
    connect(m_whole, &QPushButton::clicked, this, [this] {
        setCrop(std::nullopt);
        m_edits.finishGesture();
    });
    return page;
}

QHBoxLayout* PhotoDialog::closeRow(Document& document) {
    auto* row = new QHBoxLayout;
    m_hint->setObjectName(QStringLiteral("photoHint"));
    m_hint->setWordWrap(true);
    m_hint->setMinimumHeight(2 * fontMetrics().lineSpacing());
    row->addWidget(m_hint, 1);
    QUndoStack* stack = document.undoStack();
    const auto add = [&](QAction* action, const QKeySequence& key) {
        action->setShortcut(key);
        addAction(action);
        auto* button = new QPushButton(this);
        button->setAutoDefault(false);
        button->setText(action == actions().first() ? tr("Undo") : tr("Redo"));
        follow(button, action);
        row->addWidget(button);
    };
    add(stack->createUndoAction(this, tr("Undo")), QKeySequence::Undo);
    add(stack->createRedoAction(this, tr("Redo")), QKeySequence::Redo);
    auto* close = new QPushButton(tr("Close"), this);
    close->setToolTip(tr("Go back to the organ; what was done to the photo stays"));
    close->setAutoDefault(false);
    connect(close, &QPushButton::clicked, this, [this] {
        if (takesAllNumbers(*this)) QDialog::close();
    });
    row->addWidget(close);
    return row;
}

void PhotoDialog::chooseTool(PhotoTool tool) {
    m_tools->button(static_cast<int>(tool))->setChecked(true);
    m_canvas->setTool(tool);
    m_pages->setCurrentIndex(tool == PhotoTool::Crop ? 2 : tool == PhotoTool::Straighten ? 1 : 0);
    changeBrush(1);
    showPhoto();
    showHint(); // what the tool does, whatever was told before
}

void PhotoDialog::changeBrush(double factor) {
    const NumberFormat& format = m_radius->format();
    const double radius = std::clamp(std::round(*m_radius->value() * factor), format.minimum, format.maximum);
    if (factor != 1) m_radius->setValue(radius);
    m_canvas->setBrush(radius, *m_softness->value());
}

void PhotoDialog::showPhoto() {
    const TextureLayer* layer = m_edits.layer();
    if (!layer) {
        close(); // no photo is selected any more
        return;
    }
    setWindowTitle(tr("Photo · %1").arg(QString::fromStdString(layer->name)));
    showPicture(*layer);
    const PhotoPreparation wanted = m_edits.wanted().preparation;
    m_canvas->setStrokes(wanted.strokes);
    m_canvas->setCrop(wanted.crop);
    const Image& photo = layer->photo->image;
    const PhotoCrop crop = wanted.crop.value_or(PhotoCrop{0, 0, photo.width, photo.height});
    for (const auto& [part, field] : m_cropFields)
        field->setValue(crop.*part);
    enable(m_whole, wanted.crop.has_value(), tr("Keep the whole photo"), tr("The whole photo is kept"));
    const QString failure = m_edits.failure();
    showHint(failure.isEmpty() ? QString() : tr("Not prepared: %1").arg(failure));
}

/// The photo as it was taken; for the crop, which lies on what comes out, the straightened one.
void PhotoDialog::showPicture(const TextureLayer& layer) {
    const bool isStraight = m_canvas->tool() == PhotoTool::Crop && layer.preparation.lens && layer.prepared;
    const std::shared_ptr<const Image> prepared = isStraight ? layer.prepared : nullptr;
    if (m_photo == layer.photo && m_prepared == prepared) return;
    if (m_photo != layer.photo) {
        m_canvas->clearLines();
        const Image& photo = layer.photo->image;
        m_radius->setValue(std::max(3.0, std::round(std::max(photo.width, photo.height) / 60.0)));
        changeBrush(1);
    }
    m_photo = layer.photo;
    m_prepared = prepared;
    QImage picture = toQImage(prepared ? *prepared : layer.photo->image);
    picture.reinterpretAsFormat(QImage::Format_RGBX8888); // what is left out is seen as well
    m_canvas->setPicture(picture);
}

void PhotoDialog::showHint(const QString& problem) {
    m_lensPage->showLines();
    QString hint = tr("Paint over what shall not lie on the organ · wheel magnifies, middle button moves");
    if (m_canvas->tool() == PhotoTool::TakeBack) hint = tr("Paint over what was left out to show it again");
    if (m_canvas->tool() == PhotoTool::Crop)
        hint = tr("Drag a frame, or a corner of the one there is; what lies outside is left out");
    if (m_canvas->tool() == PhotoTool::Straighten)
        hint = tr(
            "Click three places or more along what should be straight, Enter or a double click ends a line; "
            "two lines or more, near the border");
    m_hint->setText(problem.isEmpty() ? hint : problem);
    m_hint->setProperty("quiet", problem.isEmpty());
    m_hint->setProperty("warning", !problem.isEmpty());
    m_hint->setStyleSheet(m_hint->styleSheet()); // looks at the properties anew
}

void PhotoDialog::setCrop(const std::optional<PhotoCrop>& crop) {
    m_edits.edit(
        crop ? tr("Crop photo") : tr("Keep whole photo"),
        [=](PreparationWish& wish) { wish.preparation.crop = crop; }, EditKind::Crop);
}

/// One number of the frame; the others follow so that it stays inside the photo.
void PhotoDialog::editCropField(int PhotoCrop::*part, double value) {
    const Image& photo = m_edits.layer()->photo->image;
    PhotoCrop crop = m_edits.wanted().preparation.crop.value_or(PhotoCrop{0, 0, photo.width, photo.height});
    crop.*part = static_cast<int>(std::lround(value));
    crop.x = std::clamp(crop.x, 0, photo.width - 1);
    crop.y = std::clamp(crop.y, 0, photo.height - 1);
    crop.width = std::clamp(crop.width, 1, photo.width - crop.x);
    crop.height = std::clamp(crop.height, 1, photo.height - crop.y);
    setCrop(crop);
}

} // namespace esm
