#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "core/dynamics/measure/extremes.h"
#include "core/support/file_io.h"

#include <sstream>

namespace esm {

namespace {

struct ExtremesOptions {
    std::string output;
};

void declareExtremes(CLI::App& command, ExtremesOptions& options) {
    command.add_option("-o,--output", options.output, "Page to write the table to (.md)")
        ->check(writtenAs(".md"));
}

Json summaryInJson(const ExtremeSummary& summary) {
    return {{"family", summary.family},   {"integrator", integratorName(summary.integrator)},
            {"ran", summary.ran},         {"stopped", summary.stopped},
            {"refused", summary.refused}, {"reason", summary.reason}};
}

std::string page(const std::vector<ExtremeSummary>& summaries) {
    std::ostringstream text;
    text << "# Stability at the extremes\n\n"
            "Written by `esmc extremes -o docs/stability.md`. Each case is a sheet of 36 nodes, pulled at "
            "one node by what\n"
            "lengthens its softest spring by a millimetre (tenfold: by 10 N), for 100 of 200 steps. *Ran*: "
            "to the end, every\n"
            "number finite and no energy that the pull did not give. *Stopped*: with the reason and the last "
            "good state, as a\n"
            "step that was given may be too long. *Refused*: with the reason, before a step was taken or, by "
            "`propagation`,\n"
            "within one.\n";
    std::string family;
    for (const ExtremeSummary& summary : summaries) {
        if (summary.family != family) {
            family = summary.family;
            text << "\n## " << static_cast<char>(std::toupper(static_cast<unsigned char>(family[0])))
                 << family.substr(1) << "\n\n| integrator | ran | stopped | refused | the first reason |\n"
                 << "|---|---:|---:|---:|---|\n";
        }
        text << "| `" << integratorName(summary.integrator) << "` | " << summary.ran << " | "
             << summary.stopped << " | " << summary.refused << " | " << summary.reason << " |\n";
    }
    return text.str();
}

Report runExtremes(const ExtremesOptions& options, Context& context) {
    const std::vector<ExtremeSummary> summaries = sweepExtremes(progressOf(context, "sweeping the extremes"));
    Report report;
    report.json["families"] = Json::array();
    int ran = 0, stopped = 0, refused = 0;
    for (const ExtremeSummary& summary : summaries) {
        report.json["families"].push_back(summaryInJson(summary));
        ran += summary.ran;
        stopped += summary.stopped;
        refused += summary.refused;
    }
    report.text.push_back(counted(static_cast<std::size_t>(ran), "case") + " ran, " +
                          std::to_string(stopped) + " stopped and " + std::to_string(refused) +
                          " were refused, each with its reason");
    if (options.output.empty()) return report;
    const std::string text = page(summaries);
    writeFileAtomically(options.output, text);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addExtremesCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<ExtremesOptions>{"extremes",
                                        "Run every integrator at the edges of what can be asked for",
                                        declareExtremes, runExtremes});
}

} // namespace esm
