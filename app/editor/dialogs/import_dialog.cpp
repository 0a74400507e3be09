#include "app/editor/dialogs/import_dialog.h"

#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/extent_text.h"
#include "app/editor/dialogs/import_report.h"
#include "app/editor/dialogs/preview_background.h"
#include "core/authoring/import_unit.h"
#include "core/solid/prism_wall.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"
#include "widgets/inputs/refused_numbers.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>
#include <array>

namespace esm {

namespace {

constexpr std::array<LengthUnit, 3> units{LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre};

void addChoice(QFormLayout* form, const QString& caption, QComboBox* choice, const QString& toolTip) {
    QLabel* label = quietLabel(caption, choice->parentWidget(), choice);
    choice->setAccessibleName(withoutMnemonic(caption));
    choice->setToolTip(toolTip);
    guardFromWheel(*choice);
    form->addRow(label, choice);
}

/// Lets the fields of two forms, one below the other, begin in one line.
void alignFields(const std::array<const QFormLayout*, 2>& forms) {
    std::vector<QWidget*> labels;
    for (const QFormLayout* form : forms)
        for (int row = 0; row < form->rowCount(); ++row)
            if (QLayoutItem* label = form->itemAt(row, QFormLayout::LabelRole))
                labels.push_back(label->widget());
    int widest = 0;
    for (const QWidget* label : labels)
        widest = std::max(widest, label->sizeHint().width());
    for (QWidget* label : labels)
        label->setMinimumWidth(widest);
}

QString trianglesText(std::size_t count) {
    return count == 1 ? QObject::tr("1 triangle") : QObject::tr("%1 triangles").arg(countText(count));
}

/// Of the list of findings, as high as the window allows; more scroll.
constexpr int fewestReportLines = 5, mostReportLines = 11;

/// More parts than these are crumbs, or no organ.
constexpr std::size_t mostPartsListed = 12;

} // namespace

RepairOptions repairOptions(const ImportChoice& choice) {
    return {0, choice.keep, choice.slitWidth, choice.holeEdges};
}

ImportDialog::ImportDialog(const QString& fileName, std::shared_ptr<const PolygonSoup> soup,
                           std::shared_ptr<const ImportedSurface> found, QWidget* parent)
    : QDialog(parent), m_found(std::move(found)), m_shown(m_found),
      m_importer(std::move(soup), m_found, this), m_view(new OrganView(this)),
      m_openings(new OpeningOptions(
          m_found, recommendedUnit(m_found->extent.maxCoeff(), meshFileEnding(fileName.toStdString())),
          this)),
      m_units(new QButtonGroup(this)), m_up(new QComboBox(this)), m_keep(new QComboBox(this)),
      m_body(new BodyQuestion(this)), m_size(new QLabel(this)), m_doubt(new QLabel(this)),
      m_report(new QPlainTextEdit(this)), m_accept(new QPushButton(tr("&Import"), this)) {
    setWindowTitle(tr("Import organ surface"));
    setObjectName(QStringLiteral("importDialog"));
    m_view->setAccessibleName(tr("Preview of the surface"));
    m_view->setHint(tr("The preview is being made …"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addLayout(makePicture(), 1);
    row->addWidget(makeQuestions(fileName));
    column->addLayout(row, 1);
    addButtons(column);
    // The preview and other widgets would keep it for themselves.
    rejectOnEscape(*this);
    connect(m_openings, &OpeningOptions::changed, this, &ImportDialog::lookAgain);
    connect(m_body, &BodyQuestion::changed, this, &ImportDialog::showWhetherPossible);
    connect(&m_importer, &SurfaceImporter::answered, this, &ImportDialog::takeAnswer);
    connect(m_view, &OrganView::drawn, this, [this] {
        if (m_view->scene().mesh)
            m_view->setHint(tr("Open borders are amber · drag to turn · the wheel comes nearer"));
    });
    showKept();
    lookAgain();
    resize(1120, 820);
}

/// The preview, and what was found in the file below it.
QVBoxLayout* ImportDialog::makePicture() {
    auto* column = new QVBoxLayout;
    column->setSpacing(8);
    column->addWidget(m_view, 2);
    addReport(column);
    return column;
}

/// They scroll where the screen is low.
QWidget* ImportDialog::makeQuestions(const QString& fileName) {
    auto* questions = new QWidget;
    questions->setObjectName(QStringLiteral("importQuestions"));
    auto* column = new QVBoxLayout(questions);
    column->setContentsMargins(0, 0, 8, 0);
    column->setSpacing(12);
    auto* title = new QLabel(fileName, this);
    title->setProperty("strong", true);
    column->addWidget(title);
    addUnits(column, recommendedUnit(m_found->extent.maxCoeff(), meshFileEnding(fileName.toStdString())));
    addParts();
    addOrientation(column);
    column->addWidget(m_body);
    column->addWidget(m_openings);
    column->addStretch();
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(questions);
    area->setMinimumWidth(questions->sizeHint().width() + area->verticalScrollBar()->sizeHint().width());
    return area;
}

void ImportDialog::addParts() {
    const std::size_t parts = m_found->parts.size();
    m_keep->setObjectName(QStringLiteral("importKeep"));
    m_keep->addItem(parts <= 1 ? tr("the one part") : tr("all %1 parts").arg(parts));
    m_keep->addItem(parts <= 1
                        ? tr("the largest part")
                        : tr("the largest part: %1").arg(trianglesText(m_found->parts.front().triangles)));
    m_keep->setEnabled(parts > 1);
    connect(m_keep, qOverload<int>(&QComboBox::currentIndexChanged), this, &ImportDialog::lookAgain);
}

void ImportDialog::addButtons(QVBoxLayout* column) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accept->setProperty("primary", true);
    buttons->addButton(m_accept, QDialogButtonBox::AcceptRole);
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Keep the organ that there is"));
    m_accept->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ImportDialog::addUnits(QVBoxLayout* column, LengthUnit likely) {
    column->addWidget(quietLabel(tr("One unit in the file is one …"), this));
    auto* row = new QHBoxLayout;
    const std::array<QString, 3> names{tr("&millimetre"), tr("&centimetre"), tr("m&etre")};
    for (std::size_t i = 0; i < units.size(); ++i) {
        auto* button = new QRadioButton(names[i], this);
        button->setObjectName(QStringLiteral("unit%1").arg(i));
        button->setToolTip(tr("Lengths in the file count as this unit"));
        button->setChecked(units[i] == likely);
        m_units->addButton(button, static_cast<int>(i));
        row->addWidget(button);
    }
    row->addStretch();
    column->addLayout(row);
    connect(m_units, &QButtonGroup::idClicked, this, [this] {
        m_openings->setUnit(choice().unit);
        showKept();
        lookAgain();
    });
}

void ImportDialog::addOrientation(QVBoxLayout* column) {
    for (const auto& [axis, name] :
         {std::pair{UpAxis::Y, tr("y axis")}, std::pair{UpAxis::Z, tr("z axis")},
          std::pair{UpAxis::X, tr("x axis")}, std::pair{UpAxis::MinusY, tr("−y, the y axis points down")},
          std::pair{UpAxis::MinusZ, tr("−z, the z axis points down")},
          std::pair{UpAxis::MinusX, tr("−x, the x axis points down")}})
        m_up->addItem(name, static_cast<int>(axis));
    connect(m_up, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        showKept();
        lookAgain();
    });
    m_size->setObjectName(QStringLiteral("importSize"));
    m_size->setProperty("strong", true);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    form->addRow(quietLabel(tr("Size of the organ"), this), m_size);
    m_doubt->setObjectName(QStringLiteral("importDoubt"));
    m_doubt->setProperty("warning", true);
    m_doubt->setWordWrap(true);
    // The room for it is kept, so that nothing moves.
    m_doubt->setFixedHeight(2 * m_doubt->fontMetrics().lineSpacing());
    m_doubt->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    form->addRow(m_doubt);
    addChoice(form, tr("&Upwards in the file"), m_up,
              tr("Which axis of the file points up: where the organ stands on its head, "
                 "the one with the minus sign"));
    addChoice(form, tr("&Keep"), m_keep,
              m_keep->isEnabled() ? tr("Which parts of the file become the organ")
                                  : tr("The surface is one part"));
    column->addLayout(form);
    if (const auto* below = qobject_cast<QFormLayout*>(m_body->layout())) alignFields({form, below});
}

void ImportDialog::showWhetherPossible() {
    const QString refusal = m_body->refusal();
    enable(m_accept, refusal.isEmpty(), tr("Make an organ of the surface as it is shown"), refusal);
}

void ImportDialog::addReport(QVBoxLayout* column) {
    column->addWidget(quietLabel(tr("&Repaired and found"), this, m_report));
    m_report->setObjectName(QStringLiteral("importReport"));
    m_report->setToolTip(tr("What was repaired in the file, and what its parts are"));
    m_report->setReadOnly(true);
    m_report->setTabChangesFocus(true);
    const int line = m_report->fontMetrics().lineSpacing();
    m_report->setMinimumHeight(fewestReportLines * line);
    m_report->setMaximumHeight(mostReportLines * line);
    column->addWidget(m_report, 1);
}

void ImportDialog::lookAgain() {
    const ImportChoice chosen = choice();
    ImportQuestion question{repairOptions(chosen), chosen.unit, chosen.up};
    question.options.slitWidth /= metresPer(chosen.unit);
    m_importer.look(question);
    m_openings->showDone(nullptr);
}

void ImportDialog::takeAnswer() {
    if (m_isAnswered) return; // it was told before, and the importer may be no more
    if (m_importer.isWorking()) return;
    const auto outcome = m_importer.outcome();
    if (outcome.number == m_answer) return;
    m_answer = outcome.number;
    if (!outcome.failure.empty()) return m_report->setPlainText(QString::fromStdString(outcome.failure));
    m_shown = outcome.answer->surface;
    showKept();
    m_openings->showDone(m_shown.get());
    showPreview(outcome.answer->preview);
}

void ImportDialog::accept() {
    if (takesAllNumbers(*this)) QDialog::accept();
}

int ImportDialog::exec() {
    m_isAnswered = false;
    takeAnswer();
    return QDialog::exec();
}

void ImportDialog::done(int result) {
    m_isAnswered = true;
    QDialog::done(result);
}

/// Where the surface has another size or stands another way than before, the camera does not fit any more.
void ImportDialog::showPreview(const RenderScene& preview) {
    const auto boxOf = [](const RenderScene& scene) {
        return scene.mesh ? boundingBox(scene.mesh->vertices) : Eigen::AlignedBox3d();
    };
    const bool isElsewhere = !boxOf(preview).isApprox(boxOf(m_view->scene()), 0.05);
    RenderScene scene = preview;
    setBackground(scene, *this);
    m_view->setScene(std::move(scene));
    if (isElsewhere) m_view->frameOrgan();
}

QString ImportDialog::sizeText(const Eigen::Vector3d& extent) const {
    const Eigen::Vector3d size = extent * metresPer(choice().unit);
    const Eigen::Vector3d shown = (turnedUp(choice().up) * size).cwiseAbs();
    return lengthsText({shown.x(), shown.y(), shown.z()});
}

QStringList ImportDialog::partLines() const {
    const auto& parts = m_found->parts;
    if (parts.size() <= 1) return {};
    QStringList lines{tr("Parts in the file:")};
    const std::size_t listed = std::min(parts.size(), mostPartsListed);
    for (std::size_t i = 0; i < listed; ++i)
        lines
            << tr("%1: %2, %3").arg(i + 1).arg(trianglesText(parts[i].triangles), sizeText(parts[i].extent));
    if (listed < parts.size()) lines << tr("… and %1 smaller ones").arg(parts.size() - listed);
    return lines;
}

void ImportDialog::showKept() {
    m_report->setPlainText((reportLines(*m_shown) + partLines()).join('\n'));
    m_size->setText(sizeText(m_shown->extent));
    m_doubt->setText(doubtfulExtent(m_shown->extent.maxCoeff(), choice().unit));
    m_body->setSurface(m_shown->mesh->vertices.size(), m_shown->report.isClosed(),
                       meanEdgeOf(*m_shown->mesh) * metresPer(choice().unit));
}

ImportChoice ImportDialog::choice() const {
    ImportChoice choice;
    choice.unit = units[static_cast<std::size_t>(qMax(0, m_units->checkedId()))];
    choice.up = static_cast<UpAxis>(m_up->currentData().toInt());
    choice.keep = keptParts();
    choice.slitWidth = m_openings->slitWidth();
    choice.holeEdges = m_openings->holeEdges();
    choice.body = m_body->choice();
    return choice;
}

} // namespace esm
