#include "core/exchange/project/accuracy_json.h"

#include "core/exchange/project/scene_file.h"
#include "core/exchange/tissue_json.h"

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

bool isKnown(const JsonReader& run) {
    const Json& integrator = run.member("integrator").json();
    return !integrator.is_string() || integratorFromName(integrator.get<std::string>());
}

Json toJson(const MeasuredOrgan& organ) {
    return {{"tissue", organ.tissue}, {"scene", toJson(organ.scene)}};
}

/// Those of integrators that this program knows.
template<class Run> std::vector<Run> knownRuns(const JsonReader& list) {
    std::vector<Run> runs;
    for (const JsonReader& run : list.elements())
        if (isKnown(run)) runs.push_back(valueFrom<Run>(run, SteppingForms()));
    return runs;
}

MeasuredOrgan organFromJson(const JsonReader& reader) {
    return {reader.member("tissue").text(), readScene(reader.member("scene"))};
}

} // namespace

Json toJson(const MeasuredAccuracy& accuracy) {
    Json json = toJson(accuracy.organ);
    json["detail"] = written(accuracy.detail);
    if (accuracy.onFewerNodes) json["onFewerNodes"] = toJson(*accuracy.onFewerNodes);
    json["reference"] = written(accuracy.reference, SteppingForms());
    json["runs"] = written(accuracy.runs, SteppingForms());
    if (!accuracy.leftOut.empty()) json["leftOut"] = written(accuracy.leftOut, SteppingForms());
    return json;
}

MeasuredAccuracy accuracyFromJson(const JsonReader& reader) {
    MeasuredAccuracy accuracy;
    if (!reader.isObject()) return accuracy;
    accuracy.organ = organFromJson(reader);
    accuracy.detail = valueFrom<Detail>(reader.member("detail"));
    if (reader.has("onFewerNodes")) accuracy.onFewerNodes = organFromJson(reader.member("onFewerNodes"));
    accuracy.reference = valueFrom<TradeoffReference>(reader.member("reference"), SteppingForms());
    accuracy.runs = knownRuns<TradeoffRun>(reader.member("runs"));
    if (reader.has("leftOut")) accuracy.leftOut = knownRuns<LeftOutRun>(reader.member("leftOut"));
    return accuracy;
}

std::vector<std::string> accuracyWarnings(const Json& json, const MeasuredAccuracy& read) {
    const std::size_t written = json["runs"].size() + (json.contains("leftOut") ? json["leftOut"].size() : 0);
    const std::size_t unknown = written - read.runs.size() - read.leftOut.size();
    if (unknown == 0) return {};
    return {std::to_string(unknown) +
            " of the measured runs are of integrators that this program does not know: they are left out"};
}

} // namespace esm
