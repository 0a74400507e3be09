// Measures how the cost of what a user waits for grows with the surface, and fails where it grows faster than
// it may.

#include "tests/growth/lumpy_organ.h"
#include "tests/growth/operations.h"
#include "tests/growth/power_law.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>

using namespace growth;

namespace {

constexpr double mostExponent = 1.1;
constexpr std::size_t sizes[] = {10000, 30000, 100000, 300000, 1000000};
/// What an operation costs here is none of the surface's.
constexpr std::size_t nextToNothing = 200;

/// Short ones are disturbed most.
int repetitionsFor(std::size_t triangles) {
    return triangles <= 1000 ? 25 : triangles <= 30000 ? 15 : triangles <= 300000 ? 5 : 3;
}

/// The least of several, because whatever else the machine does adds to it.
Usage best(const Operation& operation, const Files& files, int repetitions) {
    Usage least = operation.measure(files);
    for (int i = 1; i < repetitions; ++i) {
        const Usage usage = operation.measure(files);
        least = {std::min(least.seconds, usage.seconds), std::min(least.mebibytes, usage.mebibytes)};
    }
    return least;
}

struct Measured {
    double triangles;
    std::vector<Usage> usage; ///< of each operation
};

Measured measureAll(std::size_t size, const std::vector<Operation>& all, int mostRepetitions) {
    const TemporaryFolder folder;
    const Files files(folder);
    Measured measured;
    measured.triangles =
        runApart([&] { return static_cast<double>(writeLumpyOrgan(files.mesh, size)); }).result;
    for (const Operation& operation : all) {
        const int repetitions = operation.isJudged ? std::min(mostRepetitions, repetitionsFor(size)) : 1;
        measured.usage.push_back(best(operation, files, repetitions));
        std::cerr << size << " triangles: " << operation.name << ", " << measured.usage.back().seconds
                  << " s, " << measured.usage.back().mebibytes << " MiB\n";
    }
    return measured;
}

/// What one operation costs beyond what it costs next to nothing. That varies by a part of itself, so that of
/// less than such a part nothing is certain.
std::vector<Sample> samplesOf(std::size_t operation, double Usage::*cost, double least,
                              const std::vector<Measured>& measured) {
    constexpr double uncertainPart = 0.1;
    std::vector<Sample> samples;
    const double atNothing = measured[0].usage[operation].*cost;
    for (std::size_t i = 1; i < measured.size(); ++i) {
        const double beyond = std::max(measured[i].usage[operation].*cost - atNothing, least);
        const double certain = beyond / (beyond + uncertainPart * atNothing);
        samples.push_back({measured[i].triangles, beyond, certain * certain});
    }
    return samples;
}

/// @return whether the exponent is beyond what is allowed by more than it is uncertain
bool printRow(const std::string& name, double atNothing, const std::vector<Sample>& samples, bool isJudged) {
    const PowerLaw law = fitPowerLaw(samples);
    const bool isTooMuch = isJudged && law.exponent - 2 * law.spread > mostExponent;
    std::printf("%-23s %8.3g |", name.c_str(), atNothing);
    for (const Sample& sample : samples)
        std::printf(" %8.3g", sample.cost);
    const char* const verdict = !isJudged                     ? "not judged"
                                : isTooMuch                   ? "TOO MUCH"
                                : law.exponent > mostExponent ? "above, but not for certain"
                                                              : "";
    std::printf("   %.2f ± %.2f   %.2f  %s\n", law.exponent, law.spread, lastExponent(samples), verdict);
    return isTooMuch;
}

void printHead(const char* what) {
    std::printf("\n%-23s %8zu |", what, nextToNothing);
    for (const std::size_t size : sizes)
        std::printf(" %8zu", size);
    std::printf("   exponent, of the last two sizes alone\n");
}

/// @return whether all grow as slowly as they have to
bool printTables(const std::vector<Operation>& all, const std::vector<Measured>& measured) {
    bool isSlow = true;
    printHead("processor time, s");
    for (std::size_t i = 0; i < all.size(); ++i)
        isSlow &= !printRow(all[i].name, measured[0].usage[i].seconds,
                            samplesOf(i, &Usage::seconds, 1e-4, measured), all[i].isJudged);
    printHead("memory, MiB");
    for (std::size_t i = 0; i < all.size(); ++i)
        printRow(all[i].name, measured[0].usage[i].mebibytes, samplesOf(i, &Usage::mebibytes, 0.1, measured),
                 false);
    std::printf(
        "\nRight of the bar: beyond what it costs on %zu triangles. Least of several runs. Time with an "
        "exponent above %.1f by more\nthan twice its standard error is too much%s.\n",
        nextToNothing, mostExponent, isSlow ? ": there is none" : "");
    return isSlow;
}

int measureGrowth(int mostRepetitions) {
    const std::vector<Operation> all = operations();
    std::vector<Measured> measured{measureAll(nextToNothing, all, mostRepetitions)};
    for (const std::size_t size : sizes)
        measured.push_back(measureAll(size, all, mostRepetitions));
    return printTables(all, measured) ? 0 : 1;
}

} // namespace

/// growth [REPETITIONS]: at most so many of each. Ends with 1 where something grows too fast, with 2 where it
/// cannot be measured.
int main(int argumentCount, char** arguments) try {
    return measureGrowth(argumentCount > 1 ? std::max(1, std::atoi(arguments[1])) : 25);
} catch (const std::exception& problem) {
    std::cerr << "growth: " << problem.what() << '\n';
    return 2;
}
