#pragma once

#include "app/editor/workers/inside_finder.h"
#include "core/model/detail.h"
#include "core/project/project.h"
#include "widgets/inputs/number_field.h"
#include "widgets/view/organ_view.h"

#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace esm {

/// Asks what fills an organ, nothing, a lattice of springs or a wall of prisms, and shows it cut open, with
/// what it costs.
/// Another choice is worked out beside the window.
class InsideDialog : public QDialog {
    Q_OBJECT

public:
    explicit InsideDialog(const Project& project, QWidget* parent = nullptr);

    /// Every vertex a node, or filled.
    Detail detail() const;
    /// Null where so many nodes were not made yet.
    std::shared_ptr<const SpringNetwork> network() const;
    /// Ends what is still worked out, which may take a moment; on any thread, once the dialog was answered.
    void stopWork() { m_finder.stop(); }
    /// Not while a number in it is refused.
    void accept() override;
    void done(int result) override;

private:
    void addQuestions(QVBoxLayout* column);
    void addButtons(QVBoxLayout* column);
    std::optional<LatticeKind> kind() const;
    void showNow(const Detail& now);
    LatticeFilling filling() const;
    void enableNumbers();
    void chooseKind();
    void lookAgain();
    void takeAnswer();
    void showFound(const FoundInside& found, bool isDone);
    void showHollow();
    void showScene(std::shared_ptr<const SpringNetwork> network);

    const Project m_project;
    InsideFinder m_finder;
    bool m_isAnswered = false;   ///< by the user
    bool m_hasOwnLayers = false; ///< or as many as are usual for the wall's thickness
    OrganView* m_view;
    QComboBox* m_kind;
    NumberField *m_spacing, *m_thickness, *m_layers;
    QLabel *m_about, *m_cost, *m_firmness, *m_refusal;
    QPushButton* m_accept = nullptr;
};

} // namespace esm
