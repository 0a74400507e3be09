#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/model/spring_network.h"
#include "core/solid/filled_body.h"

#include <QObject>

#include <optional>

namespace esm {

/// What fills an organ, as far as it is known.
struct FoundInside {
    LatticeFilling filling;                       ///< that was asked for, or is usual
    LatticeEstimate estimate{};                   ///< before it is filled
    std::shared_ptr<const SpringNetwork> network; ///< null until it is filled, and of very many nodes
};

/// Fills an organ on a thread of its own, again whenever that is asked for in another way, so that people see
/// what a filling comes to before they take it.
class InsideFinder : public QObject {
    Q_OBJECT

public:
    using Answer = std::shared_ptr<const FoundInside>;

    explicit InsideFinder(std::shared_ptr<const TriangleMesh> mesh, QObject* parent = nullptr);

    /// @param filling with a spacing of 0 for the usual one of its kind
    void look(const LatticeFilling& filling) { m_worker->ask(filling); }
    /// The latest; none before the first.
    Outcome<Answer> outcome() const { return m_worker->outcome(); }
    bool isWorking() const { return m_worker->isWorking(); }
    /// Ends the work, which may take a moment; on any thread. Nothing may be asked afterwards.
    void stop() { m_worker.reset(); }

signals:
    /// The estimate, or all, or why it cannot be.
    void answered();

private:
    std::unique_ptr<LatestWorker<LatticeFilling, Answer>> m_worker;
};

} // namespace esm
