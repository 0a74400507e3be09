#pragma once

#include "app/editor/workers/dialog_worker.h"
#include "app/editor/workers/import_preview.h"

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

/// Repairs a surface and makes its preview.
class SurfaceImporter : public DialogWorker<ImportQuestion, ImportAnswer> {
public:
    /// @param found the soup's surface with no options
    SurfaceImporter(std::shared_ptr<const PolygonSoup> soup, std::shared_ptr<const ImportedSurface> found,
                    QObject* parent = nullptr);
};

} // namespace esm
