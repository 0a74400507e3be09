#include "core/exchange/project/projector_file.h"

#include "core/exchange/fields_json.h"
#include "core/exchange/project/rigid_pose.h"
#include "core/support/errors.h"

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// Perspective is a matter of course where a field of view or intrinsics are given.
ProjectorKind kindOf(const JsonReader& reader) {
    const bool isSeen = reader.has("fov") || reader.has("intrinsics");
    if (!reader.has("kind")) return isSeen ? ProjectorKind::Perspective : ProjectorKind::Parallel;
    return reader.json()["kind"] == wordOf(ProjectorKind::Perspective) ? ProjectorKind::Perspective
                                                                       : ProjectorKind::Parallel;
}

/// Whether nothing says what a field of view or intrinsics say already, or has no use for them.
bool isOneOfAKind(const JsonReader& reader, ProjectorKind kind) {
    const bool hasIntrinsics = reader.has("intrinsics"), hasView = reader.has("fov");
    if (kind == ProjectorKind::Perspective) {
        if (!hasIntrinsics || !hasView) return true;
        reader.member("intrinsics").addProblem("stands in place of a field of view; leave one of them away");
        return false;
    }
    for (const char* key : {"fov", "intrinsics"})
        if (reader.has(key))
            reader.member(key).addProblem("belongs to a perspective projector; leave it away");
    return !hasIntrinsics && !hasView;
}

} // namespace

/// What kind it is, and whether by intrinsics, decides which of its fields a projector has.
Projector projectorFromJson(const JsonReader& reader) {
    Projector projector;
    if (reader.json().is_object()) {
        projector.kind = kindOf(reader);
        if (!isOneOfAKind(reader, projector.kind)) return projector;
        if (reader.has("intrinsics")) projector.intrinsics.emplace();
    }
    readFields(reader, projector, TypedForms());
    return projector;
}

Projector projectorFromJson(const Json& json) {
    std::vector<std::string> problems;
    Projector projector = projectorFromJson(JsonReader(json, "", problems));
    if (!problems.empty()) throw InvalidModel(problems);
    return projector;
}

Json toJson(const Projector& projector) {
    return writtenFields(projector);
}

Projector readProjectorFile(const std::filesystem::path& file) {
    const Json json = readJsonFile(file);
    try {
        return projectorFromJson(json);
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
}

} // namespace esm
