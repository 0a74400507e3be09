#include "core/exchange/charts/measured_runs_csv.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(MeasuredRunsCsv, HasALineForEachRunWithFiguresThatReadBack) {
    Tradeoff tradeoff;
    tradeoff.runs = {{{Integrator::Split2, 0.1 / 3, Precision::Double}, 812, true, 1.0 / 7, true, 0.25, {}},
                     {{Integrator::Euler, 1e-5, Precision::Float}, 812, false, 0, false, 0, {}}};
    recommend(tradeoff, {});
    EXPECT_EQ(measuredRunsCsv(tradeoff),
              "integrator,precision,step_s,nodes,stable,error,error_is_bound,wall_per_simulated_s,"
              "real_time_factor,unbeaten\n"
              "split2,double,0.03333333333333333,812,yes,0.14285714285714285,yes,0.25,4,yes\n"
              "euler,float,1e-05,812,no,,,,,no\n");
}
