#include "app/esmc/virtual_tests.h"

#include "app/esmc/volume_report.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

Json timeCurveInJson(const TimeCurve& curve) {
    Json json;
    json["time"] = inJson(curve.timeConstant);
    json["end"] = {{"depth", curve.end.depth}, {"force", curve.end.force}};
    json["curve"] = Json::array();
    for (const auto& [time, depth, force] : curve.points)
        json["curve"].push_back({{"time", time}, {"depth", depth}, {"force", force}});
    return json;
}

Json probeInJson(const ProbeResult& result, double radius) {
    Json json;
    json["place"] = inJson(result.place);
    json["direction"] = inJson(result.direction);
    json["radius"] = radius;
    json["depth"] = result.curve.back().depth;
    json["force"] = result.curve.back().force;
    json["stiffness_at_start"] = result.stiffnessAtStart;
    json["stiffness"] = result.stiffness;
    json["poissons_ratio"] = result.poissonsRatio;
    json["youngs_modulus"] = result.youngsModulus;
    json["relaxation_time"] = result.relaxation ? inJson(result.relaxation->timeConstant) : Json();
    json["creep_time"] = result.creep ? inJson(result.creep->timeConstant) : Json();
    json["curve"] = Json::array();
    for (const auto& [depth, force] : result.curve)
        json["curve"].push_back({{"depth", depth}, {"force", force}});
    for (const InflatedPart& inflated : result.inflated)
        json["inflated"].push_back({{"part", inflated.part},
                                    {"pressure", inflated.pressure},
                                    {"volume", inflated.volume},
                                    {"at_rest", inflated.restVolume}});
    if (result.relaxation) json["relaxation"] = timeCurveInJson(*result.relaxation);
    if (result.creep) json["creep"] = timeCurveInJson(*result.creep);
    return json;
}

std::string timeConstantInText(const std::string& what, const TimeCurve& curve) {
    if (!curve.timeConstant) return what + ": not within the test, or next to none";
    return what + ": " + inText(*curve.timeConstant) + " s until 1/e of the way is left";
}

std::vector<std::string> probeInText(const ProbeResult& result) {
    const PressPoint& full = result.curve.back();
    std::vector<std::string> text;
    for (const InflatedPart& inflated : result.inflated)
        text.push_back("part " + std::to_string(inflated.part) + " under " +
                       pressureInText(inflated.pressure) + ": " + inText(1e6 * inflated.volume) + " ml, " +
                       percentText(inflated.volume / inflated.restVolume) + " of its volume at rest");
    text.push_back(inText(full.force) + " N at " + inText(1000 * full.depth) + " mm, pressed at " +
                   inText(result.place) + " m");
    text.push_back("stiffness " + inText(result.stiffnessAtStart / 1000) + " N/mm at the start, " +
                   inText(result.stiffness / 1000) + " N/mm at full depth");
    text.push_back("resists as a wide, deep solid of " + inText(result.youngsModulus / 1000) +
                   " kPa would, at Poisson's ratio " + inText(result.poissonsRatio));
    if (result.relaxation) text.push_back(timeConstantInText("relaxation", *result.relaxation));
    if (result.creep)
        text.push_back(timeConstantInText("creep", *result.creep) + ", to " +
                       inText(1000 * result.creep->end.depth) + " mm");
    return text;
}

Json stripInJson(const StripResult& result, const StripSettings& settings) {
    Json json;
    json["place"] = inJson(result.place);
    json["along"] = inJson(result.along);
    json["length"] = settings.length;
    json["width"] = settings.width;
    json["nodes"] = result.nodeCount;
    json["elongation"] = result.curve.back().elongation;
    json["strain"] = result.curve.back().strain;
    json["force"] = result.curve.back().force;
    json["stiffness_at_start"] = result.stiffnessAtStart;
    json["stiffness"] = result.stiffness;
    json["membrane_stiffness"] = inJson(result.membraneStiffness);
    json["youngs_modulus"] = inJson(result.youngsModulus);
    json["curve"] = Json::array();
    for (const auto& [elongation, strain, force] : result.curve)
        json["curve"].push_back({{"elongation", elongation}, {"strain", strain}, {"force", force}});
    return json;
}

std::vector<std::string> stripInText(const StripResult& result) {
    const StripPoint& full = result.curve.back();
    std::vector<std::string> text;
    text.push_back("strip at " + inText(result.place) + " m along " + inText(result.along));
    text.push_back(inText(full.force) + " N when " + inText(1000 * full.elongation) +
                   " mm longer; its middle is stretched by " + inText(100 * full.strain) + " %");
    text.push_back("stiffness " + inText(result.stiffnessAtStart / 1000) + " N/mm at the start, " +
                   inText(result.stiffness / 1000) + " N/mm at full stretch");
    if (result.membraneStiffness)
        text.push_back("stiffness of the wall " + inText(*result.membraneStiffness) +
                       " N/m (Young's modulus times thickness)");
    if (result.youngsModulus)
        text.push_back("Young's modulus " + inText(*result.youngsModulus / 1000) + " kPa");
    return text;
}

/// Why there is no modulus.
std::vector<std::string> stripWarnings(const StripResult& result, const std::string& file) {
    if (result.membraneStiffness || result.youngsModulus) return {};
    return {file + ": the strip is slack to the end, as one that is bent or folded is until it is straight: "
                   "stretch it further (--stretch)"};
}

} // namespace

Tested pressed(const RunnableModel& model, const std::filesystem::path& file, const ProbeSettings& settings,
               const Progress& progress, TestCurves& curves) {
    const ProbeResult result = probe({model.tissue, model.surface}, settings, progress);
    curves.presses.push_back({file.stem().string(), result.curve});
    Tested tested{probeInJson(result, settings.radius), probeInText(result), {}, {}};
    if (result.meetsFixed)
        tested.warnings.push_back(file.string() +
                                  ": the finger also lies on fixed nodes, whose force is not counted");
    return tested;
}

Tested stretched(const RunnableModel& model, const std::filesystem::path& file, StripSettings settings,
                 const Progress& progress, TestCurves& curves) {
    if (model.project) settings.wallThickness = model.project->base.wallThickness;
    const StripResult result = pullStrip({model.tissue, model.surface}, settings, progress);
    curves.strips.push_back({file.stem().string(), result.curve});
    return {stripInJson(result, settings), stripInText(result), stripWarnings(result, file.string()),
            result.along};
}

} // namespace esm
