#include "app/editor/panels/tissue_panel.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::array<Parameter, 3> parameters{Parameter::SpringConstant, Parameter::Viscosity,
                                              Parameter::Mass};

QWidget* emptyColumn(QVBoxLayout* into) {
    auto* column = new QWidget;
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 4, 0, 0);
    layout->setSpacing(14);
    into->addWidget(column);
    return column;
}

/// What may be typed for an input: the range the variable speaks of.
NumberFormat inputFormat(const FuzzyVariable& variable) {
    NumberFormat format;
    format.minimum = variable.minimum;
    format.maximum = variable.maximum;
    return format;
}

/// "flexible 0.92, medium 0.08", or why there are no words for a value.
QString said(const FuzzyVariable& variable, std::optional<double> value) {
    if (!value) return QObject::tr("left out");
    const std::string words = inWords(variable, *value);
    return words == "none" ? QObject::tr("between the words") : readableName(words);
}

std::optional<double> inputValue(const Region& region, const std::string& variable) {
    const auto found = std::find_if(region.inputs.begin(), region.inputs.end(),
                                    [&](const auto& input) { return input.first == variable; });
    return found != region.inputs.end() ? std::optional(found->second) : std::nullopt;
}

} // namespace

TissuePanel::TissuePanel(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection),
      m_tissue(new Section(tr("Tissue"), this)), m_results(new Section(tr("Results"), this)),
      m_choice(new FuzzyChoice(this)), m_stiffening(new StiffeningRow(document, this)),
      m_system(new QLabel(this)), m_words(new QLabel(this)), m_warnings(new QLabel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_tissue);
    column->addWidget(m_results);
    auto* choiceRow = new ValueRows(this);
    choiceRow->addField(tr("Fuzzy system"), m_choice);
    m_tissue->body()->addWidget(choiceRow);
    m_system->setObjectName(QStringLiteral("systemDescription"));
    m_system->setProperty("quiet", true);
    m_system->setWordWrap(true);
    m_tissue->body()->addWidget(m_system);
    m_words->setObjectName(QStringLiteral("words"));
    m_words->setWordWrap(true);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_tissue->body()->addWidget(m_words);
    m_inputs = emptyColumn(m_tissue->body());
    m_outputs = emptyColumn(m_results->body());
    m_results->body()->addWidget(m_stiffening);
    m_warnings->setProperty("warning", true);
    m_warnings->setWordWrap(true);
    m_results->body()->addWidget(m_warnings);

    connect(m_choice, &FuzzyChoice::systemChosen, this, &TissuePanel::chooseSystem);
    connect(&selection, &Selection::changed, this, &TissuePanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions || change.tissue) show();
    });
    show();
}

const Region* TissuePanel::region() const {
    const auto selected = m_selection.region();
    return selected ? &m_document.project().regions[*selected] : nullptr;
}

void TissuePanel::show() {
    const Region* shown = region();
    const auto system = shown ? shown->system : nullptr;
    if (!m_built || system != m_builtFor || (shown != nullptr) != m_builtForRegion) rebuild();
    m_tissue->setTitle(
        tr("Tissue · %1").arg(shown ? QString::fromStdString(shown->name) : tr("Whole organ")));
    m_choice->setSystem(system);
    m_system->setText(m_choice->description());
    m_system->setToolTip(FuzzyChoice::whatItIs());
    m_system->setVisible(!m_system->text().isEmpty());
    m_words->setText(words());
    m_stiffening->setVisible(!shown || !shown->ellipsoid);
    const RegionTissue tissue = shown ? evaluate(*shown) : RegionTissue{};
    for (const auto& refresh : m_refreshers)
        refresh(shown, tissue);
    QStringList warnings;
    for (const auto& warning : tissue.warnings)
        warnings << QString::fromStdString(warning);
    m_warnings->setText(warnings.join('\n'));
    m_warnings->setVisible(!warnings.isEmpty());
}

QString TissuePanel::words() const {
    const Region* shown = region();
    if (!shown)
        return tr("The tissue of the whole organ, in numbers. Choose a fuzzy system to say it in words.");
    if (!shown->system) return tr("No words yet: choose a fuzzy system, or hold values below.");
    QStringList lines;
    for (const auto& variable : shown->system->inputs) {
        const QString words = said(variable, inputValue(*shown, variable.name));
        lines << (shown->system->inputs.size() > 1 ? readableName(variable.name) + ": " + words : words);
    }
    return lines.join('\n');
}

void TissuePanel::rebuild() {
    const Region* shown = region();
    m_builtFor = shown ? shown->system : nullptr;
    m_builtForRegion = shown != nullptr;
    m_built = true;
    m_refreshers.clear();
    // A row may be what asked for this: it goes when control is back in the event loop.
    for (QWidget* column : {m_inputs, m_outputs})
        for (QWidget* row : column->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            row->setParent(nullptr);
            row->deleteLater();
        }
    if (m_builtFor)
        for (const auto& variable : m_builtFor->inputs)
            addInput(variable);
    m_inputs->setVisible(m_builtFor != nullptr);
    for (const Parameter parameter : parameters) {
        const auto output = m_builtFor ? outputFor(*m_builtFor, parameter) : std::nullopt;
        if (!shown) {
            // The organ's mass stands beside its size.
            if (parameter != Parameter::Mass) addBaseParameter(parameter);
        } else if (output)
            addOutput(parameter, *output);
        else
            addPlainParameter(parameter);
    }
}

void TissuePanel::addInput(const FuzzyVariable& variable) {
    auto* row = new LinguisticSlider(variable, readableName(variable.name), inputFormat(variable), m_inputs);
    row->setObjectName(QStringLiteral("input-") + QString::fromStdString(variable.name));
    m_inputs->layout()->addWidget(row);
    const std::string name = variable.name;
    connect(row, &LinguisticSlider::valueEdited, this, [this, name](double value) {
        const auto selected = m_selection.region();
        m_document.edit(
            tr("Set %1").arg(readableName(name)),
            [&](Project& project) { setInput(project.regions[*selected], name, value); },
            QStringLiteral("input %1 %2").arg(*selected).arg(QString::fromStdString(name)));
    });
    connect(row, &LinguisticSlider::editingFinished, &m_document, &Document::finishGesture);
    m_refreshers.emplace_back(
        [row, name](const Region* shown, const RegionTissue&) { row->setValue(inputValue(*shown, name)); });
}

void TissuePanel::addOutput(Parameter parameter, std::size_t index) {
    const FuzzyVariable& variable = m_builtFor->outputs[index];
    auto* row = new LinguisticSlider(variable, parameterName(parameter, Extent::Region),
                                     parameterFormat(parameter), m_outputs);
    row->setObjectName(QStringLiteral("output-") + QString::fromStdString(variable.name));
    m_outputs->layout()->addWidget(row);
    QToolButton* hold = row->addHoldButton();
    connect(row, &LinguisticSlider::valueEdited, this,
            [this, parameter](double value) { setHeld(parameter, value, Merging::WhileMoved); });
    connect(row, &LinguisticSlider::editingFinished, &m_document, &Document::finishGesture);
    connect(hold, &QToolButton::clicked, this, [this, row, hold, parameter](bool held) {
        if (held && !row->field()->value()) return hold->setChecked(false);
        setHeld(parameter, held ? row->field()->value() : std::nullopt);
    });
    m_refreshers.emplace_back([row, hold, parameter, index](const Region* shown, const RegionTissue& tissue) {
        const auto held = valueOf(shown->held, parameter);
        const auto inferred = tissue.inference.outputs[index];
        row->setValue(held ? held : inferred);
        row->setNote(!held && !inferred ? tr("no rule reaches it: it keeps its value") : QString());
        hold->setChecked(held.has_value());
        hold->setToolTip(held ? tr("Let the fuzzy system decide again")
                              : tr("Hold this value, whatever the fuzzy system says"));
    });
}

void TissuePanel::addPlainParameter(Parameter parameter) {
    auto* row = new ParameterRow(parameter, Extent::Region, m_outputs);
    m_outputs->layout()->addWidget(row);
    connect(row, &ParameterRow::valueEdited, this,
            [this, parameter](double value) { setHeld(parameter, value, Merging::WhileMoved); });
    connect(row, &ParameterRow::gestureFinished, &m_document, &Document::finishGesture);
    connect(row, &ParameterRow::released, this, [this, parameter] { setHeld(parameter, std::nullopt); });
    m_refreshers.emplace_back([row, parameter](const Region* shown, const RegionTissue&) {
        row->setValue(valueOf(shown->held, parameter));
    });
}

void TissuePanel::addBaseParameter(Parameter parameter) {
    auto* row = new ParameterRow(parameter, Extent::Base, m_outputs);
    m_outputs->layout()->addWidget(row);
    connect(row, &ParameterRow::valueEdited, this, [this, parameter](double value) {
        const QString name = parameterName(parameter, Extent::Base);
        m_document.edit(
            tr("Set %1").arg(name), [&](Project& project) { valueOf(project.base, parameter) = value; },
            QStringLiteral("base %1").arg(static_cast<int>(parameter)));
    });
    connect(row, &ParameterRow::gestureFinished, &m_document, &Document::finishGesture);
    m_refreshers.emplace_back([this, row, parameter](const Region*, const RegionTissue&) {
        BaseTissue base = m_document.project().base;
        row->setValue(valueOf(base, parameter));
    });
}

void TissuePanel::setHeld(Parameter parameter, std::optional<double> value, Merging merging) {
    const auto selected = m_selection.region();
    if (!selected) return;
    const QString name = parameterName(parameter, Extent::Region);
    m_document.edit((value ? tr("Hold %1") : tr("Let go of %1")).arg(name),
                    [&](Project& project) { valueOf(project.regions[*selected].held, parameter) = value; },
                    merging == Merging::WhileMoved
                        ? QStringLiteral("held %1 %2").arg(*selected).arg(static_cast<int>(parameter))
                        : QString());
}

void TissuePanel::chooseSystem(const std::shared_ptr<const FuzzySystem>& system) {
    const auto selected = m_selection.region();
    if (!system && !selected) return;
    std::size_t target = 0;
    m_document.edit(tr("Choose fuzzy system"),
                    [&](Project& project) { target = setSystem(project, selected, system); });
    m_selection.setRegion(target);
}

} // namespace esm
