#pragma once

#include "app/editor/tools/instrument_tool.h"

#include <QWidget>

namespace esm {

/// How large the round instrument is.
class InstrumentOptions : public QWidget {
    Q_OBJECT

public:
    explicit InstrumentOptions(InstrumentTool& tool, QWidget* parent = nullptr);
};

} // namespace esm
