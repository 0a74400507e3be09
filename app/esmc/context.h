#pragma once

#include "app/esmc/interruption.h"
#include "app/esmc/report.h"
#include "core/support/progress.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace esm {

/// What the commands share.
struct Context {
    Interruption interruption;
    bool json = false;
    int threads = 0;                   ///< 0: as many as there are
    std::filesystem::path subject;     ///< the file that a message without a file's name is about
    std::vector<std::string> warnings; ///< of the files that were read, beside those of the command's report
    std::function<Report()> work; ///< of the command that was named; run once the whole line is understood
};

/// Progress of long work: stops it on Ctrl-C and shows `label` with a percentage where standard error is a
/// terminal.
Progress progressOf(const Context& context, const std::string& label);

/// `Options` is a plain struct, filled by what `declare` adds to the parser; `run` does the work.
template<typename Options> struct Command {
    std::string name, description;
    void (*declare)(CLI::App&, Options&);
    Report (*run)(const Options&, Context&);
};

/// Lets no option of the command be given with an empty value, which would read as if it were left out.
void refuseEmptyValues(CLI::App& command);

/// Adds a command whose options live as long as the parser.
template<typename Options>
void addCommand(CLI::App& parent, Context& context, const Command<Options>& command) {
    CLI::App* parser = parent.add_subcommand(command.name, command.description);
    const auto options = std::make_shared<Options>();
    command.declare(*parser, *options);
    refuseEmptyValues(*parser);
    parser->callback([options, run = command.run, &context] {
        context.work = [options, run, &context] { return run(*options, context); };
    });
}

} // namespace esm
