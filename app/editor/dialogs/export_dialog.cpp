#include "app/editor/dialogs/export_dialog.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/box_setup.h"
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
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"
#include "widgets/inputs/refused_numbers.h"

#include <cmath>

namespace esm {

namespace {

constexpr int textWidth = 520; // pixels

NumberFormat stepFormat() {
    NumberFormat format;
    format.unit = QStringLiteral("ms");
    format.shownPerValue = 1000;
    format.minimum = 1e-7;
    format.maximum = 1;
    return format;
}

QString textOf(const Differences& differences) {
    if (!differences.refusal.empty())
        return QObject::tr("It cannot be handed over. %1.")
            .arg(sentence(differences.refusal))
            .toHtmlEscaped();
    if (differences.list.empty())
        return differences.scheme.empty()
                   ? QObject::tr("Nothing is left out.")
                   : QObject::tr("Nothing is left out; steps alone make the motion differ a little.");
    QString text;
    for (const auto& [what, instead] : differences.list)
        text += QStringLiteral("<li>%1:<br/>%2.</li>")
                    .arg(sentence(what).toHtmlEscaped(), QString::fromStdString(instead).toHtmlEscaped());
    return QStringLiteral("<ul style='margin-left: 14px; -qt-list-indent: 0'>%1</ul>").arg(text);
}

QString textOfSteps(const Differences& differences) {
    if (differences.scheme.empty()) return {};
    const QString limit =
        std::isfinite(differences.largestStep)
            ? QObject::tr("Steps longer than %1 ms are not stable.")
                  .arg(numberText(1000 * differences.largestStep))
            : QObject::tr("Steps of any length are stable; shorter ones are nearer to the motion here.");
    return QObject::tr("%1 Stepped by %2.").arg(limit, QString::fromStdString(differences.scheme));
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

ExportDialog::ExportDialog(const Exporter& exporter, const Handover& handover, Scene tried, QWidget* parent)
    : QDialog(parent), m_exporter(exporter), m_handover(handover), m_tried(std::move(tried)),
      m_differences(wrappedLabel("exportDifferences", this)), m_steps(wrappedLabel("exportSteps", this)) {
    setWindowTitle(tr("Export: %1").arg(QString::fromStdString(exporter.title)));
    setObjectName(QStringLiteral("exportDialog"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    if (exporter.canBeTried) m_program = installedSofa();
    if (m_program) m_settings.sofaVersion = releaseOfProgram(*m_program).value_or(newestSofaVersion);
    if (exporter.isStepped) addSettings(column);
    column->addWidget(new QLabel(tr("What will differ from here"), this));
    column->addWidget(m_differences);
    m_steps->setProperty("quiet", true);
    column->addWidget(m_steps);
    column->addStretch();
    addAnswer(column);
    rejectOnEscape(*this);
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
        lookAgain();
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
        lookAgain();
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
        lookAgain();
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
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ExportDialog::addTrial(QDialogButtonBox& buttons) {
    auto* trying = new QPushButton(tr("&Try it in SOFA…"), this);
    trying->setObjectName(QStringLiteral("exportTrial"));
    trying->setAutoDefault(false);
    buttons.addButton(trying, QDialogButtonBox::ActionRole);
    const QString meaning =
        tr("Moves the organ here and in SOFA, without its window, and shows both motions over each other: "
           "the recorded pull, or else the project's scene");
    if (!m_program)
        return enable(
            trying, false, meaning,
            tr("SOFA was not found: put its program runSofa on the PATH, or name it with its folder "
               "in the environment's ESM_RUNSOFA"));
    enable(trying, movesTissue(sceneInSofa(m_tried)), meaning,
           tr("Nothing moves the organ: record a poke in the workspace Measure and pull at it, or give the "
              "project a scene with a force or a led node"));
    connect(trying, &QPushButton::clicked, this, &ExportDialog::tryOut);
}

void ExportDialog::tryOut() {
    if (!takesAllNumbers(*this)) return;
    attempt(this, tr("The organ was not tried in SOFA"), [&] {
        const SofaTrial trial = computeLong(
            this, tr("Moving the organ here and in SOFA"),
            [&](const Progress& progress) {
                Project project = m_handover.project;
                project.scene = m_tried;
                return tryInSofa(*m_program, std::move(project), meansNow(progress));
            },
            Cancelling::Offered);
        SofaTrialDialog(trial, this).exec();
    });
}

HandoverMeans ExportDialog::meansNow(const Progress& progress) const {
    HandoverMeans means;
    means.progress = progress;
    means.engine = m_settings;
    return means;
}

/// The largest step of a large organ takes a while.
void ExportDialog::look() {
    show(computeLong(
        isVisible() ? this : parentWidget(), tr("Looking for what will differ"),
        [this](const Progress& progress) {
            return differencesOf(m_handover, m_exporter, meansNow(progress));
        },
        Cancelling::Offered));
}

/// After a change. Who gives that up, gives the export up.
void ExportDialog::lookAgain() {
    if (!attempt(this, tr("What will differ was not found"), [this] { look(); })) reject();
}

void ExportDialog::show(const Differences& differences) {
    m_differences->setText(textOf(differences));
    m_steps->setText(textOfSteps(differences));
    m_steps->setVisible(!m_steps->text().isEmpty());
    enable(m_accepting, differences.refusal.empty(), QString(), tr("The organ cannot be handed over"));
    m_toldStep.reset();
    if (!differences.scheme.empty()) m_toldStep = differences.timeStep;
    if (m_timeStep && m_timeStep->refusal().isEmpty()) m_timeStep->setValue(m_toldStep);
    adjustSize();
}

/// With the step that is told, which takes long to find.
EngineSettings ExportDialog::settings() const {
    EngineSettings settings = m_settings;
    if (!settings.timeStep) settings.timeStep = m_toldStep;
    return settings;
}

void ExportDialog::accept() {
    if (takesAllNumbers(*this)) QDialog::accept();
}

} // namespace esm
