#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QComboBox>

#include <memory>

namespace esm {

/// Chooses a fuzzy system: none, one that ships with the program, or one from a file. One from a file is not
/// taken for the shipped one whose name it bears.
class FuzzyChoice : public QComboBox {
    Q_OBJECT

public:
    explicit FuzzyChoice(QWidget* parent = nullptr);

    /// Shows the system in use without announcing it; null is none.
    void setSystem(const std::shared_ptr<const FuzzySystem>& system);
    /// The name that is shown while the list is shut.
    QString shownName() const;
    /// What the system in use is for; without one, what a fuzzy system is.
    const QString& description() const { return m_description; }
    static QString whatItIs();

signals:
    void systemChosen(const std::shared_ptr<const esm::FuzzySystem>& system);

protected:
    /// The wheel scrolls the panel: turning through the systems would lose what was set for each.
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    enum Kind { NoSystem, Preset, FromFile, InUse };

    void recognise();
    void fill();
    void add(const QString& name, Kind kind, const FuzzySystem& system);
    void choose(int index);
    void choosePreset(const std::string& name);
    void chooseFile();

    std::shared_ptr<const FuzzySystem> m_system;
    bool m_isPreset = false;
    QString m_description;
};

} // namespace esm
