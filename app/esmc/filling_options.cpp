#include "app/esmc/filling_options.h"

#include "app/esmc/arguments.h"
#include "app/esmc/report.h"
#include "core/solid/filled_body.h"
#include "core/support/numbers.h"

namespace esm {

void declareFilling(CLI::App& command, FillingOptions& options, const std::string& without) {
    std::vector<std::string> known;
    known.reserve(wordsOf<LatticeKind>.size() + 1);
    for (const auto& [kind, word] : wordsOf<LatticeKind>)
        known.emplace_back(word);
    known.emplace_back("none");
    command
        .add_option_function<std::string>(
            "--fill", [&options](const std::string& given) { options.kind = fromWord<LatticeKind>(given); },
            "Lattice of springs that fills a closed organ; " + without)
        ->check(oneOf(known))
        ->option_text(joined(known, "|"));
    command
        .add_option("--spacing", options.spacing,
                    "Distance between neighbouring nodes inside, m (default: for about " +
                        roundedText(usualLatticeNodes) + " nodes)")
        ->check(positiveNumber())
        ->option_text("M");
}

std::optional<LatticeFilling> chosenFilling(const TriangleMesh& mesh, const FillingOptions& options) {
    if (!options.kind && options.spacing) throw UsageError("--spacing: say with --fill what fills the organ");
    if (!options.kind) return std::nullopt;
    return options.spacing ? LatticeFilling{*options.kind, *options.spacing} : fillingOf(mesh, *options.kind);
}

} // namespace esm
