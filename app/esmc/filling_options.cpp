#include "app/esmc/filling_options.h"

#include "app/esmc/arguments.h"
#include "app/esmc/report.h"
#include "core/project/wall.h"
#include "core/solid/filled_body.h"
#include "core/solid/prism_wall.h"
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
            "Lattice of springs that fills a closed organ, or prisms: a wall beneath its surface, which may "
            "be "
            "open; " +
                without)
        ->check(oneOf(known))
        ->option_text(joined(known, "|"));
    command
        .add_option("--spacing", options.spacing,
                    "Distance between neighbouring nodes inside, m (default: for about " +
                        roundedText(usualLatticeNodes) + " nodes)")
        ->check(positiveNumber())
        ->option_text("M");
    command
        .add_option("--wall-thickness", options.wallThickness,
                    "Thickness of a wall of prisms, m (default: that of the organ's wall, 0.003 until it is "
                    "said)")
        ->check(numberWithin(0, thickestWall))
        ->check(positiveNumber())
        ->option_text("M");
    command
        .add_option("--layers", options.layers,
                    "Layers of prisms, one beneath the other, 1 to " + std::to_string(mostWallLayers) +
                        " (default: none much thicker than triangles are wide)")
        ->check(wholeNumber(1, mostWallLayers))
        ->option_text("N");
}

std::optional<LatticeFilling> chosenFilling(const TriangleMesh& mesh, const FillingOptions& options,
                                            double wallThickness) {
    const bool hasWall = options.kind == LatticeKind::Prisms;
    if (!options.kind && options.spacing) throw UsageError("--spacing: say with --fill what fills the organ");
    if (hasWall && options.spacing)
        throw UsageError("--spacing: prisms have a wall's thickness instead, --wall-thickness");
    if (!hasWall && (options.wallThickness || options.layers))
        throw UsageError(std::string(options.layers ? "--layers" : "--wall-thickness") +
                         ": is said of a wall, --fill prisms");
    if (!options.kind) return std::nullopt;
    if (hasWall) {
        const double thickness = options.wallThickness.value_or(wallThickness);
        return LatticeFilling{*options.kind, 0, thickness,
                              options.layers.value_or(usualLayers(mesh, thickness))};
    }
    return options.spacing ? LatticeFilling{*options.kind, *options.spacing} : fillingOf(mesh, *options.kind);
}

} // namespace esm
