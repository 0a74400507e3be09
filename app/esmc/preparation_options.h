#pragma once

#include "app/esmc/arguments.h"
#include "app/esmc/report.h"
#include "core/texture/layers/texture_layer.h"

#include <string>

namespace esm {

/// How a photograph is to be prepared, as the command line says it.
struct PreparationOptions {
    bool roundField = false, fillHighlights = false, whiteBalance = false;
    double evenLight = 0;
    std::string lens, crop;
};

void declarePreparation(CLI::App& command, PreparationOptions& options);

/// Prepares the layer's photo, and reports what the steps found. @throws FileError, InvalidModel
Report prepareLayer(TextureLayer& layer, const PreparationOptions& options);

} // namespace esm
