#include "app/editor/dialogs/export_dialog.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/box_setup.h"
#include "app/editor/dialogs/export_texts.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/dialogs/sentence.h"
#include "app/editor/dialogs/sofa_trial_dialog.h"
#include "core/exchange/simulators/sofa/sofa_run.h"
#include "core/exchange/simulators/sofa/sofa_scene.h"
#include "core/exchange/simulators/sofa/sofa_trial.h"
#include "core/model/gentle_pull.h"
#include "widgets/inputs/action_texts.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/quiet_label.h"
#include "widgets/inputs/refused_numbers.h"

#include <utility>

namespace esm {

namespace {

constexpr int textWidth = 520; // pixels
constexpr int usualLines = 8;  ///< of what will differ, for which room is kept, so that little moves

NumberFormat stepFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("ms");
    format.shownPerValue = 1000;
    format.minimum = 1e-7;
    format.maximum = 1;
    return format;
}

QLabel* wrappedLabel(const char* name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setFixedWidth(textWidth);
    return label;
}

void addField(QFormLayout* form, const QString& caption, QWidget* field, const QString& meaning) {
    field->setToolTip(meaning);
    field->setAccessibleName(withoutMnemonic(caption));
    form->addRow(quietLabel(caption, form->parentWidget(), field), field);
}

} // namespace

ExportDialog::ExportDialog(const Exporter& exporter, const Handover& handover, TriedMotion tried,
                           QWidget* parent)
    : QDialog(parent), m_exporter(exporter), m_handover(handover), m_tried(std::move(tried)),
      m_differences(wrappedLabel("exportDifferences", this)), m_steps(wrappedLabel("exportSteps", this)),
      m_poorStep(wrappedLabel("exportPoorStep", this)), m_finder(exporter, handover) {
    setWindowTitle(tr("Export: %1").arg(QString::fromStdString(exporter.title)));
    setObjectName(QStringLiteral("exportDialog"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    if (exporter.canBeTried) m_program = installedSofa();
    if (m_program) m_settings.sofaVersion = releaseOfProgram(*m_program).value_or(newestSofaVersion);
    if (exporter.isStepped) addSettings(column);
    addWarning(column);
    column->addWidget(new QLabel(tr("What will differ from here"), this));
    m_differences->setTextFormat(Qt::RichText);
    m_differences->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_differences->setMinimumHeight(usualLines * fontMetrics().lineSpacing());
    column->addWidget(m_differences);
    m_steps->setProperty("quiet", true);
    column->addWidget(m_steps);
    column->addStretch();
    addAnswer(column);
    rejectOnEscape(*this);
    enable(m_accepting, false, QString(), tr("What will differ is not known yet"));
    showSearch(0);
    connect(&m_finder, &DifferenceFinder::answered, this, &ExportDialog::takeAnswer);
    look();
}

void ExportDialog::addSettings(QVBoxLayout* column) {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    column->addLayout(form);
    if (m_exporter.hasReleases) addRelease(form);
    addDamping(form);
    addTimeStep(form);
}

void ExportDialog::addRelease(QFormLayout* form) {
    auto* release = new QComboBox(this);
    release->setObjectName(QStringLiteral("exportRelease"));
    for (const auto& [version, word] : wordsOf<SofaVersion>)
        release->addItem(QLatin1String(word), static_cast<int>(version));
    release->setCurrentIndex(release->findData(static_cast<int>(m_settings.sofaVersion)));
    guardFromWheel(*release);
    connect(release, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, release] {
        m_settings.sofaVersion = static_cast<SofaVersion>(release->currentData().toInt());
        look();
    });
    addField(form, tr("&Release"), release, tr("The release that is to load the folder: names differ"));
}

void ExportDialog::addDamping(QFormLayout* form) {
    auto* damping = new QComboBox(this);
    damping->setObjectName(QStringLiteral("exportDamping"));
    damping->addItem(tr("all motion, as here"), static_cast<int>(Damping::Isotropic));
    damping->addItem(tr("along the springs alone"), static_cast<int>(Damping::Axial));
    guardFromWheel(*damping);
    connect(damping, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, damping] {
        m_settings.damping = static_cast<Damping>(damping->currentData().toInt());
        m_settings.timeStep = std::nullopt;
        look();
    });
    addField(form, tr("Viscosity &damps"), damping,
             tr("Along the springs alone, as most engines know it, tissue gives way farther; it then needs "
                "short steps"));
}

void ExportDialog::addTimeStep(QFormLayout* form) {
    m_timeStep = new NumberField(stepFormat(), this);
    m_timeStep->setObjectName(QStringLiteral("exportTimeStep"));
    connect(m_timeStep, &NumberField::valueEdited, this, [this](double step) {
        m_settings.timeStep = step;
        look();
    });
    addField(form, tr("Time &step"), m_timeStep, tr("The step that is written; it can be changed there"));
}

void ExportDialog::addAnswer(QVBoxLayout* column) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_accepting = new QPushButton(tr("&Export"), this);
    m_accepting->setObjectName(QStringLiteral("exportAccept"));
    m_accepting->setProperty("primary", true);
    m_accepting->setDefault(true);
    buttons->addButton(m_accepting, QDialogButtonBox::AcceptRole);
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    if (m_exporter.canBeTried) addTrial(*buttons);
    column->addWidget(buttons);
    connect(m_accepting, &QPushButton::pressed, this,
            [this] { m_wasFoundWhenPressed = m_found.has_value(); });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::addTrial(QDialogButtonBox& buttons) {
    auto* trying = new QPushButton(tr("&Try %1 in SOFA…").arg(m_tried.name), this);
    trying->setObjectName(QStringLiteral("exportTrial"));
    trying->setAutoDefault(false);
    buttons.addButton(trying, QDialogButtonBox::ActionRole);
    const QString meaning =
        tr("Moves the organ here and in SOFA, without its window, and shows both motions over each other. "
           "The project's scene is what is exported; a recorded pull can be made the scene");
    if (!m_program)
        return enable(
            trying, false, meaning,
            tr("SOFA was not found: put its program runSofa on the PATH, or name it with its folder "
               "in the environment's ESM_RUNSOFA"));
    enable(trying, movesTissue(sceneInSofa(m_tried.scene)), meaning,
           tr("Nothing moves the organ: record a poke in the workspace Measure and pull at it, or give the "
              "project a scene with a force or a led node"));
    connect(trying, &QPushButton::clicked, this, &ExportDialog::tryOut);
}

void ExportDialog::tryOut() {
    if (!takesAllNumbers(*this)) return;
    m_acceptsOnceFound = false; // who tries it wants to see that first
    attempt(this, tr("The organ was not tried in SOFA"), [&] {
        const SofaTrial trial = computeLong(
            this, tr("Moving the organ here and in SOFA"),
            [&](const Progress& progress) {
                Project project = m_handover.project;
                project.scene = m_tried.scene;
                HandoverMeans means;
                means.progress = progress;
                means.engine = settings();
                return tryInSofa(*m_program, std::move(project), means);
            },
            Cancelling::Offered);
        SofaTrialDialog(trial, m_tried.name, this).exec();
    });
}

void ExportDialog::addWarning(QVBoxLayout* column) {
    auto* row = new QHBoxLayout;
    row->setSpacing(12);
    m_usualStep = new QPushButton(tr("Take the &usual step"), this);
    m_poorStep->setProperty("warning", true);
    m_usualStep->ensurePolished();
    m_poorStep->setFixedWidth(textWidth - m_usualStep->sizeHint().width() - row->spacing());
    m_usualStep->setObjectName(QStringLiteral("exportUsualStep"));
    m_usualStep->setToolTip(tr("The step that suits the program, in place of your own"));
    m_usualStep->setAutoDefault(false);
    for (QWidget* part : std::initializer_list<QWidget*>{m_poorStep, m_usualStep}) {
        part->hide();
        row->addWidget(part);
    }
    column->addLayout(row);
    connect(m_usualStep, &QPushButton::clicked, this, &ExportDialog::takeUsualStep);
}

void ExportDialog::takeUsualStep() {
    m_settings.timeStep.reset();
    m_timeStep->setModified(false);
    m_timeStep->setFocus();
    look();
}

/// What was told of other settings stays readable, and grey, so that little moves.
void ExportDialog::showAsKnown(bool isKnown) {
    for (QWidget* told : std::initializer_list<QWidget*>{m_differences, m_steps, m_poorStep, m_usualStep})
        told->setEnabled(isKnown);
}

void ExportDialog::look() {
    m_found.reset();
    m_acceptsOnceFound = false;
    showAsKnown(false);
    if (m_timeStep && !m_settings.timeStep && m_timeStep->refusal().isEmpty())
        m_timeStep->setValue(std::nullopt);
    m_finder.look(m_settings);
}

void ExportDialog::takeAnswer() {
    const bool isWorking = m_finder.isWorking(); // asked first, so that what is done is the last there is
    const auto outcome = m_finder.outcome();
    if (isWorking && outcome.answer) showSearch(outcome.answer->share);
    if (isWorking) return;
    if (outcome.failure.empty()) return show(*outcome.answer->differences);
    showFailure(outcome.failure);
}

void ExportDialog::showSearch(double share) {
    m_differences->setText(searchText(share, m_acceptsOnceFound));
}

void ExportDialog::showFailure(const std::string& failure) {
    const QString reason = tr("What will differ was not found. %1.").arg(sentence(failure));
    m_differences->setText(reason.toHtmlEscaped());
    showAsKnown(true);
    for (QWidget* told : std::initializer_list<QWidget*>{m_steps, m_poorStep, m_usualStep})
        told->hide();
    enable(m_accepting, false, QString(), reason);
    adjustSize();
}

void ExportDialog::show(const Differences& differences) {
    m_found = differences;
    m_differences->setText(differencesText(differences));
    m_steps->setText(stepsText(differences));
    m_poorStep->setText(poorStepText(differences));
    m_steps->setVisible(!m_steps->text().isEmpty());
    m_poorStep->setVisible(differences.hasPoorStep());
    m_usualStep->setVisible(differences.hasPoorStep() && m_settings.timeStep);
    showAsKnown(true);
    const bool canBeHandedOver = differences.refusal.empty();
    enable(m_accepting, canBeHandedOver, QString(), tr("The organ cannot be handed over"));
    if (m_timeStep && !m_settings.timeStep && m_timeStep->refusal().isEmpty())
        m_timeStep->setValue(settings().timeStep);
    adjustSize();
    if (std::exchange(m_acceptsOnceFound, false) && canBeHandedOver && !differences.hasPoorStep()) accept();
}

/// With the step that is told, which takes long to find.
EngineSettings ExportDialog::settings() const {
    EngineSettings settings = m_settings;
    if (!settings.timeStep && m_found && !m_found->scheme.empty()) settings.timeStep = m_found->timeStep;
    return settings;
}

void ExportDialog::accept() {
    if (!takesAllNumbers(*this)) return;
    if (!m_found) {
        m_acceptsOnceFound = true;
        return showSearch(0);
    }
    if (m_wasFoundWhenPressed || !m_found->hasPoorStep()) QDialog::accept();
}

void ExportDialog::done(int result) {
    m_finder.disconnect(this);
    m_acceptsOnceFound = false;
    QDialog::done(result);
}

} // namespace esm
