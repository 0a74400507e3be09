#include "core/exchange/simulators/mujoco/mujoco_folder.h"

#include "core/exchange/simulators/mujoco/mujoco_model.h"
#include "core/exchange/simulators/obj_surface.h"
#include "core/support/atomic_file.h"
#include "core/support/new_folder.h"

namespace esm {

void writeMujoco(const Handover& handover, const std::filesystem::path& folder, const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    NewFolder written(folder);
    const SpringSystem system = makeSpringSystem(handover.tissue);
    const MujocoSubject subject = mujocoSubject(handover, system, withProgress(means, parts.next(0.2)));
    const std::string text = mujocoModelText(subject);
    reportProgress(parts.next(0.2), 1);
    writeFileAtomically(written.unfinished() / "organ.xml", text);
    writeTexturePages(handover.project, written.unfinished(), withProgress(means, parts.next(0.5)));
    reportProgress(parts.rest(), 1);
    written.commit();
}

} // namespace esm
