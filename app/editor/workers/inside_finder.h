#pragma once

#include "app/editor/workers/dialog_worker.h"
#include "core/model/spring_network.h"
#include "core/solid/filled_body.h"

namespace esm {

/// What fills an organ, as far as it is known.
struct FoundInside {
    LatticeFilling filling;                       ///< that was asked for, or is usual
    LatticeEstimate estimate{};                   ///< before it is filled
    std::shared_ptr<const SpringNetwork> network; ///< null until it is filled, and of very many nodes
    double share = 0;                             ///< how much of the work is done until then, up to 1
};

/// Fills an organ, so that people see what a filling comes to before they take it. Tells the estimate first,
/// then how far it is, then all, or why it cannot be. Asked for a spacing of 0, or a wall of 0 layers, it
/// takes what is usual.
class InsideFinder : public DialogWorker<LatticeFilling, FoundInside> {
public:
    explicit InsideFinder(std::shared_ptr<const TriangleMesh> mesh, QObject* parent = nullptr);
};

} // namespace esm
