#pragma once

#include "core/exchange/simulators/exporters.h"
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
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param handover outlives the dialog
    /// @param tried what can be tried in the program where that is installed
    ExportDialog(const Exporter& exporter, const Handover& handover, Scene tried, QWidget* parent = nullptr);

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
    HandoverMeans meansNow(const Progress& progress) const;
    void look();
    void lookAgain();
    void show(const Differences& differences);

    const Exporter& m_exporter;
    const Handover& m_handover;
    const Scene m_tried;
    std::optional<std::filesystem::path> m_program; ///< to try it in, where that is installed
    EngineSettings m_settings;
    std::optional<double> m_toldStep;  ///< s
    NumberField* m_timeStep = nullptr; ///< null where no engine steps what is written
    QLabel *m_differences, *m_steps;
    QPushButton* m_accepting = nullptr;
};

} // namespace esm
