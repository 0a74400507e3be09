#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/file_io.h"
#include "tests/core/exchange/fields_set_in_none.h"
#include "tests/support/samples.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

TEST(FuzzyFileSamples, AreReadAndWrittenAsTheyWere) {
    for (const std::filesystem::path& file : samples("fuzzy")) {
        SCOPED_TRACE(file.filename());
        const ImportedFuzzySystem read = importFuzzyFile(file);
        EXPECT_THAT(read.warnings, testing::IsEmpty());
        const std::string text = exportFuzzySystem(read.system, file).text;
        EXPECT_TRUE(readFile(file) == Bytes(text.begin(), text.end())) << text;
    }
}

TEST(FuzzyFileSamples, SayTheSameInEveryLanguage) {
    for (std::filesystem::path file : samples("fuzzy")) {
        SCOPED_TRACE(file.filename());
        const FuzzySystem system = importFuzzyFile(file).system;
        for (const char* ending : {".json", ".fcl", ".fll"})
            EXPECT_TRUE(importFuzzyFile(file.replace_extension(ending)).system == system) << ending;
    }
}

TEST(FuzzyFileSamples, SetEveryField) {
    std::vector<FuzzySystem> systems;
    std::vector<FuzzyNorms> norms;
    for (const std::filesystem::path& file : samples("fuzzy")) {
        systems.push_back(importFuzzyFile(file).system);
        norms.push_back(systems.back().norms);
    }
    EXPECT_THAT(fieldsSetInNone(systems), testing::IsEmpty());
    EXPECT_THAT(fieldsSetInNone(norms), testing::IsEmpty());
}

} // namespace
} // namespace esm
