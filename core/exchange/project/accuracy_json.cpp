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
    return json;
}

MeasuredAccuracy accuracyFromJson(const JsonReader& reader) {
    MeasuredAccuracy accuracy;
    if (!reader.isObject()) return accuracy;
    accuracy.organ = organFromJson(reader);
    accuracy.detail = valueFrom<Detail>(reader.member("detail"));
    if (reader.has("onFewerNodes")) accuracy.onFewerNodes = organFromJson(reader.member("onFewerNodes"));
    accuracy.reference = valueFrom<TradeoffReference>(reader.member("reference"), SteppingForms());
    for (const JsonReader& run : reader.member("runs").elements())
        if (isKnown(run)) accuracy.runs.push_back(valueFrom<TradeoffRun>(run, SteppingForms()));
    return accuracy;
}

std::vector<std::string> accuracyWarnings(const Json& json, const MeasuredAccuracy& read) {
    const std::size_t leftOut = json["runs"].size() - read.runs.size();
    if (leftOut == 0) return {};
    return {std::to_string(leftOut) +
            " of the measured runs are of integrators that this program does not know: they are left out"};
}

} // namespace esm
