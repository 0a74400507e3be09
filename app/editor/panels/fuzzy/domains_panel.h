#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/edits/system_reach.h"
#include "app/editor/panels/fuzzy/range_row.h"
#include "app/editor/panels/fuzzy/term_list.h"
#include "app/editor/panels/fuzzy/variable_choice.h"
#include "widgets/fuzzy/corner_fields.h"
#include "widgets/fuzzy/partition_editor.h"

#include <QBoxLayout>
#include <QLabel>

#include <functional>

namespace esm {

/// The variables of the selected region's fuzzy system: their ranges and their partitions into terms, drawn,
/// dragged and typed.
class DomainsPanel : public QWidget {
    Q_OBJECT

public:
    DomainsPanel(Document& document, Selection& selection, SystemReach& reach, QWidget* parent = nullptr);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    using SystemEdit = std::function<FuzzySystem(const FuzzySystem&)>;

    void buildContent();
    void connectPartition();
    void connectTerms();
    void connectVariables();

    void follow(const EditedSystem& edited);
    void showSystem();
    void showVariable(const FuzzySystem& system);
    std::optional<double> presentValue() const;

    std::shared_ptr<const FuzzySystem> system() const;
    const FuzzyVariable* variable() const;
    void chooseVariable(const VariablePlace& place);
    void takeTerm(std::size_t term);
    /// Takes the term in hand that the present value belongs to most.
    void takeSpokenTerm();

    using SystemChange = std::function<void(Project&, Reach)>;
    /// An undoable edit; what cannot be done is said in the panel, and the system then stays as it was. So it
    /// does where the user, who is asked when other regions use the system too, would rather not.
    bool take(const QString& text, const SystemChange& change, EditKind kind, std::uint64_t place = 0);
    bool edit(const QString& text, const SystemEdit& change, EditKind kind = EditKind::Alone,
              std::uint64_t place = 0);
    bool editVariable(const QString& text, const std::function<void(FuzzyVariable&)>& change,
                      EditKind kind = EditKind::Alone, std::uint64_t place = 0);
    void setRange(double minimum, double maximum, TermsInRange terms);
    void addTerm();
    void removeTerm();
    void moveTerm(int by);
    void renameTerm(std::size_t term, const QString& typed);
    void addVariable(FuzzySide side);
    void renameVariable();
    void removeVariable();
    void moveVariable(int by);

    Document& m_document;
    Selection& m_selection;
    SystemReach& m_reach;
    VariablePlace m_place;
    std::size_t m_term = 0;
    std::optional<std::size_t> m_added; ///< the term that awaits its first name
    std::shared_ptr<const FuzzySystem> m_shown;
    std::optional<RegionId> m_shownRegion;
    QLabel* m_words;
    QWidget* m_content;
    QBoxLayout* m_halves;
    VariableChoice* m_variables;
    PartitionEditor* m_partition;
    CornerFields* m_corners;
    RangeRow* m_range;
    TermList* m_terms;
};

} // namespace esm
