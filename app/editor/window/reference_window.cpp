#include "app/editor/window/reference_window.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/open_dialog.h"
#include "core/texture/photo/photo_format.h"
#include "widgets/inputs/control_keys.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

const QString referenceGeometryKey = QStringLiteral("referenceWindow");

/// What an choiceData of the choice shows: layers by their number, opened files by their place.
enum class ReferenceSource { Selected, Layer, File };

QVariantList choiceData(ReferenceSource shown, int number) {
    return {static_cast<int>(shown), number};
}

} // namespace

ReferenceWindow::ReferenceWindow(Document& document, Selection& selection, QWidget* parent)
    : QDialog(parent, Qt::Tool), m_document(document), m_selection(selection), m_choice(new QComboBox(this)),
      m_view(new PhotoView(this)) {
    setObjectName(QStringLiteral("referenceWindow"));
    setWindowTitle(tr("Photo beside the view"));
    resize(460, 420);
    layOut();
    restoreGeometry(QSettings().value(referenceGeometryKey).toByteArray());
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.layers) fillChoice();
    });
    connect(&selection, &Selection::changed, this, &ReferenceWindow::showChosen);
    fillChoice();
}

ReferenceWindow::~ReferenceWindow() {
    QSettings().setValue(referenceGeometryKey, saveGeometry());
}

void ReferenceWindow::layOut() {
    auto* caption = new QLabel(tr("&Picture"), this);
    caption->setProperty("quiet", true);
    caption->setBuddy(m_choice);
    m_choice->setAccessibleName(tr("Picture"));
    m_choice->setObjectName(QStringLiteral("referenceChoice"));
    m_choice->setToolTip(tr("The selected photo, one of the project's, or a picture that was opened here"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    guardFromWheel(*m_choice);
    auto* open = new QPushButton(tr("&Open…"), this);
    open->setToolTip(tr("Show a picture that is no photo of the project"));
    open->setAutoDefault(false);
    m_view->setObjectName(QStringLiteral("referenceView"));
    m_view->setAccessibleName(tr("Photo beside the view"));
    m_view->setToolTip(tr("Come closer with the wheel, shift with a drag"));
    auto* bar = new QHBoxLayout;
    bar->addWidget(caption);
    bar->addWidget(m_choice, 1);
    bar->addWidget(open);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(8);
    column->addLayout(bar);
    column->addWidget(m_view, 1);
    connect(m_choice, qOverload<int>(&QComboBox::currentIndexChanged), this, &ReferenceWindow::showChosen);
    connect(open, &QPushButton::clicked, this, &ReferenceWindow::chooseAFile);
}

void ReferenceWindow::chooseAFile() {
    const QString filter = fileFilter(tr("Photos"), photoFileEndings()) + tr(";;All files (*)");
    if (const auto file = chooseFile(this, tr("Open picture"), FileKind::Photo, filter, m_document.path()))
        showFile(*file);
}

void ReferenceWindow::showFile(const std::filesystem::path& file) {
    attempt(this, tr("The picture cannot be shown"), [&] {
        const auto photo = computeLong(
            this, tr("Reading %1").arg(fileName(file)),
            [&](const Progress& progress) { return loadPhoto(file, progress); }, Cancelling::Offered);
        m_opened.push_back({fileName(file), {photo, &photo->image}});
        fillChoice();
        m_choice->setCurrentIndex(m_choice->count() - 1);
    });
}

/// What was chosen stays chosen while it is there.
void ReferenceWindow::fillChoice() {
    const QVariant before = m_choice->currentData();
    {
        const QSignalBlocker quiet(m_choice);
        m_choice->clear();
        m_choice->addItem(tr("Selected photo"), choiceData(ReferenceSource::Selected, 0));
        for (const TextureLayer& layer : m_document.project().layers)
            if (layer.photo)
                m_choice->addItem(QString::fromStdString(layer.name),
                                  choiceData(ReferenceSource::Layer, static_cast<int>(layer.id.number)));
        for (std::size_t i = 0; i < m_opened.size(); ++i)
            m_choice->addItem(m_opened[i].name, choiceData(ReferenceSource::File, static_cast<int>(i)));
        m_choice->setCurrentIndex(std::max(0, m_choice->findData(before)));
    }
    showChosen();
}

std::shared_ptr<const Image> ReferenceWindow::chosen() const {
    const QVariantList what = m_choice->currentData().toList();
    const int number = what[1].toInt();
    const auto shown = static_cast<ReferenceSource>(what[0].toInt());
    if (shown == ReferenceSource::File) return m_opened[static_cast<std::size_t>(number)].picture;
    const TextureLayer* layer =
        shown == ReferenceSource::Selected
            ? m_selection.selectedLayer()
            : findPart(m_document.project().layers, LayerId{static_cast<std::uint32_t>(number)});
    return layer && layer->photo ? pictureOf(*layer) : nullptr;
}

void ReferenceWindow::showChosen() {
    const auto picture = chosen();
    m_view->setPicture(picture);
    m_view->setHint(picture ? QString() : tr("No photo is selected"));
}

} // namespace esm
