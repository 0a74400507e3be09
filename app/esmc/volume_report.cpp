#include "app/esmc/volume_report.h"

#include "core/support/numbers.h"
#include "core/support/pressure_units.h"

namespace esm {

std::string pressureInText(double pascal) {
    return inText(pascal) + " Pa (" + roundedText(pascal / pascalPerMillimetreOfMercury, 4) + " mmHg)";
}

void addVolumes(Report& report, const TissueModel& tissue, const std::vector<FluidRow>& rows) {
    if (tissue.cavities.empty()) return;
    report.json["volumes"] = Json::array();
    for (std::size_t i = 0; i < tissue.cavities.size(); ++i) {
        const Cavity& cavity = tissue.cavities[i];
        const double atRest = enclosedVolume({tissue.network->restPositions, cavity.triangles});
        Json times = Json::array(), volumes = Json::array(), pressures = Json::array();
        for (const FluidRow& row : rows) {
            times.push_back(row.time);
            volumes.push_back(inJson(row.volumes[i]));
            pressures.push_back(inJson(row.pressures[i]));
        }
        report.json["volumes"].push_back({{"part", cavity.part},
                                          {"at_rest", atRest},
                                          {"times", times},
                                          {"volumes", volumes},
                                          {"pressures", pressures}});
        if (rows.empty()) continue;
        report.text.push_back("part " + std::to_string(cavity.part) +
                              " at the end: " + inText(1e6 * rows.back().volumes[i]) + " ml, " +
                              percentText(rows.back().volumes[i] / atRest) +
                              " of its volume at rest, under " + pressureInText(rows.back().pressures[i]));
    }
}

} // namespace esm
