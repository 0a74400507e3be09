#include "app/esmc/wall_option.h"

#include "app/esmc/arguments.h"

namespace esm {

namespace {

std::optional<double> requestedThickness(const std::string& given) {
    if (given == "none") return std::nullopt;
    double thickness = 0;
    if (!CLI::detail::lexical_cast(given, thickness) || !(thickness > 0 && thickness <= thickestWall))
        throw UsageError("--wall-thickness: '" + given + "' is neither a thickness above 0 and at most " +
                         inText(thickestWall) + " m nor none");
    return thickness;
}

} // namespace

void declareWall(CLI::App& command, WallOption& option) {
    command
        .add_option_function<std::string>(
            "--wall-thickness",
            [&option](const std::string& given) {
                option = {true, requestedThickness(given)};
            },
            "A hollow organ's surface resists bending as a wall of M metres does; none, the default: it "
            "bends freely")
        ->option_text("M|none");
}

void setWall(Project& project, const WallOption& option) {
    if (!option.isGiven) return;
    if (option.thickness && !hasWall(*project.network))
        throw UsageError(
            "--wall-thickness: only a hollow organ has a wall; one that is filled or rigid keeps "
            "its form without");
    project.base.bendingThickness = option.thickness;
}

void addBending(Report& report, const BaseTissue& base, const SpringNetwork& network) {
    const std::optional<double>& thickness = base.bendingThickness;
    report.json["bending_thickness"] = thickness ? Json(*thickness) : Json();
    if (!thickness) {
        report.text.emplace_back("bending: free");
        return;
    }
    const std::string wall = "a wall of " + inText(1000 * *thickness) + " mm";
    report.text.push_back(hasWall(network)
                              ? "bending: resisted as by " + wall
                              : "bending: free, " + wall + " is of no use to a filled or rigid organ");
}

} // namespace esm
