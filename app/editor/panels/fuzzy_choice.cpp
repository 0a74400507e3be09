#include "app/editor/panels/fuzzy_choice.h"

#include "app/editor/commands/attempt.h"
#include "core/exchange/fuzzy_file.h"

#include <nlohmann/json.hpp>
#include <QFileDialog>
#include <QWheelEvent>

#include <algorithm>

namespace esm {

namespace {

enum Kind { NoSystem, Preset, FromFile, InUse };

bool isPreset(const std::string& name) {
    const auto names = fuzzyPresetNames();
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// A file may name its system as a preset is named: only what it says tells them apart.
bool isThePreset(const FuzzySystem& system) {
    return isPreset(system.name) && toJson(system) == toJson(fuzzyPreset(system.name));
}

} // namespace

FuzzyChoice::FuzzyChoice(QWidget* parent) : QComboBox(parent) {
    setObjectName(QStringLiteral("systemChoice"));
    setAccessibleName(tr("Fuzzy system"));
    setToolTip(tr("The fuzzy system that turns words into tissue parameters"));
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, qOverload<int>(&QComboBox::activated), this, &FuzzyChoice::choose);
    fill();
}

void FuzzyChoice::setSystem(const std::shared_ptr<const FuzzySystem>& system) {
    if (system == m_system) return;
    m_system = system;
    fill();
}

void FuzzyChoice::fill() {
    clear();
    addItem(tr("no fuzzy system"), NoSystem);
    for (const auto& name : fuzzyPresetNames())
        addItem(QString::fromStdString(name), Preset);
    if (m_system) {
        const QString name = QString::fromStdString(m_system->name);
        if (isThePreset(*m_system)) {
            setCurrentIndex(findText(name));
        } else {
            addItem(isPreset(m_system->name) ? tr("%1 (from file)").arg(name) : name, InUse);
            setCurrentIndex(count() - 1);
        }
    }
    insertSeparator(count());
    addItem(tr("From file…"), FromFile);
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
        choosePreset(itemText(index).toStdString());
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
    if (m_system && m_system->name == name && isThePreset(*m_system)) return;
    attempt(window(), tr("The fuzzy system cannot be used"),
            [&] { emit systemChosen(std::make_shared<const FuzzySystem>(fuzzyPreset(name))); });
}

void FuzzyChoice::chooseFile() {
    const QString file =
        QFileDialog::getOpenFileName(window(), tr("Open fuzzy system"), {}, tr("Fuzzy systems (*.json)"));
    fill();
    if (file.isEmpty()) return;
    attempt(window(), tr("The fuzzy system cannot be opened"), [&] {
        emit systemChosen(std::make_shared<const FuzzySystem>(readFuzzyFile(file.toStdString())));
    });
}

} // namespace esm
