#include "core/exchange/simulators/sofa/sofa_folder.h"

#include "core/exchange/simulators/obj_surface.h"
#include "core/support/new_folder.h"

namespace esm {

namespace {

void writeXsp(const std::filesystem::path& file, const std::vector<VectorSpring>& springs,
              const SpringNetwork& network) {
    if (!springs.empty()) writeFileAtomically(file, xspText(springs, network.restPositions));
}

void writeSofaFiles(const Handover& handover, const std::filesystem::path& folder, const HandoverMeans& means,
                    std::optional<SofaRecording> recording) {
    ProgressParts parts(means.progress);
    NewFolder written(folder);
    const std::filesystem::path& place = written.unfinished();
    const SpringNetwork& network = *handover.tissue.network;
    const SpringSystem system = makeSpringSystem(handover.tissue);
    SofaSubject subject = sofaSubject(handover, system, withProgress(means, parts.next(0.15)));
    subject.recording = std::move(recording);
    writeFileAtomically(place / sofaSceneFile, sofaSceneText(subject));
    reportProgress(parts.next(0.1), 1);
    writeXsp(place / dampingFile, subject.viscous, network);
    reportProgress(parts.next(0.1), 1);
    writeXsp(place / hingeFile, subject.bending, network);
    const HandoverMeans rest = withProgress(means, parts.next(0.6));
    if (isDrawn(subject)) writeObjSurface(handover.project, place, rest);
    reportProgress(parts.rest(), 1);
    written.commit();
}

} // namespace

void writeSofa(const Handover& handover, const std::filesystem::path& folder, const HandoverMeans& means) {
    writeSofaFiles(handover, folder, means, std::nullopt);
}

void writeRecordedSofa(const Handover& handover, const std::filesystem::path& folder,
                       const HandoverMeans& means, const SofaRecording& recording) {
    writeSofaFiles(handover, folder, means, recording);
}

} // namespace esm
