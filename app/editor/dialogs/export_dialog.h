#pragma once

#include "app/editor/workers/difference_finder.h"
#include "app/editor/workers/pulled_scene.h"
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
/// What will differ is looked for beside the window, anew after each change. Export may be pressed before it
/// is found again: the dialog then closes by itself, unless the motion would blow up or nothing can be handed
/// over.
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
    /// What is found later changes nothing more.
    void done(int result) override;

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
    void showAsKnown(bool isKnown);
    void showSearch(double share);
    void showFailure(const std::string& failure);
    void show(const Differences& differences);

    const Exporter& m_exporter;
    const Handover& m_handover;
    const TriedMotion m_tried;
    std::optional<std::filesystem::path> m_program; ///< to try it in, where that is installed
    EngineSettings m_settings;
    std::optional<Differences> m_found; ///< by these settings; none while they are looked for
    bool m_acceptsOnceFound = false;
    bool m_wasFoundWhenPressed = false; ///< so that nobody accepts what appears during the press
    NumberField* m_timeStep = nullptr;  ///< null where no engine steps what is written
    QLabel *m_differences, *m_steps, *m_poorStep;
    QPushButton *m_usualStep = nullptr, *m_accepting = nullptr;
    DifferenceFinder m_finder; ///< last: destroyed first, its thread ends while all else still stands
};

} // namespace esm
