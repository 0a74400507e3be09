#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QComboBox>

#include <memory>
#include <vector>

namespace esm {

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
    void paintEvent(QPaintEvent* event) override;

private:
    enum Kind { NoSystem, Preset, Own, InUse, FromFile, ToFile, New, Copy };

    /// A row of the list.
    struct Entry {
        QString text, name, toolTip;
        Kind kind;
        uint place = 0; ///< among m_others

        bool operator==(const Entry&) const = default;
    };

    void recognise();
    std::vector<Entry> entries() const;
    void fill();
    void choose(int index);
    void choosePreset(const std::string& name);
    void chooseFile();
    void saveFile();
    /// Asks for a name that is not taken. @return empty where there is none
    std::string askName(const QString& title, const QString& proposal);
    bool isTaken(const std::string& name) const;
    /// The name, with a number behind it where it is taken.
    QString freeName(const QString& name) const;
    void chooseNamed(Kind kind);

    System m_system;
    std::vector<System> m_project, m_others;
    std::vector<Entry> m_entries;
    bool m_isPreset = false;
    QString m_description;
};

} // namespace esm
