#pragma once

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/core/fuzzy/random_systems.h"
#include "tests/support/rounds.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

inline esm::Bytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

inline std::string withReplaced(std::string text, const std::string& part, const std::string& by) {
    const std::size_t place = text.find(part);
    EXPECT_NE(place, std::string::npos) << part;
    return place == std::string::npos ? text : text.replace(place, part.size(), by);
}

/// What reading the text says; "accepted" where it is taken.
template<class Read> std::string complaintOf(const Read& read, const std::string& text) {
    try {
        read(bytesOf(text));
    } catch (const esm::InvalidModel& error) {
        return error.what();
    }
    return "accepted";
}

/// Sound, but of names and sets that other languages have trouble with.
inline esm::FuzzySystem awkwardSystem() {
    esm::FuzzySystem system;
    system.name = "weich & zäh *) # 1";
    system.description = " two\nlines \\n and a \ttab";
    system.note = "(* nested *) // more";
    system.inputs = {
        {"term", -2, 3, {{"very", {-2, -2, -1, 0}}, {"Very", {-1, -1, 1, 1}}, {"zäh", {0, 3, 3, 3}}}},
        {"a:b;", 0, 1e-7, {{"10%", {-1, 0, 0, 1e-7}}, {"at", {0, 0, 0, 0}}}}};
    system.outputs = {
        {"spring-const", 0, 1e30, {{"x", {0, 0, 1, 1e30}}, {"#y", {5, 5, 5, 5}}}},
        {"Term", 0, 1, {{"low", {0, 0, 0, 0}}, {"high", {0.1 + 0.2, 0.1 + 0.2, 0.1 + 0.2, 0.1 + 0.2}}}}};
    system.inputs[0].unit = "µm² *)";
    for (const std::size_t length : {300U, 301U})
        system.inputs[1].terms.push_back({std::string(length, 'x'), {0, 0, 0, 0}});
    system.outputs[1].unit = "N·s/m";
    esm::FuzzyRule rule{esm::disjunction({{{0, 0}}, esm::negation({{1, 0}})}), {{0, 0}, {1, 1}}};
    rule.weight = 0.25;
    system.rules = {rule, {{{0, 2}}, {{1, 0}}}};
    system.norms = {esm::TNorm::Product, esm::TConorm::BoundedSum, esm::TNorm::BoundedDifference,
                    esm::TConorm::ProbabilisticSum};
    return system;
}

/// A language that systems are written in as text.
struct TextLanguage {
    esm::ImportedFuzzySystem (*read)(const esm::Bytes& content);
    esm::ExportedFuzzySystem (*write)(const esm::FuzzySystem& system);

    esm::ImportedFuzzySystem readText(const std::string& text) const { return read(bytesOf(text)); }

    void expectBack(const esm::FuzzySystem& system) const {
        const std::string text = write(system).text;
        const esm::ImportedFuzzySystem back = readText(text);
        EXPECT_EQ(toJson(back.system), toJson(system)) << text;
        EXPECT_TRUE(back.warnings.empty()) << text;
    }

    /// Of presets, of awkward names and sets, and of random systems.
    void expectAllBack(int seed) const {
        for (const std::string& name : esm::fuzzyPresetNames())
            expectBack(esm::fuzzyPreset(name));
        expectBack(awkwardSystem());
        RandomSystems systems(seedOf(seed));
        for (int trial = 0; trial < roundsOf(100, 10000); ++trial)
            expectBack(systems.next());
    }
};
