#include "app/editor/panels/measure/poke_files.h"

#include "core/exchange/charts/curve_drawing.h"
#include "core/exchange/charts/table_text.h"
#include "core/support/numbers.h"

namespace esm {

Drawing pokeChart(const std::vector<NamedMotion>& motions) {
    std::vector<DrawnCurve> curves;
    for (const auto& [name, motion] : motions) {
        curves.push_back({name, {}, {}});
        for (const PokePicture& picture : motion->pictures)
            curves.back().points.push_back({picture.time, picture.force});
    }
    return curveDrawing({"time, s", "force, N"}, curves);
}

std::string pokeCsv(const std::vector<NamedMotion>& motions) {
    std::string text = "name,time_s,force_n,displacement_m\n";
    for (const auto& [name, motion] : motions)
        for (const PokePicture& picture : motion->pictures)
            text += quoted(name) + ',' + exactText(picture.time) + ',' + exactText(picture.force) + ',' +
                    exactText(picture.displacement) + '\n';
    return text;
}

} // namespace esm
