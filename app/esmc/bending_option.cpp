#include "app/esmc/bending_option.h"

#include "app/esmc/arguments.h"

namespace esm {

namespace {

std::optional<double> requestedThickness(const std::string& given) {
    if (given == "none") return std::nullopt;
    double thickness = 0;
    if (!CLI::detail::lexical_cast(given, thickness) || !(thickness > 0 && thickness <= thickestWall))
        throw UsageError("--bending: '" + given + "' is neither a thickness above 0 and at most " +
                         inText(thickestWall) + " m nor none");
    return thickness;
}

} // namespace

void declareBending(CLI::App& command, BendingOption& option) {
    command
        .add_option_function<std::string>(
            "--bending",
            [&option](const std::string& given) {
                option = {true, requestedThickness(given)};
            },
            "A hollow organ's surface resists bending as a wall of M metres does; none, the default: it "
            "bends freely")
        ->option_text("M|none");
}

void setBending(Project& project, const BendingOption& option) {
    if (!option.isGiven) return;
    if (option.thickness && !hasWall(*project.network))
        throw UsageError("--bending: only a hollow organ has a wall; one that is filled or rigid keeps "
                         "its form without");
    project.base.resistsBending = option.thickness.has_value();
    if (option.thickness) project.base.wallThickness = *option.thickness;
}

void addBending(Report& report, const BaseTissue& base, const SpringNetwork& network) {
    report.json["bending_thickness"] = base.resistsBending ? Json(base.wallThickness) : Json();
    if (!base.resistsBending) {
        report.text.emplace_back("bending: free");
        return;
    }
    const std::string wall = "a wall of " + inText(1000 * base.wallThickness) + " mm";
    report.text.push_back(hasWall(network)
                              ? "bending: resisted as by " + wall
                              : "bending: free, " + wall + " is of no use to a filled or rigid organ");
}

} // namespace esm
