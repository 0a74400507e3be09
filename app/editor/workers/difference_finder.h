#pragma once

#include "app/editor/workers/dialog_worker.h"
#include "core/exchange/simulators/exporters.h"

namespace esm {

/// What of an organ will differ in another program, as far as it is known.
struct FoundDifferences {
    std::optional<Differences> differences; ///< none until the work is done
    double share = 0;                       ///< how much of it is done, up to 1
};

/// Finds what will differ where an organ is handed over, which takes a while where the largest stable step of
/// many nodes is to be known. Tells first how far it is.
class DifferenceFinder : public DialogWorker<EngineSettings, FoundDifferences> {
public:
    /// @param exporter, handover outlive the finder, and are not changed
    DifferenceFinder(const Exporter& exporter, const Handover& handover, QObject* parent = nullptr);
};

} // namespace esm
