#include "core/exchange/project/tissue_preset_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_input.h"

/// Published tissues, and that they can be laid into an organ and shown.
void esm::fuzz::readInput(const Bytes& content) {
    const TissuePreset preset = tissuePresetFromJson(jsonFrom(content));
    Region region;
    Scene scene;
    layPreset(region, preset);
    tiePreset(scene, preset);
    expect(isMeasured(preset) || !publishedText(preset).empty() || preset.published == PublishedTissue(),
           "a tissue that says nothing");
}
