#include "app/editor/panels/texture/photo_dialog.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/panels/texture/page_row.h"
#include "widgets/inputs/action_texts.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quantity_formats.h"
#include "widgets/inputs/quiet_label.h"
#include "widgets/inputs/refused_numbers.h"
#include "widgets/texture/image_conversion.h"

#include <QMessageBox>
#include <QShortcut>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

struct TaskWords {
    PhotoTask task;
    QString name;
    Qt::Key key;
    QString does, hint;
};

std::vector<TaskWords> taskWords() {
    const auto tr = [](const char* text) { return PhotoDialog::tr(text); };
    const QString inside = tr("Drag around what shall not lie on the organ; with Ctrl it is restored");
    return {
        {PhotoTask::Field, tr("Field"), Qt::Key_F, tr("Set what the endoscope shows"),
         tr("Find the field, or drag one; squares move, size and turn it, Backspace removes a corner")},
        {PhotoTask::Erase, tr("Erase"), Qt::Key_E, tr("Brush over text, overlays and instruments"),
         tr("Paint over what shall not lie on the organ · wheel magnifies, middle button moves")},
        {PhotoTask::Restore, tr("Restore"), Qt::Key_R, tr("Brush over what was erased to show it again"),
         tr("Paint over what was erased to show it again")},
        {PhotoTask::Outline, tr("Outline"), Qt::Key_O, tr("Erase what a line goes around"), inside},
        {PhotoTask::Box, tr("Box"), Qt::Key_X, tr("Erase a rectangle, or text and boxes that are found"),
         inside},
        {PhotoTask::Region, tr("Region"), Qt::Key_G, tr("Erase what hangs together and has one colour"),
         tr("Click on an instrument, blood or a bubble: what hangs together with it is erased")},
        {PhotoTask::Highlights, tr("Highlights"), Qt::Key_H,
         tr("Choose which mirror images of the lamp are filled"),
         tr("Move the slider until what shines is green")},
        {PhotoTask::White, tr("White"), Qt::Key_W, tr("Balance white"),
         tr("Click on something that is white or grey, let it be found, or take the colours of another "
            "photo")},
        {PhotoTask::Adjust, tr("Adjust"), Qt::Key_A, tr("Adjust hue, saturation, contrast and levels"),
         tr("Move the sliders; the photo is shown as it is laid on the organ")},
        {PhotoTask::Lens, tr("Lens"), Qt::Key_L,
         tr("Correct the distortion of the lens, by lines along what is straight"),
         tr("Click three places or more along what should be straight, Enter or a double click ends a line; "
            "two "
            "lines or more, near the border")},
        {PhotoTask::Crop, tr("Crop"), Qt::Key_C, tr("Frame the part that is kept"),
         tr("Drag a frame, or a corner of the one there is; what lies outside is erased")}};
}

PhotoTool toolFor(PhotoTask task) {
    switch (task) {
    case PhotoTask::Field:
        return PhotoTool::Field;
    case PhotoTask::Erase:
        return PhotoTool::LeaveOut;
    case PhotoTask::Restore:
        return PhotoTool::TakeBack;
    case PhotoTask::Outline:
        return PhotoTool::Outline;
    case PhotoTask::Box:
        return PhotoTool::Box;
    case PhotoTask::Lens:
        return PhotoTool::Straighten;
    case PhotoTask::Crop:
        return PhotoTool::Crop;
    case PhotoTask::Region:
    case PhotoTask::Highlights:
    case PhotoTask::White:
    case PhotoTask::Adjust:
        break;
    }
    return PhotoTool::Pick;
}

} // namespace

PhotoDialog::PhotoDialog(Document& document, PreparationEdits& edits, QWidget* parent)
    : QDialog(parent), m_edits(edits), m_session(document, edits), m_canvas(new PhotoCanvas(this)),
      m_pages(new QStackedWidget(this)), m_tasks(new QButtonGroup(this)),
      m_fieldPage(new FieldPage(edits, *m_canvas, this)), m_brushPage(new BrushPage(*m_canvas, this)),
      m_outlinePage(new OutlinePage(edits, this)), m_regionPage(new RegionPage(edits, this)),
      m_highlightPage(new HighlightPage(edits, *m_canvas, this)),
      m_whitePage(new WhitePage(document, edits, this)), m_adjustPage(new AdjustPage(edits, this)),
      m_lensPage(new LensPage(edits, *m_canvas, this)), m_whole(new QPushButton(tr("Whole photo"), this)),
      m_cropPage(cropPage()), m_hint(new QLabel(this)) {
    setObjectName(QStringLiteral("photoDialog"));
    setWindowFlag(Qt::WindowContextHelpButtonHint, false);
    resize(960, 680);
    addPages();
    auto* column = new QVBoxLayout(this);
    column->addLayout(taskRow());
    column->addWidget(m_pages);
    column->addWidget(m_canvas, 1);
    column->addLayout(closeRow());
    connectCanvas();
    connect(m_lensPage, &LensPage::failed, this, &PhotoDialog::showHint);
    connect(&edits, &PreparationEdits::changed, this, &PhotoDialog::showPhoto);
    choose(PhotoTask::Erase);
    showPhoto();
    m_canvas->setFocus();
}

void PhotoDialog::addPages() {
    for (QWidget* page :
         std::initializer_list<QWidget*>{m_fieldPage, m_brushPage, m_outlinePage, m_regionPage,
                                         m_highlightPage, m_whitePage, m_adjustPage, m_lensPage, m_cropPage})
        m_pages->addWidget(page);
    m_pages->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void PhotoDialog::connectCanvas() {
    connect(m_canvas, &PhotoCanvas::strokeDrawn, this, [this](const PhotoStroke& stroke) {
        m_edits.edit(stroke.takesBack ? tr("Restore part of photo") : tr("Erase part of photo"),
                     [=](PreparationWish& wish) { wish.preparation.strokes.push_back(stroke); });
    });
    connect(m_canvas, &PhotoCanvas::placePicked, this, [this](const Eigen::Vector2d& place) {
        if (m_task == PhotoTask::Region) m_regionPage->grow(place);
        if (m_task == PhotoTask::White) m_whitePage->pick(place);
    });
    connect(m_canvas, &PhotoCanvas::cropDrawn, this, &PhotoDialog::setCrop);
    connect(m_canvas, &PhotoCanvas::shapeFinished, &m_edits, &PreparationEdits::finishGesture);
    connect(m_canvas, &PhotoCanvas::cropDropped, this, [this](const std::optional<PhotoCrop>& before) {
        setCrop(before);
        m_edits.finishGesture();
    });
    connect(m_canvas, &PhotoCanvas::linesChanged, this, [this] { showHint(); });
}

QHBoxLayout* PhotoDialog::taskRow() {
    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    for (const TaskWords& words : taskWords()) {
        auto* button = new QPushButton(words.name, this);
        const QKeySequence key(words.key);
        button->setCheckable(true);
        button->setAutoDefault(false);
        button->setObjectName(QStringLiteral("quietButton"));
        button->setToolTip(tr("%1 (%2)").arg(words.does, key.toString(QKeySequence::NativeText)));
        m_tasks->addButton(button, static_cast<int>(words.task));
        row->addWidget(button);
        connect(button, &QPushButton::clicked, this, [this, task = words.task] { choose(task); });
        connect(new QShortcut(key, this), &QShortcut::activated, button, &QPushButton::click);
    }
    row->addStretch();
    return row;
}

QWidget* PhotoDialog::cropPage() {
    auto* page = new QWidget(this);
    QHBoxLayout* row = pageRow(page);
    const auto add = [&](const QString& caption, int PhotoCrop::*part, const char* name) {
        auto* field = new NumberField(withoutUnit(pixelFormat()), page);
        field->setObjectName(QLatin1String(name));
        field->setToolTip(tr("Pixels of the photo, from its top left corner"));
        field->setAccessibleName(tr("%1, %2").arg(withoutMnemonic(caption), field->format().unit));
        row->addWidget(quietLabel(caption, page, field));
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

QHBoxLayout* PhotoDialog::closeRow() {
    auto* row = new QHBoxLayout;
    m_hint->setObjectName(QStringLiteral("photoHint"));
    m_hint->setWordWrap(true);
    m_hint->setMinimumHeight(2 * fontMetrics().lineSpacing());
    row->addWidget(m_hint, 1);
    m_undo = addStepAction(row, tr("Undo"), QKeySequence::Undo);
    m_redo = addStepAction(row, tr("Redo"), QKeySequence::Redo);
    connect(m_undo, &QAction::triggered, &m_session, &PreparationSession::undo);
    connect(m_redo, &QAction::triggered, &m_session, &PreparationSession::redo);
    connect(&m_session, &PreparationSession::changed, this, &PhotoDialog::showSteps);
    showSteps();
    auto* close = addRowButton(row, tr("OK"));
    close->setObjectName(QStringLiteral("keepPhoto"));
    close->setToolTip(tr("Go back to the organ; what was done to the photo stays"));
    connect(close, &QPushButton::clicked, this, &PhotoDialog::keep);
    auto* cancel = addRowButton(row, tr("Cancel"));
    cancel->setObjectName(QStringLiteral("cancelPhoto"));
    cancel->setToolTip(tr("Put back all that was done in this window, and go back to the organ"));
    connect(cancel, &QPushButton::clicked, this, &PhotoDialog::putBack);
    return row;
}

QPushButton* PhotoDialog::addRowButton(QHBoxLayout* row, const QString& text) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    row->addWidget(button);
    return button;
}

QAction* PhotoDialog::addStepAction(QHBoxLayout* row, const QString& text, const QKeySequence& key) {
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    addAction(action);
    follow(addRowButton(row, text), action);
    return action;
}

void PhotoDialog::showSteps() {
    enable(m_undo, m_session.canUndo(), tr("Undo what was done last in this window"),
           tr("Nothing was done in this window, or something else since"));
    enable(m_redo, m_session.canRedo(), tr("Do again what was undone in this window"),
           tr("Nothing was undone in this window"));
}

void PhotoDialog::keep() {
    if (takesAllNumbers(*this)) accept();
}

void PhotoDialog::putBack() {
    m_session.putBack();
    accept();
}

void PhotoDialog::reject() {
    if (!m_edits.layer() || !m_session.isChanged()) return QDialog::reject();
    QMessageBox box(QMessageBox::Question, tr("Photo"), tr("Keep what was done to the photo?"),
                    QMessageBox::Cancel, this);
    const auto* kept = box.addButton(tr("&Keep"), QMessageBox::AcceptRole);
    const auto* dropped = box.addButton(tr("Put back"), QMessageBox::DestructiveRole);
    setUpBox(box, "keepPhotoBox");
    box.button(QMessageBox::Cancel)->setText(tr("&Go on"));
    box.setInformativeText(tr("What is put back can be brought again with Redo."));
    ask(*this, [&] { return box.exec(); });
    if (box.clickedButton() == kept) keep();
    if (box.clickedButton() == dropped) putBack();
}

void PhotoDialog::choose(PhotoTask task) {
    m_task = task;
    m_tasks->button(static_cast<int>(task))->setChecked(true);
    m_canvas->setTool(toolFor(task));
    const auto page = [&]() -> QWidget* {
        switch (task) {
        case PhotoTask::Field:
            return m_fieldPage;
        case PhotoTask::Erase:
        case PhotoTask::Restore:
            return m_brushPage;
        case PhotoTask::Outline:
        case PhotoTask::Box:
            return m_outlinePage;
        case PhotoTask::Region:
            return m_regionPage;
        case PhotoTask::Highlights:
            return m_highlightPage;
        case PhotoTask::White:
            return m_whitePage;
        case PhotoTask::Adjust:
            return m_adjustPage;
        case PhotoTask::Lens:
            return m_lensPage;
        case PhotoTask::Crop:
            return m_cropPage;
        }
        return nullptr;
    };
    m_pages->setCurrentWidget(page());
    showPhoto();
    showHint(); // what the task does, whatever was told before
}

void PhotoDialog::showPhoto() {
    const TextureLayer* layer = m_edits.layer();
    if (!layer) {
        accept(); // no photo is selected any more
        return;
    }
    setWindowTitle(tr("Photo · %1").arg(QString::fromStdString(layer->name)));
    showPicture(*layer);
    const PhotoPreparation wanted = m_edits.wanted().preparation;
    m_canvas->setStrokes(wanted.strokes);
    m_canvas->setCrop(wanted.crop);
    m_fieldPage->showField();
    if (isStraightened(*layer)) { // both lie on the photo as it was taken
        m_canvas->setField({});
        m_canvas->setStrokes({});
    }
    m_highlightPage->showHighlights();
    m_whitePage->showBalance();
    m_adjustPage->showAdjustment();
    const Image& photo = layer->photo->image;
    const PhotoCrop crop = wanted.crop.value_or(PhotoCrop{0, 0, photo.width, photo.height});
    for (const auto& [part, field] : m_cropFields)
        field->setValue(crop.*part);
    enable(m_whole, wanted.crop.has_value(), tr("Keep the whole photo"), tr("The whole photo is kept"));
    const QString failure = m_edits.failure();
    showHint(failure.isEmpty() ? QString() : tr("Not prepared: %1").arg(failure));
}

/// Whether the photo is shown without what its lens bent.
bool PhotoDialog::isStraightened(const TextureLayer& layer) const {
    const bool showsOutcome = m_task == PhotoTask::Crop || m_task == PhotoTask::Adjust;
    return showsOutcome && layer.preparation.lens && layer.prepared;
}

/// The photo as it was taken; the straightened one for the crop, which lies on what comes out, and all that
/// comes out where colours are adjusted.
void PhotoDialog::showPicture(const TextureLayer& layer) {
    const bool showsPrepared = isStraightened(layer) || m_task == PhotoTask::Adjust;
    const std::shared_ptr<const Image> prepared = showsPrepared ? layer.prepared : nullptr;
    if (m_photo == layer.photo && m_prepared == prepared) return;
    if (m_photo != layer.photo) {
        m_canvas->clearLines();
        m_brushPage->fitTo(layer.photo->image);
    }
    m_photo = layer.photo;
    m_prepared = prepared;
    QImage picture = toQImage(prepared ? *prepared : layer.photo->image);
    picture.reinterpretAsFormat(QImage::Format_RGBX8888); // what is erased is seen as well
    m_canvas->setPicture(picture);
}

void PhotoDialog::showHint(const QString& problem) {
    m_lensPage->showLines();
    QString hint;
    for (const TaskWords& words : taskWords())
        if (words.task == m_task) hint = words.hint;
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
