#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/edits/system_reach.h"
#include "app/editor/panels/fuzzy/fuzzy_choice.h"
#include "app/editor/panels/parameter_row.h"
#include "app/editor/panels/tissue/bending_box.h"
#include "app/editor/panels/tissue/clinical_rows.h"
#include "app/editor/panels/tissue/kept_values.h"
#include "app/editor/panels/tissue/stiffening_row.h"
#include "widgets/fuzzy/linguistic_slider.h"
#include "widgets/inputs/section.h"

#include <functional>
#include <vector>

namespace esm {

/// How the selected region's tissue behaves: a slider per input of its fuzzy system, in words and in numbers,
/// and what they come to. Made anew from the system's variables when another system is chosen [R 2.3.7].
class TissuePanel : public QWidget {
    Q_OBJECT

public:
    TissuePanel(Document& document, Selection& selection, SystemReach& reach, QWidget* parent = nullptr);

private:
    const Region* region() const;
    void show();
    void followSystem(const std::shared_ptr<const FuzzySystem>& system);
    void rebuild();
    void addInput(std::size_t index);
    void addOutput(std::size_t index);
    void connectOutput(LinguisticSlider* row, Parameter parameter, std::size_t index);
    void addPlainParameter(Parameter parameter);
    void addBaseParameter(Parameter parameter);
    void chooseSystem(const std::shared_ptr<const FuzzySystem>& system);
    QString hint() const;
    void showUsers();
    void addClinicalRows();
    void showClinically(const RegionTissue& tissue);
    std::optional<double> ofSystem(const RegionTissue& tissue, Parameter parameter) const;
    void showSource();
    /// What is said of an output that no rule reaches.
    QString keptNote(const Region& shown, Parameter parameter);

    Document& m_document;
    Selection& m_selection;
    SystemReach& m_reach;
    Section *m_tissue, *m_results;
    FuzzyChoice* m_choice;
    ClinicalRows* m_clinical;
    StiffeningRow* m_stiffening;
    BendingBox* m_bending;
    QLabel *m_system, *m_users, *m_source, *m_hint, *m_warnings;
    KeptValues m_kept;
    QWidget *m_inputs, *m_outputs;
    std::shared_ptr<const FuzzySystem> m_builtFor;
    bool m_builtForRegion = false, m_built = false;
    /// Each gives one row the terms of a system like the one it was built for.
    std::vector<std::function<void(const FuzzySystem&)>> m_followers;
    /// Each shows one row's value again.
    std::vector<std::function<void(const Region*, const RegionTissue&)>> m_refreshers;
};

} // namespace esm
