#pragma once

#include "core/dynamics/spring_system.h"
#include "core/exchange/simulators/handover.h"
#include "core/exchange/simulators/sofa/sofa_release.h"
#include "core/exchange/simulators/sofa/vector_springs.h"

#include <filesystem>
#include <optional>
#include <string>

namespace esm {

/// What SOFA writes down while it steps the organ: where the nodes are at 0, every, 2·every and so on.
struct SofaRecording {
    std::filesystem::path file;
    double every; ///< s, a multiple of the step
};

/// What a scene of SOFA is written from. How it steps the organ follows from the damping:
///
/// Isotropic: implicit Euler solved by conjugate gradients, as SOFA's scenes usually do. A spring's own
/// damping would enter the forces alone there, and blow up at any step that strong damping does not bear. So
/// viscosity d stands in a field of vector springs of the constant d/r, whose Rayleigh damping is r: the
/// solver's matrix then has d, and with r = 10⁹ s the constant holds nothing.
///
/// Axial: symplectic Euler, whose steps are this program's `euler`, with the viscosity in the springs.
struct SofaSubject {
    const Handover& handover;
    const SpringSystem& system; ///< of its tissue
    SofaRelease release;
    Damping damping;
    double timeStep; ///< s
    PictureFormat pictures;
    std::vector<VectorSpring> viscous, bending; ///< in `dampingFile` and `hingeFile`
    std::optional<SofaRecording> recording = {};

    bool isImplicit() const { return damping == Damping::Isotropic; }
};

inline constexpr const char* sofaSceneFile = "organ.scn";
inline constexpr const char *hingeFile = "bending.xsp", *dampingFile = "damping.xsp";

/// What of a scene SOFA is handed: no instruments, splits, fluids and pressures.
Scene sceneInSofa(Scene scene);

/// @param system of the handover's tissue @throws Cancelled
SofaSubject sofaSubject(const Handover& handover, const SpringSystem& system, const HandoverMeans& means);

/// s, predicted; infinite where there is no limit. @throws Cancelled
double largestSofaStep(const TissueModel& tissue, Damping damping, const Progress& progress = {});

/// s, that an organ is handed over with: what is asked for, else the usual one. @throws Cancelled
double sofaStep(const TissueModel& tissue, const EngineSettings& engine, const Progress& progress = {});

/// Whether a drawn surface can follow the nodes in SOFA. It lies on triangles or in tetrahedra of nodes; on
/// the line of a rigid organ it would collapse.
bool isDrawnInSofa(const Handover& handover);
/// Not where SOFA writes the motion down: nobody sees it then, and leading the surface would take its time.
bool isDrawn(const SofaSubject& subject);

/// s, the step where none is asked for: 5 ms of implicit Euler, where a tube of the published tissue [R C.1]
/// is off by some 0.2 % of its motion; of symplectic Euler nine tenths of the largest stable one, at most as
/// long.
double usualSofaStepFor(Damping damping, double largestStep);

/// The scene that is loaded. It names the other files of its folder.
std::string sofaSceneText(const SofaSubject& subject);

} // namespace esm
