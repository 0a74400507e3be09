#include "app/editor/panels/tissue/tissue_panel.h"

#include "app/editor/edits/input_edits.h"
#include "app/editor/edits/preset_in_force.h"
#include "app/editor/edits/tissue_edits.h"
#include "app/editor/panels/fuzzy/spare_systems_button.h"
#include "app/editor/panels/tissue/tissue_preset_button.h"
#include "core/authoring/regions.h"
#include "widgets/fuzzy/small_font.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/tab_order.h"

#include <algorithm>

namespace esm {

namespace {

QWidget* emptyColumn(QVBoxLayout* into) {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(10);
    into->addWidget(column);
    return column;
}

/// Whether sliders for the one serve the other, with other terms.
bool hasSameRows(const std::vector<FuzzyVariable>& one, const std::vector<FuzzyVariable>& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const FuzzyVariable& a, const FuzzyVariable& b) {
                          return a.name == b.name && a.unit == b.unit && a.minimum == b.minimum &&
                                 a.maximum == b.maximum;
                      });
}

bool hasSameRows(const FuzzySystem& one, const FuzzySystem& other) {
    return hasSameRows(one.inputs, other.inputs) && hasSameRows(one.outputs, other.outputs);
}

/// The range that the variable speaks of.
NumberFormat sliderFormat(const FuzzyVariable& variable) {
    NumberFormat format;
    format.unit = QString::fromStdString(variable.unit);
    format.minimum = variable.minimum;
    format.maximum = variable.maximum;
    return format;
}

/// The choice, and beside it what can be done with the project's own systems.
QWidget* choiceWithRemoval(FuzzyChoice* choice, Document& document) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(choice, 1);
    row->addWidget(new SpareSystemsButton(document, both));
    both->setFocusProxy(choice);
    return both;
}

ElidedLabel* quietLine(const QString& name, QWidget* parent) {
    auto* line = new ElidedLabel(parent);
    line->setObjectName(name);
    line->setProperty("quiet", true);
    line->setFont(smallFont(line->font()));
    return line;
}

/// What spans decades is shown by ClinicalRows, not by a slider.
bool hasSlider(const FuzzySystem* system, Parameter parameter) {
    const auto output = system ? outputFor(*system, parameter) : std::nullopt;
    return output && !isInClinicalUnits(*system, *output);
}

} // namespace

TissuePanel::TissuePanel(Document& document, Selection& selection, SystemReach& reach, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_reach(reach),
      m_tissue(new Section(tr("Tissue"), this)), m_results(new Section(tr("Results"), this)),
      m_choice(new FuzzyChoice(this)), m_clinical(new ClinicalRows(this)),
      m_stiffening(new StiffeningRow(document, this)), m_bending(new BendingBox(document, this)),
      m_system(new QLabel(this)), m_users(quietLine(QStringLiteral("systemUsers"), this)),
      m_source(quietLine(QStringLiteral("tissueSource"), this)), m_hint(new QLabel(this)),
      m_warnings(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_tissue);
    column->addWidget(m_results);
    m_tissue->addToHeader(new TissuePresetButton(document, selection, this));
    auto* choiceRow = new ValueRows(this);
    choiceRow->addField(tr("Fuzzy system"), choiceWithRemoval(m_choice, document));
    m_tissue->body()->addWidget(choiceRow);
    m_system->setObjectName(QStringLiteral("systemDescription"));
    m_system->setProperty("quiet", true);
    m_system->setWordWrap(true);
    m_tissue->body()->addWidget(m_system);
    m_tissue->body()->addWidget(m_users);
    m_tissue->body()->addWidget(m_source);
    m_hint->setObjectName(QStringLiteral("words"));
    m_hint->setWordWrap(true);
    m_tissue->body()->addWidget(m_hint);
    m_inputs = emptyColumn(m_tissue->body());
    addClinicalRows();
    m_outputs = emptyColumn(m_results->body());
    m_results->body()->addWidget(m_stiffening);
    m_results->body()->addWidget(m_bending);
    m_warnings->setProperty("warning", true);
    m_warnings->setWordWrap(true);
    m_results->body()->addWidget(m_warnings);

    connect(m_choice, &FuzzyChoice::systemChosen, this, &TissuePanel::chooseSystem);
    connect(&selection, &Selection::changed, this, &TissuePanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions || change.spareSystems || change.tissue || change.scene) show();
    });
    connect(&reach, &SystemReach::changed, this, &TissuePanel::showUsers);
    show();
}

void TissuePanel::addClinicalRows() {
    m_results->body()->addWidget(m_clinical);
    connect(m_clinical, &ClinicalRows::youngsModulusEdited, this,
            [this](double pascal) { setYoungsModulus(m_document, m_selection.region(), pascal); });
    connect(m_clinical, &ClinicalRows::relaxationTimeEdited, this,
            [this](double seconds) { setRelaxationTime(m_document, m_selection.region(), seconds); });
    connect(m_clinical, &ClinicalRows::wallThicknessEdited, this, [this](double metres) {
        m_document.edit(
            tr("Set wall thickness"), [metres](Project& project) { project.base.wallThickness = metres; },
            MergeKey(EditKind::WallThickness));
    });
    connect(m_clinical, &ClinicalRows::gestureFinished, &m_document, &Document::finishGesture);
}

const Region* TissuePanel::region() const {
    return m_selection.selectedRegion();
}

void TissuePanel::show() {
    const Region* shown = region();
    const auto system = shown ? shown->system : nullptr;
    followSystem(system);
    m_tissue->setTitle(
        tr("Tissue · %1").arg(shown ? QString::fromStdString(shown->name) : tr("Whole organ")));
    m_choice->setSystem(system, systemsOf(m_document.project()));
    showUsers();
    showSource();
    m_system->setText(m_choice->description());
    m_system->setToolTip(FuzzyChoice::whatItIs());
    m_system->setVisible(!m_system->text().isEmpty());
    m_hint->setText(hint());
    m_hint->setVisible(!m_hint->text().isEmpty());
    const bool isWhole = !shown || !shown->ellipsoid;
    m_stiffening->setVisible(isWhole);
    m_bending->setVisible(isWhole);
    const RegionTissue tissue =
        shown ? evaluate(*shown, m_document.project().base.wallThickness) : RegionTissue{};
    for (const auto& refresh : m_refreshers)
        refresh(shown, tissue);
    showClinically(tissue);
    QStringList warnings;
    for (const auto& warning : tissue.warnings)
        warnings << QString::fromStdString(warning);
    m_warnings->setText(warnings.join('\n'));
    m_warnings->setVisible(!warnings.isEmpty());
}

void TissuePanel::showUsers() {
    const QStringList names = namesOf(m_reach.users());
    m_users->setVisible(!names.isEmpty());
    QString text =
        names.size() == 1 ? tr("used by this region alone") : tr("used by %1 regions").arg(names.size());
    if (m_reach.decided() == Reach::EveryRegion) text += tr(" · changes are for all of them");
    if (m_reach.decided() == Reach::CopyForOne) text += tr(" · a change makes a copy");
    m_users->setText(text);
    m_users->setToolTip(tr("Used by %1").arg(names.join(QStringLiteral(", "))));
}

void TissuePanel::showSource() {
    const auto preset = presetInForce(m_document.project(), region());
    const QString source = preset ? QString::fromStdString(preset->source) : QString();
    m_source->setText(!preset          ? tr("values set here, by no preset")
                      : preset->system ? tr("source: %1").arg(source)
                                       : tr("source of the tethers: %1").arg(source));
    m_source->setToolTip(preset ? QString::fromStdString(preset->title + ": ") + source
                                : tr("The tissue is not, or no longer, as a preset has it"));
}

/// Of what the tissue here is set to; nothing where the region leaves it to what lies beneath.
void TissuePanel::showClinically(const RegionTissue& tissue) {
    const BaseTissue& base = m_document.project().base;
    const Region* shown = region();
    m_clinical->setTissue(
        shown
            ? ClinicalRows::Tissue{tissue.values.springConstant, relaxationTimeOf(tissue), base.wallThickness}
            : ClinicalRows::Tissue{base.springConstant, relaxationTimeOf(base), base.wallThickness});
    m_clinical->showWallThickness(!shown || !shown->ellipsoid);
}

QString TissuePanel::keptNote(const Region& shown, Parameter parameter) {
    const QString kept = m_kept.text(m_document.project(), shown, parameter);
    return kept.isEmpty() ? tr("no rule reaches it") : tr("no rule reaches it: it keeps %1").arg(kept);
}

QString TissuePanel::hint() const {
    const Region* shown = region();
    if (!shown)
        return tr("The tissue of the whole organ, in numbers. Choose a fuzzy system to say it in words.");
    return shown->system ? QString() : tr("No words yet: choose a fuzzy system, or hold values below.");
}

void TissuePanel::followSystem(const std::shared_ptr<const FuzzySystem>& system) {
    const bool isRegion = region() != nullptr;
    if (m_built && system == m_builtFor && isRegion == m_builtForRegion) return;
    // While corners are dragged the rows stay.
    if (!m_built || !m_builtFor || !system || !hasSameRows(*m_builtFor, *system)) return rebuild();
    m_builtFor = system;
    for (const auto& follow : m_followers)
        follow(*system);
}

void TissuePanel::rebuild() {
    const Region* shown = region();
    m_builtFor = shown ? shown->system : nullptr;
    m_builtForRegion = shown != nullptr;
    m_built = true;
    m_refreshers.clear();
    m_followers.clear();
    // A row may be what asked for this: it goes when control is back in the event loop.
    for (QWidget* column : {m_inputs, m_outputs})
        for (QWidget* row : column->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            row->setParent(nullptr);
            row->deleteLater();
        }
    if (m_builtFor)
        for (std::size_t input = 0; input < m_builtFor->inputs.size(); ++input)
            addInput(input);
    m_inputs->setVisible(m_builtFor != nullptr);
    if (m_builtFor)
        for (std::size_t output = 0; output < m_builtFor->outputs.size(); ++output)
            if (!isInClinicalUnits(*m_builtFor, output)) addOutput(output);
    for (const Parameter parameter : everyParameter) {
        // The organ's mass stands beside its size.
        if (!shown && parameter != Parameter::Mass) addBaseParameter(parameter);
        if (shown && !hasSlider(m_builtFor.get(), parameter)) addPlainParameter(parameter);
    }
    tabInLayoutOrder(*this);
}

void TissuePanel::addInput(std::size_t index) {
    const FuzzyVariable& variable = m_builtFor->inputs[index];
    auto* row = new LinguisticSlider(variable, readableName(variable.name), sliderFormat(variable), m_inputs);
    row->setObjectName(QStringLiteral("input-") + QString::fromStdString(variable.name));
    m_inputs->layout()->addWidget(row);
    m_followers.emplace_back(
        [row, index](const FuzzySystem& system) { row->setTerms(system.inputs[index]); });
    const std::string name = variable.name;
    connect(row, &LinguisticSlider::valueEdited, this, [this, name](double value) {
        if (const auto selected = m_selection.region()) editInputs(m_document, *selected, {{name, value}});
    });
    connect(row, &LinguisticSlider::editingFinished, &m_document, &Document::finishGesture);
    m_refreshers.emplace_back([row, name](const Region* shown, const RegionTissue&) {
        row->setValue(valueOf(shown->inputs, name));
    });
}

void TissuePanel::addOutput(std::size_t index) {
    const FuzzyVariable& variable = m_builtFor->outputs[index];
    const auto parameter = parameterOf(*m_builtFor, index);
    const QString name = parameter ? parameterName(*parameter, Extent::Region) : readableName(variable.name);
    auto* row = new LinguisticSlider(
        variable, name, parameter ? parameterFormat(*parameter) : sliderFormat(variable), m_outputs);
    row->setObjectName(QStringLiteral("output-") + QString::fromStdString(variable.name));
    m_outputs->layout()->addWidget(row);
    m_followers.emplace_back(
        [row, index](const FuzzySystem& system) { row->setTerms(system.outputs[index]); });
    if (parameter) return connectOutput(row, *parameter, index);
    row->setReadOnly(tr("The system's own: it sets no tissue"));
    m_refreshers.emplace_back([row, index](const Region*, const RegionTissue& tissue) {
        const auto inferred = tissue.inference.outputs[index];
        row->setValue(inferred);
        row->setNote(inferred ? QString() : tr("no rule reaches it"));
        row->setRemark(tr("sets no tissue"), LinguisticSlider::Manner::Usual);
    });
}

void TissuePanel::connectOutput(LinguisticSlider* row, Parameter parameter, std::size_t index) {
    QToolButton* hold = row->addHoldButton();
    connect(row, &LinguisticSlider::valueEdited, this, [this, parameter](double value) {
        setParameter(m_document, m_selection.region(), parameter, value);
    });
    connect(row, &LinguisticSlider::editingFinished, &m_document, &Document::finishGesture);
    connect(hold, &QToolButton::clicked, this, [this, row, hold, parameter](bool held) {
        if (!held) return letParameterGo(m_document, m_selection.region(), parameter);
        if (const auto value = row->field()->value())
            return holdParameter(m_document, m_selection.region(), parameter, *value);
        // Nothing to hold yet: the number is asked for.
        hold->setChecked(false);
        row->field()->setFocus();
    });
    m_refreshers.emplace_back([=, this](const Region* shown, const RegionTissue& tissue) {
        const auto held = valueOf(shown->held, parameter);
        const auto inferred = tissue.inference.outputs[index];
        row->setValue(held ? held : inferred);
        row->setNote(!held && !inferred ? keptNote(*shown, parameter) : QString());
        const QString says =
            inferred ? tr("the system says %1").arg(withUnit(*inferred, row->field()->format().unit))
                     : tr("no rule reaches it");
        row->setRemark(held ? tr("held; %1").arg(says) : QString(),
                       held ? LinguisticSlider::Manner::Held : LinguisticSlider::Manner::Usual);
        hold->setChecked(held.has_value());
        hold->setToolTip(held ? tr("Let the fuzzy system decide again")
                              : tr("Hold this value, whatever the fuzzy system says"));
    });
}

void TissuePanel::addPlainParameter(Parameter parameter) {
    auto* row = new ParameterRow(parameter, Extent::Region, m_outputs);
    m_outputs->layout()->addWidget(row);
    connect(row, &ParameterRow::valueEdited, this, [this, parameter](double value) {
        setParameter(m_document, m_selection.region(), parameter, value);
    });
    connect(row, &ParameterRow::gestureFinished, &m_document, &Document::finishGesture);
    connect(row, &ParameterRow::released, this,
            [this, parameter] { letParameterGo(m_document, m_selection.region(), parameter); });
    m_refreshers.emplace_back([this, row, parameter](const Region* shown, const RegionTissue& tissue) {
        const bool isHeld = valueOf(shown->held, parameter).has_value();
        const auto inferred = ofSystem(tissue, parameter);
        const QString kept = m_kept.text(m_document.project(), *shown, parameter);
        row->setValue(isHeld ? valueOf(shown->held, parameter) : inferred,
                      isHeld ? ParameterRow::Manner::Held : ParameterRow::Manner::Usual);
        const bool isByTime = parameter == Parameter::Viscosity && tissue.relaxationTime;
        row->setRemark(inferred && !isHeld ? tr("as the system says")
                       : isByTime          ? tr("the time above, times the spring constant beneath")
                       : kept.isEmpty()    ? tr("the region reaches no node")
                       : isHeld            ? tr("in place of %1").arg(kept)
                                           : tr("it keeps %1").arg(kept));
    });
}

/// What the system in clinical units comes to for a parameter.
std::optional<double> TissuePanel::ofSystem(const RegionTissue& tissue, Parameter parameter) const {
    return m_builtFor && outputFor(*m_builtFor, parameter) ? valueOf(tissue.values, parameter) : std::nullopt;
}

void TissuePanel::addBaseParameter(Parameter parameter) {
    auto* row = new ParameterRow(parameter, Extent::Base, m_outputs);
    m_outputs->layout()->addWidget(row);
    connect(row, &ParameterRow::valueEdited, this, [this, parameter](double value) {
        setParameter(m_document, m_selection.region(), parameter, value);
    });
    connect(row, &ParameterRow::gestureFinished, &m_document, &Document::finishGesture);
    m_refreshers.emplace_back([this, row, parameter](const Region*, const RegionTissue&) {
        BaseTissue base = m_document.project().base;
        row->setValue(valueOf(base, parameter));
    });
}

void TissuePanel::chooseSystem(const std::shared_ptr<const FuzzySystem>& system) {
    const auto selected = m_selection.region();
    if (!system && !selected) return;
    const RegionId target = selected ? *selected : m_document.newRegionId();
    m_document.edit(tr("Choose fuzzy system"), [&](Project& project) { setSystem(project, target, system); });
    m_selection.setRegion(target);
}

} // namespace esm
