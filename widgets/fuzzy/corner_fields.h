#pragma once

#include "core/fuzzy/partition_edits.h"
#include "widgets/inputs/number_field.h"

#include <array>

namespace esm {

/// The four corners of a term in number fields side by side, each bounded by its neighbours and the
/// variable's range.
class CornerFields : public QWidget {
    Q_OBJECT

public:
    explicit CornerFields(QWidget* parent = nullptr);

    /// Shows a term without announcing it.
    void setTerm(const FuzzyVariable& variable, std::size_t term);
    NumberField* field(Corner corner) const { return m_fields[static_cast<std::size_t>(corner)]; }

signals:
    void cornerEdited(esm::Corner corner, double value);
    /// What follows is another edit.
    void gestureFinished();

private:
    std::array<NumberField*, 4> m_fields;
};

} // namespace esm
