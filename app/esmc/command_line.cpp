#include "app/esmc/command_line.h"

#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "core/support/errors.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <new>
#include <thread>

namespace esm {

namespace {

enum ExitCode { Done = 0, Failed = 1, WrongUsage = 2 };

void describe(CLI::App& app, Context& context) {
    app.description("The Elastodynamic Shape Modeler without a window: deformable organ models from meshes,\n"
                    "words and photographs. Lengths in metres, SI units throughout.");
    app.name("esmc");
    app.set_version_flag("--version", "esmc " ESM_VERSION);
    app.fallthrough();
    app.require_subcommand(1);
    app.add_flag("--json", context.json, "Print one JSON object instead of text");
    app.add_option("-j,--threads", context.threads, "Threads at most; the result does not depend on it")
        ->transform(wholeNumber(1, 4096));
    addImportCommand(app, context);
    addSampleCommand(app, context);
    addInfoCommand(app, context);
    addFuzzyCommands(app, context);
    addTissueCommand(app, context);
    addScaleCommand(app, context);
    addInsideCommand(app, context);
    addSheetCommand(app, context);
    addSceneCommand(app, context);
    addSimulateCommand(app, context);
    addStabilityCommand(app, context);
    addTradeoffCommand(app, context);
    addProbeCommand(app, context);
    addExtremesCommand(app, context);
    addTextureCommands(app, context);
    addExportCommand(app, context);
    addValidateCommand(app, context);
    addRenderCommand(app, context);
}

/// The innermost command that was named.
const CLI::App& named(const CLI::App& app) {
    const auto commands = app.get_subcommands();
    return commands.empty() ? app : named(*commands.front());
}

/// "esmc texture pack": a command with those it belongs to.
std::string fullName(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent ? fullName(*parent) + " " + command.get_name() : "esmc";
}

std::string usageProblem(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& command = named(app);
    std::vector<std::string> choices;
    for (const CLI::App* choice : command.get_subcommands([](const CLI::App*) { return true; }))
        choices.push_back(choice->get_name());
    if (choices.empty()) return error.what();
    for (const std::string& word : command.remaining())
        if (word.rfind('-', 0) != 0)
            return "there is no command '" + word + "'; there are " + joined(choices);
    return command.remaining().empty() ? "name a command: " + joined(choices) : error.what();
}

int fail(ExitCode code, const std::string& message) {
    printError(message);
    return code;
}

/// With the file the work was about, for problems that do not name one.
std::string about(const Context& context, const std::string& problem) {
    return context.subject.empty() ? problem : context.subject.string() + ": " + problem;
}

/// OSMesa draws with threads of its own, one per processor unless its environment says otherwise when its
/// first context is made: 0 is none beside the caller's.
void limitDrawing(int threads) {
    if (threads > 0) ::setenv("LP_NUM_THREADS", std::to_string(threads == 1 ? 0 : threads).c_str(), 1);
}

int runWork(Context& context) {
    // More than run at once only wait for each other.
    context.threads =
        std::min(context.threads, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    limitDrawing(context.threads);
    const std::size_t threads =
        context.threads > 0 ? static_cast<std::size_t>(context.threads)
                            : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Report report = context.work();
    addFileWarnings(report, context.warnings);
    print(report, context.json);
    return report.failure.empty() ? Done : fail(Failed, about(context, report.failure));
}

} // namespace

int runCommandLine(int argc, char** argv) {
    Context context;
    CLI::App app;
    describe(app, context);
    try {
        app.parse(argc, argv);
        return runWork(context);
    } catch (const CLI::Success& request) {
        return app.exit(request, std::cout, std::cerr);
    } catch (const CLI::ParseError& error) {
        return fail(WrongUsage, usageProblem(app, error) + "; see " + fullName(named(app)) + " --help");
    } catch (const UsageError& error) {
        return fail(WrongUsage, std::string(error.what()) + "; see " + fullName(named(app)) + " --help");
    } catch (const Cancelled&) {
        context.interruption.acknowledge();
        return fail(Failed, "stopped; nothing was written");
    } catch (const FileError& error) {
        return fail(Failed, error.what());
    } catch (const std::bad_alloc&) {
        return fail(Failed, about(context, "needs more memory than there is"));
    } catch (const std::exception& error) {
        return fail(Failed, about(context, error.what()));
    }
}

} // namespace esm
