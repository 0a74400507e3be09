#include "app/editor/panels/fuzzy_choice.h"

#include "app/editor/commands/attempt.h"
#include "core/exchange/fuzzy_file.h"

#include <QFileDialog>

namespace esm {

namespace {

enum Kind { NoSystem, Preset, FromFile, InUse };

} // namespace

FuzzyChoice::FuzzyChoice(QWidget* parent) : QComboBox(parent) {
    setObjectName(QStringLiteral("systemChoice"));
    setAccessibleName(tr("Fuzzy system"));
    setToolTip(tr("The fuzzy system that turns words into tissue parameters"));
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(this, qOverload<int>(&QComboBox::activated), this, &FuzzyChoice::choose);
    setSystem(nullptr);
}

void FuzzyChoice::setSystem(const std::shared_ptr<const FuzzySystem>& system) {
    m_system = system;
    clear();
    addItem(tr("no fuzzy system"), NoSystem);
    for (const auto& name : fuzzyPresetNames())
        addItem(QString::fromStdString(name), Preset);
    if (system) {
        const QString name = QString::fromStdString(system->name);
        int index = findText(name, Qt::MatchFixedString);
        if (index < 0) {
            addItem(name, InUse);
            index = count() - 1;
        }
        setCurrentIndex(index);
    }
    insertSeparator(count());
    addItem(tr("From file…"), FromFile);
}

void FuzzyChoice::choose(int index) {
    switch (itemData(index).toInt()) {
    case NoSystem:
        emit systemChosen(nullptr);
        break;
    case Preset: {
        const std::string name = itemText(index).toStdString();
        // The same system again would only put its sliders back.
        if (m_system && m_system->name == name) break;
        attempt(window(), tr("The fuzzy system cannot be used"),
                [&] { emit systemChosen(std::make_shared<const FuzzySystem>(fuzzyPreset(name))); });
        break;
    }
    case FromFile:
        chooseFile();
        break;
    default:
        break;
    }
}

void FuzzyChoice::chooseFile() {
    const auto shown = m_system;
    const QString file =
        QFileDialog::getOpenFileName(window(), tr("Open fuzzy system"), {}, tr("Fuzzy systems (*.json)"));
    setSystem(shown);
    if (file.isEmpty()) return;
    attempt(window(), tr("The fuzzy system cannot be opened"), [&] {
        emit systemChosen(std::make_shared<const FuzzySystem>(readFuzzyFile(file.toStdString())));
    });
}

} // namespace esm
