#include "core/exchange/fuzzy/fuzzy_file.h"

#include "core/exchange/fuzzy/embedded_presets.h"
#include "core/exchange/fuzzy/fcl_file.h"
#include "core/exchange/fuzzy/fll_file.h"
#include "core/exchange/fuzzy/fuzzy_source.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/support/json_reader.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

FuzzyVariable variableFromJson(const std::string& name, const JsonReader& reader) {
    FuzzyVariable variable;
    variable.name = name;
    if (!reader.json().is_object()) return variable;
    const std::vector<double> range = reader.member("range").numbers(2);
    variable.minimum = range[0];
    variable.maximum = range[1];
    if (reader.has("unit")) variable.unit = reader.member("unit").text();
    for (const auto& [term, corners] : reader.member("terms").members()) {
        const std::vector<double> abcd = corners.numbers(4);
        variable.terms.push_back({term, {abcd[0], abcd[1], abcd[2], abcd[3]}});
    }
    return variable;
}

std::vector<FuzzyVariable> variablesFromJson(const JsonReader& reader) {
    std::vector<FuzzyVariable> variables;
    for (const auto& [name, json] : reader.members())
        variables.push_back(variableFromJson(name, json));
    return variables;
}

void readRules(FuzzySystem& system, const JsonReader& reader, std::vector<std::string>& problems) {
    const std::vector<JsonReader> rules = reader.elements();
    if (rules.size() > mostFuzzyRules) {
        problems.push_back(tooManyRules(rules.size()));
        return;
    }
    for (const JsonReader& rule : rules) {
        const std::string text = rule.text();
        if (!rule.json().is_string()) continue;
        try {
            system.rules.push_back(parseRule(system, text));
        } catch (const InvalidModel& error) {
            problems.push_back(rule.place() + ", " + error.what());
        }
    }
}

template<class Norm>
void readNorm(const JsonReader& norms, const char* key, Norm& norm,
              std::optional<Norm> (*fromName)(const std::string&), const std::string& names) {
    if (!norms.has(key)) return;
    const JsonReader reader = norms.member(key);
    const std::string name = reader.text();
    if (const std::optional<Norm> named = fromName(name))
        norm = *named;
    else if (reader.json().is_string())
        reader.addProblem("is \"" + name + "\"; it may be " + names);
}

FuzzyNorms normsFromJson(const JsonReader& reader) {
    FuzzyNorms norms;
    reader.members(); // says so where it is no object
    readNorm(reader, "conjunction", norms.conjunction, tNormFromName, tNormNames());
    readNorm(reader, "disjunction", norms.disjunction, tConormFromName, tConormNames());
    readNorm(reader, "implication", norms.implication, tNormFromName, tNormNames());
    readNorm(reader, "aggregation", norms.aggregation, tConormFromName, tConormNames());
    return norms;
}

/// Those that are not the default.
Json toJson(const FuzzyNorms& norms) {
    constexpr FuzzyNorms usual;
    Json json = Json::object();
    if (norms.conjunction != usual.conjunction) json["conjunction"] = normName(norms.conjunction);
    if (norms.disjunction != usual.disjunction) json["disjunction"] = normName(norms.disjunction);
    if (norms.implication != usual.implication) json["implication"] = normName(norms.implication);
    if (norms.aggregation != usual.aggregation) json["aggregation"] = normName(norms.aggregation);
    return json;
}

void noteOtherKeys(const JsonReader& reader) {
    reader.allowOnly({"name", "description", "note", "inputs", "outputs", "norms", "rules"});
    if (reader.has("norms"))
        reader.member("norms").allowOnly({"conjunction", "disjunction", "implication", "aggregation"});
    for (const char* list : {"inputs", "outputs"}) {
        if (!reader.has(list)) continue;
        for (const auto& [name, variable] : reader.member(list).members())
            variable.allowOnly({"range", "unit", "terms"});
    }
}

enum class FuzzyLanguage { Json, Fcl, Fll };

FuzzyLanguage languageOf(const std::filesystem::path& file) {
    const std::string ending = inSmallLetters(file.extension().string());
    if (ending == ".fcl") return FuzzyLanguage::Fcl;
    return ending == ".fll" ? FuzzyLanguage::Fll : FuzzyLanguage::Json;
}

void throwIfAny(const std::vector<std::string>& problems) {
    if (!problems.empty()) throw InvalidModel(problems);
}

Json toJson(const std::vector<FuzzyVariable>& variables) {
    Json json = Json::object();
    for (const FuzzyVariable& variable : variables) {
        Json terms = Json::object();
        for (const FuzzyTerm& term : variable.terms)
            terms[term.name] = {term.set.a, term.set.b, term.set.c, term.set.d};
        Json& entry = json[variable.name];
        entry["range"] = {variable.minimum, variable.maximum};
        if (!variable.unit.empty()) entry["unit"] = variable.unit;
        entry["terms"] = std::move(terms);
    }
    return json;
}

FuzzySystem fuzzySystemFromUsersJson(const Bytes& content) {
    const std::string text = sourceText(content);
    const Json json = parseJson(text.data(), text.data() + text.size());
    std::vector<std::string> problems;
    noteOtherKeys(JsonReader(json, "", problems));
    throwIfAny(problems);
    return fuzzySystemFromJson(json);
}

} // namespace

FuzzySystem fuzzySystemFromJson(const Json& json) {
    std::vector<std::string> problems;
    const JsonReader reader(json, "", problems);
    FuzzySystem system;
    if (reader.has("name")) system.name = reader.member("name").text();
    if (reader.has("description")) system.description = reader.member("description").text();
    if (reader.has("note")) system.note = reader.member("note").text();
    system.inputs = variablesFromJson(reader.member("inputs"));
    system.outputs = variablesFromJson(reader.member("outputs"));
    if (reader.has("norms")) system.norms = normsFromJson(reader.member("norms"));
    const JsonReader rules = reader.member("rules");
    throwIfAny(problems);

    throwIfAny(validate(system)); // rules can only be read against sound variables
    readRules(system, rules, problems);
    throwIfAny(problems);
    throwIfAny(validate(system)); // as a whole they may be too many
    return system;
}

Json toJson(const FuzzySystem& system) {
    Json json{{"name", system.name}};
    if (!system.description.empty()) json["description"] = system.description;
    json["note"] = system.note;
    json["inputs"] = toJson(system.inputs);
    json["outputs"] = toJson(system.outputs);
    if (Json norms = toJson(system.norms); !norms.empty()) json["norms"] = std::move(norms);
    json["rules"] = Json::array();
    for (const FuzzyRule& rule : system.rules)
        json["rules"].push_back(ruleText(system, rule));
    return json;
}

ImportedFuzzySystem importFuzzyFile(const std::filesystem::path& file) {
    const FuzzyLanguage language = languageOf(file);
    ImportedFuzzySystem imported;
    try {
        if (language == FuzzyLanguage::Fcl)
            imported = fuzzySystemFromFcl(readFile(file));
        else if (language == FuzzyLanguage::Fll)
            imported = fuzzySystemFromFll(readFile(file));
        else
            imported.system = fuzzySystemFromUsersJson(readFile(file));
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
    if (imported.system.name.empty()) imported.system.name = file.stem().string();
    return imported;
}

bool isFuzzyFileName(const std::filesystem::path& file) {
    return languageOf(file) != FuzzyLanguage::Json || inSmallLetters(file.extension().string()) == ".json";
}

ExportedFuzzySystem exportFuzzySystem(const FuzzySystem& system, const std::filesystem::path& file) {
    switch (languageOf(file)) {
    case FuzzyLanguage::Fcl:
        return toFcl(system);
    case FuzzyLanguage::Fll:
        return toFll(system);
    default:
        return {toJson(system).dump(1) + "\n", {}};
    }
}

std::vector<std::string> fuzzyPresetNames() {
    return namesOf(embeddedFuzzyPresets());
}

FuzzySystem fuzzyPreset(const std::string& name) {
    if (const auto json = jsonOf(embeddedFuzzyPresets(), name)) return fuzzySystemFromJson(*json);
    throw InvalidModel("there is no fuzzy system \"" + name + "\"; name a file or one of " +
                       joined(fuzzyPresetNames()));
}

bool isFuzzyPreset(const FuzzySystem& system) {
    const std::vector<std::string> names = fuzzyPresetNames();
    if (std::find(names.begin(), names.end(), system.name) == names.end()) return false;
    FuzzySystem preset = fuzzyPreset(system.name);
    preset.description = system.description;
    preset.note = system.note;
    return toJson(system) == toJson(preset);
}

ImportedFuzzySystem findFuzzySystem(const std::string& fileOrPreset) {
    const std::filesystem::path file(fileOrPreset);
    const std::vector<std::string> presets = fuzzyPresetNames();
    const bool isPreset = std::find(presets.begin(), presets.end(), fileOrPreset) != presets.end();
    const bool looksLikeFile = file.has_extension() || file.has_parent_path();
    std::error_code ignored;
    if (!isPreset && (looksLikeFile || std::filesystem::exists(file, ignored))) return importFuzzyFile(file);
    return {fuzzyPreset(fileOrPreset), {}};
}

} // namespace esm
