#pragma once

#include "app/editor/workers/import_preview.h"
#include "app/editor/workers/latest_worker.h"

#include <QObject>

namespace esm {

/// What a file is taken to mean.
struct ImportQuestion {
    RepairOptions options; ///< in the file's unit
    LengthUnit unit = LengthUnit::Millimetre;
    UpAxis up = UpAxis::Y;
};

struct ImportAnswer {
    std::shared_ptr<const ImportedSurface> surface;
    RenderScene preview; ///< without a background
};

/// Repairs a surface and makes its preview on a thread of its own, again whenever that is asked for in
/// another way.
class SurfaceImporter : public QObject {
    Q_OBJECT

public:
    using Answer = std::shared_ptr<const ImportAnswer>;

    /// @param found the soup's surface with no options
    SurfaceImporter(std::shared_ptr<const PolygonSoup> soup, std::shared_ptr<const ImportedSurface> found,
                    QObject* parent = nullptr);

    void look(const ImportQuestion& question) { m_worker->ask(question); }
    /// The latest; none before the first.
    Outcome<Answer> outcome() const { return m_worker->outcome(); }
    bool isWorking() const { return m_worker->isWorking(); }
    /// Ends the work, which may take a moment; on any thread. Nothing may be asked afterwards.
    void stop() { m_worker.reset(); }

signals:
    void answered();

private:
    std::unique_ptr<LatestWorker<ImportQuestion, Answer>> m_worker;
};

} // namespace esm
