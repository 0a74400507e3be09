#pragma once

#include "app/editor/dialogs/sofa_trial_dialog.h"
#include "app/editor/workers/difference_finder.h"
#include "widgets/inputs/number_field.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace esm {

/// Says what of an organ will differ in the program that it is handed to, and asks how that is to step it.
/// What will differ is found beside the window, again after each change. Who accepts before it is found is
/// taken at their word once it is, unless the motion would blow up, or nothing can be handed over.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param handover outlives the dialog
    /// @param tried what can be tried in the program where that is installed
    ExportDialog(const Exporter& exporter, const Handover& handover, TriedMotion tried,
                 QWidget* parent = nullptr);

    EngineSettings settings() const; ///< as chosen
    /// Not while a number in it is refused.
    void accept() override;

private:
    void addSettings(QVBoxLayout* column);
    void addRelease(QFormLayout* form);
    void addDamping(QFormLayout* form);
    void addTimeStep(QFormLayout* form);
    void addAnswer(QVBoxLayout* column);
    void addTrial(QDialogButtonBox& buttons);
    void tryOut();
    void addWarning(QVBoxLayout* column);
    void look();
    void takeUsualStep();
    void takeAnswer();
    void show(const Differences& differences);

    const Exporter& m_exporter;
    const Handover& m_handover;
    const TriedMotion m_tried;
    std::optional<std::filesystem::path> m_program; ///< to try it in, where that is installed
    EngineSettings m_settings;
    std::optional<Differences> m_found; ///< by these settings; none while they are looked for
    bool m_acceptsOnceFound = false;
    NumberField* m_timeStep = nullptr; ///< null where no engine steps what is written
    QLabel *m_differences, *m_steps, *m_blowUp;
    QPushButton *m_usualStep, *m_accepting = nullptr;
    DifferenceFinder m_finder; ///< the last, so that it ends before what it tells
};

} // namespace esm
