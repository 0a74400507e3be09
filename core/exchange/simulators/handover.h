#pragma once

#include "core/authoring/baked_pages.h"
#include "core/dynamics/settings.h"
#include "core/exchange/picture_encoding.h"
#include "core/exchange/provenance.h"
#include "core/exchange/simulators/sofa/sofa_version.h"

#include <functional>

namespace esm {

/// Draws a picture of the organ.
using DrawPreview = std::function<Image(const Project& project, const BakedPages& pages)>;

/// A project with all that a simulator needs to know of it, valid and evaluated once.
struct Handover {
    Project project; ///< with an atlas, where photos lie on a surface or its occlusion is asked for
    TissueModel tissue;
};

/// Photos of a project whose atlas is not packed yet get one packed with the project's settings.
/// @throws InvalidModel with every problem of the project and of the tissue that it comes to; Cancelled
Handover handoverOf(const Project& project, const Progress& progress = {});

/// Of the scene's moves those that lead a node: one that the tissue has, and does not fix.
std::vector<NodeMove> movesOf(const Handover& handover);

/// How another program's engine is to step the organ.
struct EngineSettings {
    std::optional<double> timeStep;       ///< s; what suits the engine without
    Damping damping = Damping::Isotropic; ///< of springs
    SofaVersion sofaVersion = newestSofaVersion;
};

/// What helps to write a handover, beside the handover itself.
struct HandoverMeans {
    Progress progress;
    DrawPreview drawPreview; ///< none: without a picture
    PictureEncoding pictures = {};
    EngineSettings engine = {}; ///< of what is written for an engine
    Authorship authorship = {}; ///< as the user says it
};

/// The same means for a part of the work.
HandoverMeans withProgress(HandoverMeans means, Progress progress);

} // namespace esm
