#include "core/exchange/simulators/sofa/sofa_run.h"

#include "core/exchange/simulators/sofa/sofa_folder.h"
#include "core/support/atomic_file.h"
#include "core/support/child_process.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"
#include "core/support/scratch_folder.h"
#include "core/support/text_lines.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/wait.h>
#include <system_error>

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr const char* sofaVariable = "ESM_RUNSOFA";
constexpr double usualRecords = 20;
constexpr double mostSofaSteps = 2e9;                ///< it counts them in an int
constexpr std::uintmax_t mostOutput = 1'000'000'000; ///< bytes; more is no use to anybody

/// Where a run finds and leaves its files.
struct SofaPlaces {
    fs::path program, folder;

    fs::path organ() const { return folder / "organ.sofa"; }
    fs::path states() const { return folder / "states.txt"; }
    fs::path output() const { return folder / "output.txt"; }
};

/// The last bytes of a file, at most so many; none where it cannot be read.
std::string endOf(const fs::path& file, std::streamoff most) {
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const std::streamoff size = stream.tellg();
    if (!stream || size <= 0) return {};
    std::string end(static_cast<std::size_t>(std::min(size, most)), ' ');
    stream.seekg(size - static_cast<std::streamoff>(end.size()));
    stream.read(end.data(), static_cast<std::streamsize>(end.size()));
    end.resize(static_cast<std::size_t>(stream.gcount()));
    return end;
}

/// The last of what SOFA said, in one line, for a message.
std::string lastWords(const fs::path& output) {
    constexpr std::streamoff longest = 600;
    std::string said = endOf(output, longest);
    for (char& letter : said)
        if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = ' ';
    const std::size_t first = said.find_first_not_of(' ');
    return first == said.npos ? "it said nothing" : "it said: " + said.substr(first);
}

/// What SOFA makes in its user's home goes away with the folder.
std::vector<std::string> atHomeIn(const fs::path& folder, std::vector<std::string> words) {
    words.insert(words.begin(), {"/usr/bin/env", "HOME=" + folder.string()});
    return words;
}

/// SOFA ends even where this process is killed: setpriv asks the system for that and becomes SOFA.
std::vector<std::string> boundToThisProcess(std::vector<std::string> words) {
    if (const auto binder = programInPath("setpriv"))
        words.insert(words.begin(), {binder->string(), "--pdeathsig", "KILL", "--"});
    return words;
}

Descriptor outputFile(const fs::path& file) {
    const Descriptor first(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
    Descriptor output = first.number() < 0 ? Descriptor() : beyondStandardFiles(first);
    if (output.number() < 0) throw FileError(file, writingProblem(errno));
    return output;
}

ChildProcess startSofa(const SofaPlaces& places, std::size_t steps, const Descriptor& output) {
    try {
        return ChildProcess(
            {.words = boundToThisProcess(
                 atHomeIn(places.folder, {places.program.string(), "-g", "batch", "-n", std::to_string(steps),
                                          (places.organ() / sofaSceneFile).string()})),
             .output = output.number(),
             .errors = output.number()});
    } catch (const std::system_error& error) {
        throw FileError(places.program, std::string("cannot be started: ") + error.code().message() +
                                            "; check that it is SOFA's runSofa and may be run");
    }
}

/// How much of what SOFA is to write is there already. A coordinate takes some nine letters.
double shareWritten(const fs::path& states, std::size_t nodes, std::size_t records) {
    constexpr double lettersOfNode = 27;
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(states, error);
    if (error) return 0;
    const double expected = lettersOfNode * static_cast<double>(nodes) * static_cast<double>(records + 1);
    return std::min(static_cast<double>(bytes) / expected, 0.99);
}

/// Else a program that complains at every step fills the disk.
void requireFewWords(const SofaPlaces& places) {
    std::error_code error;
    const std::uintmax_t said = fs::file_size(places.output(), error);
    if (!error && said > mostOutput)
        throw FileError(places.program, "said more than 1 GB and was ended; " + lastWords(places.output()));
}

/// SOFA steps scenes of other releases, with less or more damping, and says nothing.
void requireRelease(const fs::path& program, SofaVersion wanted) {
    const auto release = releaseOfProgram(program);
    if (release && *release != wanted)
        throw FileError(program, std::string("is of release ") + wordOf(*release) +
                                     ", and the organ is handed over for " + wordOf(wanted) +
                                     "; choose that release, or name a runSofa of the other by ESM_RUNSOFA");
}

/// What SOFA says on the way is no sign: a release without graphics names missing parts of drawing as errors,
/// and moves the organ all the same.
void requireSofaEnded(const SofaPlaces& places, int status) {
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    const std::string end = WIFSIGNALED(status) ? std::string("by \"") + ::strsignal(WTERMSIG(status)) + '"'
                                                : "with " + std::to_string(WEXITSTATUS(status));
    throw FileError(places.program,
                    "ended " + end +
                        " instead of moving the organ; check that the release that is asked for is "
                        "its own; " +
                        lastWords(places.output()));
}

/// SOFA does not notice a full disk: it ends as if all were written.
void requireAllStates(const SofaPlaces& places, std::size_t found, const SofaSchedule& schedule) {
    if (found >= schedule.records + 1) return;
    constexpr std::uintmax_t roomForMore = 1 << 20;
    std::error_code error;
    if (fs::space(places.folder, error).available < roomForMore)
        throw FileError(places.folder,
                        "has no room for the motion: the disk is full; free some and try again");
    if (found == 0)
        throw FileError(places.program,
                        "ran and wrote no motion; check that the release that is asked for is its own; " +
                            lastWords(places.output()));
    throw FileError(places.program, "wrote " + std::to_string(found - 1) + " of the " +
                                        std::to_string(schedule.records) + " states that were asked for; " +
                                        lastWords(places.output()));
}

/// s, as in "101 iterations done in 0.42 s ( 240 FPS).", which it says by two clocks; the last is the finer
/// one.
std::optional<double> secondsIn(std::string_view text) {
    constexpr std::string_view words = "iterations done in ";
    const std::size_t found = text.rfind(words);
    if (found == text.npos) return std::nullopt;
    std::string_view rest = text.substr(found + words.size());
    const auto seconds = wholeNumber<double>(takeWord(rest));
    return seconds && isAmount(*seconds) ? seconds : std::nullopt;
}

/// What is wrong with them is told of the program: their file is gone by then.
std::vector<SofaState> writtenStates(const SofaPlaces& places, std::size_t nodes, std::size_t most,
                                     const Progress& progress) {
    if (!fs::exists(places.states())) return {};
    try {
        return readSofaStates(places.states(), nodes, most, progress);
    } catch (const FileError&) {
        throw FileError(places.program,
                        "wrote a motion that is too long or cannot be read; choose a shorter scene");
    } catch (const InvalidModel& refusal) {
        throw FileError(places.program, std::string("wrote a motion that ") + refusal.what());
    }
}

double wallSecondsOf(const SofaPlaces& places) {
    constexpr std::streamoff longest = 65536;
    if (const auto seconds = secondsIn(endOf(places.output(), longest))) return *seconds;
    throw FileError(places.program, "did not say how long it took; " + lastWords(places.output()));
}

} // namespace

std::optional<fs::path> installedSofa() {
    const char* const named = ::secure_getenv(sofaVariable);
    if (!named || !*named) return programInPath("runSofa");
    return canBeRun(named) ? std::optional<fs::path>(named) : std::nullopt;
}

std::optional<SofaVersion> releaseOfProgram(const fs::path& program) {
    std::error_code error;
    const std::string name = fs::canonical(program, error).filename().string();
    for (const auto& [version, word] : wordsOf<SofaVersion>)
        if (name.starts_with("runSofa-" + std::string(word))) return version;
    return std::nullopt;
}

SofaSchedule sofaSchedule(double duration, double timeStep) {
    const double steps = std::max(1.0, std::round(duration / timeStep));
    if (!(steps <= mostSofaSteps))
        throw InvalidModel("the scene's " + roundedText(duration) + " s are more steps of " +
                           roundedText(timeStep) + " s than SOFA counts; choose a longer time step");
    const double stepsPerRecord = std::max(1.0, std::floor(steps / usualRecords));
    return {timeStep, static_cast<std::size_t>(stepsPerRecord),
            static_cast<std::size_t>(steps / stepsPerRecord)};
}

SofaRun runInSofa(const fs::path& program, const Handover& handover, const HandoverMeans& means,
                  const SofaSchedule& schedule) {
    constexpr std::chrono::milliseconds moment{50};
    requireRelease(program, means.engine.sofaVersion);
    const ScratchFolder scratch;
    const SofaPlaces places{program, scratch.path()};
    const std::size_t nodes = handover.tissue.mass.size();
    ProgressParts parts(means.progress);
    writeRecordedSofa(handover, places.organ(), withProgress(means, parts.next(0.1)),
                      {places.states(), schedule.every()});
    const Progress running = parts.next(0.8);
    // A state is written as the next step begins.
    const std::size_t steps = schedule.stepsPerRecord * schedule.records + 1;
    {
        const Descriptor output = outputFile(places.output());
        ChildProcess sofa = startSofa(places, steps, output);
        while (!sofa.endsWithin(moment)) {
            requireFewWords(places);
            reportProgress(running, shareWritten(places.states(), nodes, schedule.records));
        }
        requireSofaEnded(places, sofa.status());
    }
    SofaRun run;
    run.states = writtenStates(places, nodes, schedule.records + 1, parts.rest());
    requireAllStates(places, run.states.size(), schedule);
    run.wallPerSimulatedSecond = wallSecondsOf(places) / (schedule.timeStep * static_cast<double>(steps));
    reportProgress(means.progress, 1);
    return run;
}

} // namespace esm
