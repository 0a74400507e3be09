#pragma once

#include "app/editor/window/view_controller.h"
#include "widgets/inputs/number_field.h"

namespace esm {

/// How large the round instrument is. Seen while the instrument is in hand.
class InstrumentOptions : public QWidget {
    Q_OBJECT

public:
    InstrumentOptions(OrganView& view, ViewController& controller, QWidget* parent = nullptr);
};

} // namespace esm
