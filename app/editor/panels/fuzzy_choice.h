#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QComboBox>

#include <memory>

namespace esm {

/// Chooses a fuzzy system: none, one that ships with the program, or one from a file.
class FuzzyChoice : public QComboBox {
    Q_OBJECT

public:
    explicit FuzzyChoice(QWidget* parent = nullptr);

    /// Shows the system in use without announcing it; null is none.
    void setSystem(const std::shared_ptr<const FuzzySystem>& system);

signals:
    void systemChosen(const std::shared_ptr<const esm::FuzzySystem>& system);

private:
    void choose(int index);
    void chooseFile();

    std::shared_ptr<const FuzzySystem> m_system;
};

} // namespace esm
