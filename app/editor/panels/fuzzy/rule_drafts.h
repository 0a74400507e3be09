#pragma once

#include "app/editor/document/change.h"

#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace esm {

/// Rules with the names that variables and terms have got since, line by line.
QString withNamesOf(const FuzzySystem& after, const FuzzySystem& before, const QString& rules);

/// Rules as text that is not in force, by the system that they are written for. Systems that are alike are
/// one: what edits the one edits the other.
class RuleDrafts {
public:
    using System = std::shared_ptr<const FuzzySystem>;

    void keep(const System& system, const QString& text);
    /// Takes a system's text out, if there is any.
    std::optional<QString> take(const System& system);
    /// A system has become another: its text is for that one.
    void follow(const EditedSystem& edited);
    /// Keeps those alone whose very system some region has; of another organ none.
    void forgetAllBut(const std::vector<Region>& regions);
    /// Whether one of the regions has a system that text is kept for.
    bool concern(const std::vector<Region>& regions) const;

private:
    std::vector<std::pair<System, QString>> m_texts;
};

} // namespace esm
