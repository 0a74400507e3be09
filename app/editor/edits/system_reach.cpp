#include "app/editor/edits/system_reach.h"

#include "app/editor/edits/selected_system.h"
#include "core/authoring/systems.h"

namespace esm {

SystemReach::SystemReach(Document& document, Selection& selection, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection) {
    setObjectName(QStringLiteral("systemReach"));
    connect(&selection, &Selection::changed, this, [this] { follow({}); });
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions) follow(change.system);
    });
    follow({});
}

std::vector<const Region*> SystemReach::users() const {
    const auto system = selectedSystem(m_selection);
    return system ? usersOf(m_document.project(), *system) : std::vector<const Region*>();
}

std::optional<Reach> SystemReach::ask() {
    const std::vector<const Region*> shared = users();
    if (shared.size() < 2) return Reach::EveryRegion;
    if (!m_decided && m_question) decide(m_question(*selectedSystem(m_selection), shared));
    return m_decided;
}

void SystemReach::decide(std::optional<Reach> reach) {
    m_decided = reach;
    emit changed();
}

/// A copy that was made is the answer's end: where it is undone, the next edit asks again.
void SystemReach::follow(const EditedSystem& edited) {
    const auto system = selectedSystem(m_selection);
    const bool goesOn = m_region == m_selection.region() && m_system &&
                        (sameValue(system, m_system) ||
                         (sameValue(edited.before, m_system) && sameValue(edited.after, system)));
    m_region = m_selection.region();
    m_system = system;
    if (!goesOn || users().size() < 2) m_decided.reset();
    emit changed();
}

QStringList namesOf(const std::vector<const Region*>& regions) {
    QStringList names;
    for (const Region* region : regions)
        names << QString::fromStdString(region->name);
    return names;
}

} // namespace esm
