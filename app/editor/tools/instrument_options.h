#pragma once

#include "app/editor/tools/instrument_tool.h"
#include "widgets/inputs/number_field.h"

#include <QComboBox>
#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace esm {

/// What the instrument is, and how large.
class InstrumentOptions : public QWidget {
    Q_OBJECT

public:
    explicit InstrumentOptions(InstrumentTool& tool, QWidget* parent = nullptr);

private:
    void connectFields();
    void show();
    QLabel* addField(QHBoxLayout& row, const QString& caption, QWidget* field, const QString& toolTip);

    InstrumentTool& m_tool;
    QComboBox* m_kind;
    NumberField *m_radius, *m_length;
    QLabel* m_lengthCaption;
};

} // namespace esm
