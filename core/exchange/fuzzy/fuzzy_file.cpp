#include "core/exchange/fuzzy/fuzzy_file.h"

#include "core/exchange/fields_json.h"
#include "core/exchange/fuzzy/embedded_presets.h"
#include "core/exchange/fuzzy/fcl_file.h"
#include "core/exchange/fuzzy/fll_file.h"
#include "core/exchange/fuzzy/fuzzy_source.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

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

Json toJson(const FuzzyVariable& variable) {
    Json terms = Json::object();
    for (const FuzzyTerm& term : variable.terms)
        terms[term.name] = {term.set.a, term.set.b, term.set.c, term.set.d};
    Json json{{"range", {variable.minimum, variable.maximum}}};
    if (!variable.unit.empty()) json["unit"] = variable.unit;
    json["terms"] = std::move(terms);
    return json;
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

/// Rules can only be read against sound variables, which stand before them in the table.
template<class Base> struct SystemReading : Base {
    FuzzySystem& system;
    std::vector<std::string>& problems;

    void read(const JsonReader& reader, std::vector<FuzzyVariable>& variables) const {
        for (const auto& [name, json] : reader.members()) {
            if constexpr (Typed<Base>) json.allowOnly({"range", "unit", "terms"});
            variables.push_back(variableFromJson(name, json));
        }
    }
    template<HasWords Norm> void read(const JsonReader& reader, Norm& norm) const {
        const std::string word = reader.text();
        if (const std::optional<Norm> named = fromWord<Norm>(word))
            norm = *named;
        else if (reader.json().is_string())
            reader.addProblem("is \"" + word + "\"; it may be " + joined(allWords<Norm>()));
    }
    void read(const JsonReader& reader, std::vector<FuzzyRule>&) const {
        if (problems.empty()) problems = validate(system);
        if (problems.empty()) readRules(system, reader, problems);
    }
};

struct SystemWriting {
    const FuzzySystem& system;

    Json write(const std::vector<FuzzyVariable>& variables) const {
        Json json = Json::object();
        for (const FuzzyVariable& variable : variables)
            json[variable.name] = toJson(variable);
        return json;
    }
    Json write(const std::vector<FuzzyRule>& rules) const {
        Json json = Json::array();
        for (const FuzzyRule& rule : rules)
            json.push_back(ruleText(system, rule));
        return json;
    }
};

void throwIfAny(const std::vector<std::string>& problems) {
    if (!problems.empty()) throw InvalidModel(problems);
}

template<class Base> FuzzySystem fuzzySystemFrom(const Json& json) {
    std::vector<std::string> problems;
    FuzzySystem system;
    readFields(JsonReader(json, "", problems), system, SystemReading<Base>{{}, system, problems});
    throwIfAny(problems);
    throwIfAny(validate(system)); // as a whole the rules may be too many
    return system;
}

enum class FuzzyLanguage { Json, Fcl, Fll };

FuzzyLanguage languageOf(const std::filesystem::path& file) {
    const std::string ending = endingOf(file);
    if (ending == ".fcl") return FuzzyLanguage::Fcl;
    return ending == ".fll" ? FuzzyLanguage::Fll : FuzzyLanguage::Json;
}

FuzzySystem fuzzySystemFromUsersJson(const Bytes& content) {
    const std::string text = sourceText(content);
    return fuzzySystemFrom<TypedForms>(parseJson(text.data(), text.data() + text.size()));
}

} // namespace

FuzzySystem fuzzySystemFromJson(const Json& json) {
    return fuzzySystemFrom<PlainForms>(json);
}

Json toJson(const FuzzySystem& system) {
    return writtenFields(system, SystemWriting{system});
}

ImportedFuzzySystem importFuzzyFile(const std::filesystem::path& file) {
    const FuzzyLanguage language = languageOf(file);
    ImportedFuzzySystem imported;
    try {
        if (language == FuzzyLanguage::Fcl)
            imported = fuzzySystemFromFcl(readFile(file, largestFuzzySource));
        else if (language == FuzzyLanguage::Fll)
            imported = fuzzySystemFromFll(readFile(file, largestFuzzySource));
        else
            imported.system = fuzzySystemFromUsersJson(readFile(file, largestFuzzySource));
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
    if (imported.system.name.empty()) imported.system.name = file.stem().string();
    return imported;
}

bool isFuzzyFileName(const std::filesystem::path& file) {
    return languageOf(file) != FuzzyLanguage::Json || endingOf(file) == ".json";
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
