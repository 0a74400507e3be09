#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/authoring/fluids.h"

#include <QObject>

#include <memory>

namespace esm {

/// Finds the parts of an organ's surface that fluid could fill, beside the window: of a large one every edge
/// is looked at.
class PartFinder : public QObject {
    Q_OBJECT

public:
    /// An organ's surface and what carries it. None is null.
    struct Surface {
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const SpringNetwork> network;

        bool operator==(const Surface&) const = default;
    };

    explicit PartFinder(QObject* parent = nullptr);

    void find(const Surface& surface);
    /// While it works, and before it was asked, none.
    const std::vector<FillablePart>& parts() const { return m_parts; }
    bool isWorking() const { return m_isWorking; } ///< until found() is heard

signals:
    void found();

private:
    void takeAnswer();

    bool m_isWorking = false;
    std::vector<FillablePart> m_parts;
    LatestWorker<Surface, std::vector<FillablePart>> m_worker;
};

} // namespace esm
