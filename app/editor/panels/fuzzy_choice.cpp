#include "app/editor/panels/fuzzy_choice.h"

#include "app/editor/commands/attempt.h"
#include "app/editor/document/file_memory.h"
#include "core/exchange/fuzzy_file.h"
#include "widgets/fuzzy/term_scale.h"

#include <QAbstractItemView>
#include <QFileDialog>
#include <QStylePainter>
#include <QWheelEvent>

#include <algorithm>

namespace esm {

namespace {

constexpr int nameRole = Qt::UserRole + 1;

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

void FuzzyChoice::setSystem(const std::shared_ptr<const FuzzySystem>& system) {
    if (system == m_system) return;
    m_system = system;
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
            add(isPreset(m_system->name) ? tr("%1 (from file)").arg(name) : name, InUse, *m_system);
            setCurrentIndex(count() - 1);
        }
    }
    insertSeparator(count());
    addItem(tr("From file…"), FromFile);
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
    case FromFile:
        chooseFile();
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
    const QString file = QFileDialog::getOpenFileName(window(), tr("Open fuzzy system"),
                                                      startFolder(FileKind::FuzzySystem, std::nullopt),
                                                      tr("Fuzzy systems (*.json)"));
    fill();
    if (file.isEmpty()) return;
    rememberFolder(FileKind::FuzzySystem, file.toStdString());
    attempt(window(), tr("The fuzzy system cannot be opened"), [&] {
        emit systemChosen(std::make_shared<const FuzzySystem>(readFuzzyFile(file.toStdString())));
    });
}

} // namespace esm
