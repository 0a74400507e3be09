#pragma once

#include "app/esmc/report.h"
#include "app/esmc/runnable_model.h"
#include "core/exchange/charts/press_chart.h"
#include "core/exchange/charts/strip_chart.h"

namespace esm {

/// What a virtual test told of a model, ready to be handed back.
struct Tested {
    Json json;
    std::vector<std::string> text;
    std::vector<std::string> warnings;
    std::optional<Eigen::Vector3d> along{}; ///< of a strip
};

/// The curves of all models that were tested, for charts and tables; of one kind of test.
struct TestCurves {
    std::vector<NamedPress> presses;
    std::vector<NamedStrip> strips;

    Drawing chart() const { return strips.empty() ? pressChart(presses) : stripChart(strips); }
    std::string table() const { return strips.empty() ? pressCsv(presses) : stripCsv(strips); }
};

/// Presses a finger into a model, and keeps the curve under the name of its file.
Tested pressed(const RunnableModel& model, const std::filesystem::path& file, const ProbeSettings& settings,
               const Progress& progress, TestCurves& curves);

/// Stretches a strip of it. A wall is as thick as the project says; a package does not say it.
Tested stretched(const RunnableModel& model, const std::filesystem::path& file, StripSettings settings,
                 const Progress& progress, TestCurves& curves);

} // namespace esm
