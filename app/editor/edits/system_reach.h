#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "core/authoring/edit_system.h"

#include <QStringList>

#include <functional>
#include <vector>

namespace esm {

/// Whether edits of the selected region's fuzzy system may reach other regions: the user is asked once, and
/// what was answered holds until another region is selected or the region gets another system.
class SystemReach : public QObject {
    Q_OBJECT

public:
    /// None: the user would rather not edit.
    using Question = std::function<std::optional<Reach>(const FuzzySystem& system,
                                                        const std::vector<const Region*>& users)>;

    SystemReach(Document& document, Selection& selection, QObject* parent = nullptr);

    void setQuestion(Question question) { m_question = std::move(question); }

    /// The regions that use the selected region's system, itself among them.
    std::vector<const Region*> users() const;
    /// Whether an edit would ask first.
    bool wouldAsk() const { return users().size() > 1 && !m_decided; }
    /// What was answered, as long as it makes a difference.
    std::optional<Reach> decided() const { return users().size() > 1 ? m_decided : std::nullopt; }
    /// Asks where it has to. None where the user would rather not edit: nothing may change then.
    std::optional<Reach> ask();
    void decide(std::optional<Reach> reach);

signals:
    /// What wouldAsk(), users() or decided() give.
    void changed();

private:
    void follow(const EditedSystem& edited);

    Document& m_document;
    Selection& m_selection;
    Question m_question;
    std::optional<Reach> m_decided;
    std::optional<RegionId> m_region; ///< that it was decided for, and its system
    std::shared_ptr<const FuzzySystem> m_system;
};

/// What the regions are called, in their order.
QStringList namesOf(const std::vector<const Region*>& regions);

} // namespace esm
