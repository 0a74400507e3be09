#include "app/editor/panels/fuzzy_choice.h"

#include "app/editor/commands/ask.h"
#include "app/editor/commands/attempt.h"
#include "app/editor/commands/fuzzy_files.h"
#include "core/exchange/fuzzy_file.h"
#include "core/fuzzy/system_edits.h"
#include "core/support/errors.h"
#include "widgets/fuzzy/term_scale.h"

#include <QAbstractItemView>
#include <QInputDialog>
#include <QLineEdit>
#include <QStylePainter>
#include <QWheelEvent>

#include <algorithm>

namespace esm {

namespace {

constexpr int nameRole = Qt::UserRole + 1, placeRole = Qt::UserRole + 2;

bool isPreset(const std::string& name) {
    const auto names = fuzzyPresetNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// "robo-sim: consistency, sensitiveness, shiftability": what the user will be asked for.
QString withInputs(const QString& name, const FuzzySystem& system) {
    QStringList inputs;
    for (const FuzzyVariable& input : system.inputs)
        inputs << readableName(input.name);
    return QStringLiteral("%1: %2").arg(name, inputs.join(QStringLiteral(", ")));
}

} // namespace

QString shownName(const FuzzySystem& system) {
    const QString name = QString::fromStdString(system.name);
    return isPreset(system.name) && !isFuzzyPreset(system) ? QObject::tr("%1 (changed)").arg(name) : name;
}

FuzzyChoice::FuzzyChoice(QWidget* parent) : QComboBox(parent) {
    setObjectName(QStringLiteral("systemChoice"));
    setAccessibleName(tr("Fuzzy system"));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(10);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, qOverload<int>(&QComboBox::activated), this, &FuzzyChoice::choose);
    recognise();
    fill();
}

void FuzzyChoice::setSystem(const System& system, const std::vector<System>& project) {
    if (system == m_system && project == m_project) return;
    m_system = system;
    m_project = project;
    recognise();
    fill();
}

QString FuzzyChoice::whatItIs() {
    return tr(
        "A fuzzy system turns words such as “soft” or “wobbly” into numbers: its rules say which spring "
        "constant and viscosity belong to which words.");
}

void FuzzyChoice::recognise() {
    m_isPreset = m_system && isFuzzyPreset(*m_system);
    if (!m_system)
        m_description = whatItIs();
    else
        m_description = QString::fromStdString(m_isPreset ? fuzzyPreset(m_system->name).description
                                                          : m_system->description);
    m_others.clear();
    for (const System& system : m_project) {
        const auto isIt = [&](const System& known) { return known == system || *known == *system; };
        if (!(m_system && isIt(m_system)) && std::none_of(m_others.begin(), m_others.end(), isIt) &&
            !isFuzzyPreset(*system))
            m_others.push_back(system);
    }
}

void FuzzyChoice::add(const QString& name, Kind kind, const FuzzySystem& system) {
    addItem(withInputs(name, system), kind);
    setItemData(count() - 1, name, nameRole);
    setItemData(count() - 1, QString::fromStdString(system.description + "\n\n" + system.note).trimmed(),
                Qt::ToolTipRole);
}

void FuzzyChoice::fill() {
    clear();
    addItem(tr("no fuzzy system"), NoSystem);
    setItemData(0, currentText(), nameRole);
    setItemData(0, tr("Numbers only"), Qt::ToolTipRole);
    for (const auto& name : fuzzyPresetNames())
        add(QString::fromStdString(name), Preset, fuzzyPreset(name));
    if (m_system) {
        const QString name = QString::fromStdString(m_system->name);
        if (m_isPreset) {
            setCurrentIndex(findData(name, nameRole));
        } else {
            add(esm::shownName(*m_system), InUse, *m_system);
            setCurrentIndex(count() - 1);
        }
    }
    for (std::size_t i = 0; i < m_others.size(); ++i) {
        add(esm::shownName(*m_others[i]), Own, *m_others[i]);
        setItemData(count() - 1, static_cast<uint>(i), placeRole);
    }
    insertSeparator(count());
    addItem(tr("From file…"), FromFile);
    setItemData(count() - 1, tr("Open a fuzzy system: JSON, FCL or FLL"), Qt::ToolTipRole);
    addItem(tr("New system…"), New);
    setItemData(count() - 1, tr("Begin a fuzzy system of your own, with no rule yet"), Qt::ToolTipRole);
    if (m_system) {
        addItem(tr("Copy under another name…"), Copy);
        setItemData(count() - 1, tr("Changes of the copy leave other regions as they are"), Qt::ToolTipRole);
        addItem(tr("Save system as…"), ToFile);
        setItemData(count() - 1, tr("Write this fuzzy system to a file: JSON, FCL or FLL"), Qt::ToolTipRole);
    }
    setToolTip(whatItIs());
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + 16);
}

QString FuzzyChoice::shownName() const {
    return currentData(nameRole).toString();
}

/// What the inputs are is for choosing; afterwards they stand below.
void FuzzyChoice::paintEvent(QPaintEvent*) {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    option.currentText = shownName();
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

void FuzzyChoice::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

void FuzzyChoice::choose(int index) {
    switch (itemData(index).toInt()) {
    case NoSystem:
        if (m_system) emit systemChosen(nullptr);
        break;
    case Preset:
        choosePreset(itemData(index, nameRole).toString().toStdString());
        break;
    case Own:
        emit systemChosen(m_others[itemData(index, placeRole).toUInt()]);
        break;
    case FromFile:
        chooseFile();
        break;
    case ToFile:
        saveFile();
        break;
    case New:
    case Copy:
        chooseNamed(static_cast<Kind>(itemData(index).toInt()));
        break;
    default:
        break;
    }
}

void FuzzyChoice::choosePreset(const std::string& name) {
    // The same system again would only put its sliders back.
    if (m_system && m_system->name == name && m_isPreset) return;
    attempt(window(), tr("The fuzzy system cannot be used"),
            [&] { emit systemChosen(std::make_shared<const FuzzySystem>(fuzzyPreset(name))); });
}

void FuzzyChoice::chooseFile() {
    fill();
    openFuzzySystem(window(), [this](const auto& system) { emit systemChosen(system); });
}

void FuzzyChoice::saveFile() {
    fill();
    if (const auto system = m_system) saveFuzzySystem(window(), *system);
}

std::string FuzzyChoice::askName(const QString& title, const QString& proposal) {
    bool accepted = false;
    const QString name = ask(*window(), [&] {
        return QInputDialog::getText(window(), title, tr("Name of the fuzzy system"), QLineEdit::Normal,
                                     proposal, &accepted);
    });
    return accepted ? name.trimmed().toStdString() : std::string();
}

void FuzzyChoice::chooseNamed(Kind kind) {
    const bool copies = kind == Copy;
    const std::string name =
        askName(copies ? tr("Copy fuzzy system") : tr("New fuzzy system"),
                copies ? tr("%1, own").arg(QString::fromStdString(m_system->name)) : tr("own"));
    fill();
    if (name.empty()) return;
    attempt(window(), tr("The fuzzy system cannot be named so"), [&] {
        const auto isTaken = [&](const System& other) { return other && other->name == name; };
        if (isPreset(name) || isTaken(m_system) || std::any_of(m_others.begin(), m_others.end(), isTaken))
            throw InvalidModel("there is a fuzzy system \"" + name + "\" already");
        FuzzySystem system = copies ? *m_system : newFuzzySystem(name);
        system.name = name;
        emit systemChosen(std::make_shared<const FuzzySystem>(std::move(system)));
    });
}

} // namespace esm
