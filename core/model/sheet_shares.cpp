#include "core/model/sheet_shares.h"

#include "core/support/offenders.h"

namespace esm {

namespace {

constexpr double largestSheetShare = 1000;

void checkShares(std::vector<std::string>& problems, const std::string& subject,
                 const std::vector<double>& shares, std::size_t count) {
    if (shares.size() != count)
        problems.push_back(std::to_string(shares.size()) + " of " + std::to_string(count) + " " + subject +
                           "s have a share of the sheet");
    reportOffenders(problems, subject, "whose share of the sheet is not above 0, or beyond 1000",
                    placesWhere(shares.size(), [&](std::size_t i) {
                        return !(shares[i] > 0 && shares[i] <= largestSheetShare);
                    }));
}

} // namespace

std::vector<std::string> validate(const SheetShares& shares, std::size_t springCount, std::size_t nodeCount) {
    std::vector<std::string> problems;
    checkShares(problems, "spring", shares.springs, springCount);
    checkShares(problems, "node", shares.nodes, nodeCount);
    return problems;
}

} // namespace esm
