#include "core/support/offenders.h"

#include <algorithm>

namespace esm {

void reportOffenders(std::vector<std::string>& problems, const std::string& subject,
                     const std::string& complaint, const std::vector<std::size_t>& offenders) {
    constexpr std::size_t mostNamed = 5;
    if (offenders.empty()) return;
    std::string text = std::to_string(offenders.size()) + " " + subject + (offenders.size() > 1 ? "s " : " ");
    text += complaint + " (" + subject;
    for (std::size_t i = 0; i < std::min(offenders.size(), mostNamed); ++i)
        text += (i > 0 ? ", " : " ") + std::to_string(offenders[i]);
    problems.push_back(text + (offenders.size() > mostNamed ? ", …)" : ")"));
}

void addUnder(std::vector<std::string>& problems, const std::string& place,
              const std::vector<std::string>& found) {
    const std::string prefix = place + ": ";
    for (const std::string& problem : found)
        problems.push_back(prefix + problem);
}

std::vector<std::string> eachOnce(const std::vector<std::string>& problems) {
    std::vector<std::string> result;
    for (const std::string& problem : problems)
        if (std::find(result.begin(), result.end(), problem) == result.end()) result.push_back(problem);
    return result;
}

} // namespace esm
