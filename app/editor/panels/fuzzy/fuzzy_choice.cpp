#include "app/editor/panels/fuzzy/fuzzy_choice.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/fuzzy_files.h"
#include "app/editor/dialogs/shipped_systems.h"
#include "core/fuzzy/system_edits.h"
#include "core/support/errors.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/spoken.h"

#include <QAbstractItemView>
#include <QInputDialog>
#include <QLineEdit>
#include <QStylePainter>

#include <algorithm>

namespace esm {

namespace {

constexpr int nameRole = Qt::UserRole + 1, placeRole = Qt::UserRole + 2;

/// "robo-sim: consistency, sensitiveness, shiftability": what the user will be asked for.
QString withInputs(const QString& name, const FuzzySystem& system) {
    QStringList inputs;
    for (const FuzzyVariable& input : system.inputs)
        inputs << readableName(input.name);
    return QStringLiteral("%1: %2").arg(name, inputs.join(QStringLiteral(", ")));
}

} // namespace

FuzzyChoice::FuzzyChoice(QWidget* parent) : QComboBox(parent) {
    setObjectName(QStringLiteral("systemChoice"));
    nameChoice(*this, tr("Fuzzy system"));
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(10);
    guardFromWheel(*this, Turning::Never); // to turn through the systems would lose what was set for each
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
    m_isPreset = m_system && isShipped(*m_system);
    if (!m_system)
        m_description = whatItIs();
    else
        m_description = QString::fromStdString(m_isPreset ? shippedSystem(m_system->name)->description
                                                          : m_system->description);
    m_others.clear();
    for (const System& system : m_project) {
        const auto isIt = [&](const System& known) { return known == system || *known == *system; };
        if (!(m_system && isIt(m_system)) && std::none_of(m_others.begin(), m_others.end(), isIt) &&
            !isShipped(*system))
            m_others.push_back(system);
    }
}

std::vector<FuzzyChoice::Entry> FuzzyChoice::entries() const {
    std::vector<Entry> all;
    const auto addSystem = [&](Kind kind, const FuzzySystem& system, uint place = 0) {
        const QString name = kind == Preset ? QString::fromStdString(system.name) : esm::shownName(system);
        all.push_back({withInputs(name, system), name,
                       QString::fromStdString(system.description + "\n\n" + system.note).trimmed(), kind,
                       place});
    };
    all.push_back({tr("no fuzzy system"), tr("no fuzzy system"), tr("Numbers only"), NoSystem});
    for (const System& shipped : shippedSystems())
        addSystem(Preset, *shipped);
    if (m_system && !m_isPreset) addSystem(InUse, *m_system);
    for (std::size_t i = 0; i < m_others.size(); ++i)
        addSystem(Own, *m_others[i], static_cast<uint>(i));
    all.push_back({tr("From file…"), {}, tr("Open a fuzzy system: JSON, FCL or FLL"), FromFile});
    all.push_back({tr("New system…"), {}, tr("Begin a fuzzy system of your own, with no rule yet"), New});
    if (!m_system) return all;
    all.push_back({tr("Copy under another name…"),
                   {},
                   tr("Changes of the copy leave other regions as they are"),
                   Copy});
    all.push_back(
        {tr("Save system as…"), {}, tr("Write this fuzzy system to a file: JSON, FCL or FLL"), ToFile});
    return all;
}

void FuzzyChoice::fill() {
    // While a corner is dragged the same is said again and again.
    if (auto now = entries(); now != m_entries) {
        m_entries = std::move(now);
        clear();
        for (const Entry& entry : m_entries) {
            if (entry.kind == FromFile) insertSeparator(count());
            addItem(entry.text, entry.kind);
            setItemData(count() - 1, entry.name, nameRole);
            setItemData(count() - 1, entry.place, placeRole);
            setItemData(count() - 1, entry.toolTip, Qt::ToolTipRole);
        }
        view()->setMinimumWidth(view()->sizeHintForColumn(0) + 16);
    }
    setToolTip(whatItIs());
    const int inUse = m_system && !m_isPreset ? findData(InUse) : 0;
    setCurrentIndex(m_isPreset ? findData(QString::fromStdString(m_system->name), nameRole) : inUse);
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
    emit systemChosen(shippedSystem(name));
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

bool FuzzyChoice::isTaken(const std::string& name) const {
    const auto isIt = [&](const System& other) { return other && other->name == name; };
    return shippedSystem(name) || isIt(m_system) || std::any_of(m_others.begin(), m_others.end(), isIt);
}

QString FuzzyChoice::freeName(const QString& name) const {
    QString free = name;
    for (int number = 2; isTaken(free.toStdString()); ++number)
        free = QStringLiteral("%1 %2").arg(name).arg(number);
    return free;
}

void FuzzyChoice::chooseNamed(Kind kind) {
    const bool copies = kind == Copy;
    const std::string name =
        askName(copies ? tr("Copy fuzzy system") : tr("New fuzzy system"),
                freeName(copies ? tr("%1, own").arg(QString::fromStdString(m_system->name)) : tr("own")));
    fill();
    if (name.empty()) return;
    attempt(window(), tr("The fuzzy system cannot be named so"), [&] {
        if (isTaken(name)) throw InvalidModel("there is a fuzzy system \"" + name + "\" already");
        FuzzySystem system = copies ? *m_system : newFuzzySystem(name);
        system.name = name;
        emit systemChosen(std::make_shared<const FuzzySystem>(std::move(system)));
    });
}

} // namespace esm
