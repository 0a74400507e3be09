#pragma once

#include "app/editor/document/document.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

namespace esm {

class FixTool;

/// How large a part of the organ the tool Fix takes, and how many nodes are fixed.
class FixPanel : public Section {
    Q_OBJECT

public:
    FixPanel(FixTool& tool, Document& document, QWidget* parent = nullptr);

private:
    void show();

    FixTool& m_tool;
    Document& m_document;
    NumberField* m_radius;
    QLabel* m_count;
};

} // namespace esm
