#include "core/exchange/charts/chart_file.h"

#include "core/exchange/image_file.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"
#include "core/support/letters.h"

namespace esm {

bool isChartFile(const std::filesystem::path& file) {
    const std::string ending = endingOf(file);
    return ending == ".svg" || ending == ".png";
}

void writeChart(const Drawing& chart, const std::filesystem::path& file) {
    if (!isChartFile(file)) throw FileError(file, "a chart is a .svg or a .png: name the file so");
    if (endingOf(file) == ".svg") return writeFileAtomically(file, toSvg(chart));
    writePng(toImage(chart), file);
}

} // namespace esm
