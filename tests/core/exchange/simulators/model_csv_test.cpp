#include "core/exchange/simulators/model_csv.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

using Numbers = std::vector<double>;
using Integers = std::vector<std::int32_t>;
using Texts = std::vector<std::string>;

TEST(ModelCsv, HasHeadingsWithUnits) {
    const ModelTable table{"all",
                           {{"place", "m", {"x", "y", "z"}, Numbers{}},
                            {"damping", "N·m·s/rad", {}, Numbers{}},
                            {"firmness", "N/m", {}, Numbers{}},
                            {"stiffness", "Pa", {}, Numbers{}},
                            {"ends", "", {"node_1", "node_2"}, Integers{}},
                            {"name", "", {}, Texts{}}}};
    EXPECT_EQ(csvOf(table),
              "x_m,y_m,z_m,damping_nms_per_rad,firmness_n_per_m,stiffness_pa,node_1,node_2,name\n");
}

TEST(ModelCsv, HasARowInALineAndNumbersThatReadBackTheSame) {
    const ModelTable table{"all",
                           {{"place", "", {"x", "y"}, Numbers{0.1 + 0.2, -1e-300, 0, 1e30}},
                            {"number", "", {}, Integers{-1, 7}},
                            {"name", "", {}, Texts{"Leber, \"rechts\"", "ü / ö"}}}};
    EXPECT_EQ(csvOf(table), "x,y,number,name\n"
                            "0.30000000000000004,-1.0e-300,-1,\"Leber, \"\"rechts\"\"\"\n"
                            "0,1.0e+30,7,ü / ö\n");
}

} // namespace
} // namespace esm
