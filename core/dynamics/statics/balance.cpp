#include "core/dynamics/statics/balance.h"

namespace esm {

bool findRest(double tolerance, const std::function<double()>& left, const std::function<bool()>& go) {
    constexpr int manySteps = 50, mostSteps = 1000;
    for (int step = 0; step < mostSteps; ++step) {
        const double now = left();
        if (now <= tolerance || (step >= manySteps && now <= nearlyBalanced)) return true;
        if (!go()) return now <= nearlyBalanced;
    }
    return false;
}

} // namespace esm
