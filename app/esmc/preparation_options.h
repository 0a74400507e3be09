#pragma once

#include "app/esmc/arguments.h"
#include "app/esmc/report.h"
#include "core/project/project.h"

#include <optional>
#include <string>

namespace esm {

/// How a photograph is to be prepared, as the command line says it.
struct PreparationOptions {
    bool field = false, maskOverlays = false, fillHighlights = false, whiteBalance = false,
         matchColours = false;
    double evenLight = 0;
    std::optional<double> highlights; ///< sensitivity
    std::string whiteSpot, whiteLike, lens, crop, levels;
    ColourAdjustment adjustment; ///< all but the levels
};

void declarePreparation(CLI::App& command, PreparationOptions& options);

/// Prepares the photo of a layer that comes to lie on the project's other ones, and reports what the steps
/// found. @throws FileError, InvalidModel
Report prepareLayer(const Project& project, TextureLayer& layer, const PreparationOptions& options);

} // namespace esm
