#pragma once

#include "app/esmc/context.h"
#include "core/dynamics/contact/touched_surface.h"
#include "core/project/project.h"

namespace esm {

/// What a run needs of a project or a package.
struct RunnableModel {
    TissueModel tissue;
    TouchedSurface surface;
    Scene scene;
    std::optional<MeasuredStepping> stepping; ///< that is recommended
    std::optional<Project> project;           ///< none of a package
    std::shared_ptr<const TriangleMesh> mesh; ///< what is drawn, never null
    std::vector<std::string> warnings;        ///< what is stored and the scene leaves out
};

/// Reads a project or a package, and the scene file that takes the place of what is stored, if one is named.
/// Afterwards the context speaks of the model.
/// @throws FileError, InvalidModel
RunnableModel loadRunnableModel(const std::filesystem::path& model, const std::filesystem::path& scene,
                                Context& context);

/// A run that records no node has no motion to tell the error of. @throws InvalidModel
void requireRecording(const Scene& scene);

} // namespace esm
