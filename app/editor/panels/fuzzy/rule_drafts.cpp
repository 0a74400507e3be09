#include "app/editor/panels/fuzzy/rule_drafts.h"

#include "core/fuzzy/renamed_words.h"

#include <algorithm>
#include <QStringList>

namespace esm {

QString withNamesOf(const FuzzySystem& after, const FuzzySystem& before, const QString& rules) {
    QStringList lines = rules.split('\n');
    for (QString& line : lines)
        line = QString::fromStdString(withNamesOf(after, before, line.toStdString()));
    return lines.join('\n');
}

void RuleDrafts::keep(const System& system, const QString& text) {
    take(system);
    m_texts.emplace_back(system, text);
}

std::optional<QString> RuleDrafts::take(const System& system) {
    const auto found = std::find_if(m_texts.begin(), m_texts.end(),
                                    [&](const auto& kept) { return sameValue(kept.first, system); });
    if (found == m_texts.end()) return std::nullopt;
    QString text = std::move(found->second);
    m_texts.erase(found);
    return text;
}

void RuleDrafts::follow(const EditedSystem& edited) {
    if (!edited.before || !edited.after) return;
    for (auto& [system, text] : m_texts) {
        if (!sameValue(system, edited.before)) continue;
        text = withNamesOf(*edited.after, *edited.before, text);
        system = edited.after;
    }
}

void RuleDrafts::forgetAllBut(const std::vector<Region>& regions) {
    const auto isGone = [&](const auto& kept) {
        return std::none_of(regions.begin(), regions.end(),
                            [&](const Region& region) { return region.system.get() == kept.first.get(); });
    };
    m_texts.erase(std::remove_if(m_texts.begin(), m_texts.end(), isGone), m_texts.end());
}

bool RuleDrafts::concern(const std::vector<Region>& regions) const {
    return std::any_of(m_texts.begin(), m_texts.end(), [&](const auto& kept) {
        return std::any_of(regions.begin(), regions.end(), [&](const Region& region) {
            return sameValue<FuzzySystem>(region.system, kept.first);
        });
    });
}

} // namespace esm
