#pragma once

#include "core/exchange/simulators/sofa/sofa_trial.h"

#include <QDialog>

namespace esm {

/// Shows how an organ moved here and in SOFA, one curve over the other, how far both are apart, and how long
/// each took.
class SofaTrialDialog : public QDialog {
    Q_OBJECT

public:
    /// @param motion the name of what moved it
    SofaTrialDialog(const SofaTrial& trial, const QString& motion, QWidget* parent = nullptr);
};

} // namespace esm
