#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QComboBox>

#include <memory>
#include <vector>

namespace esm {

/// A system's name for people: one that was changed does not pass for the shipped one whose name it bears.
QString shownName(const FuzzySystem& system);

/// Chooses a fuzzy system: none, one that ships with the program, one of the project's own, one from a file,
/// a new one, or a copy under another name; and saves the one in use. One that was changed is not taken for
/// the shipped one whose name it bears.
class FuzzyChoice : public QComboBox {
    Q_OBJECT

public:
    explicit FuzzyChoice(QWidget* parent = nullptr);

    using System = std::shared_ptr<const FuzzySystem>;

    /// Shows the system in use without announcing it; null is none. Of the project's systems the others that
    /// do not ship with the program can be chosen too.
    void setSystem(const System& system, const std::vector<System>& project = {});
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
    enum Kind { NoSystem, Preset, Own, InUse, FromFile, ToFile, New, Copy };

    void recognise();
    void fill();
    void add(const QString& name, Kind kind, const FuzzySystem& system);
    void choose(int index);
    void choosePreset(const std::string& name);
    void chooseFile();
    void saveFile();
    /// Asks for a name that is not taken. @return empty where there is none
    std::string askName(const QString& title, const QString& proposal);
    void chooseNamed(Kind kind);

    System m_system;
    std::vector<System> m_project, m_others;
    bool m_isPreset = false;
    QString m_description;
};

} // namespace esm
