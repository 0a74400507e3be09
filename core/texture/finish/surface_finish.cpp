#include "core/texture/finish/surface_finish.h"

namespace esm {

std::vector<std::string> validate(const LayerFinish& finish) {
    std::vector<std::string> problems = fieldProblems(finish.surface);
    for (std::string& problem : fieldProblems(finish))
        problems.push_back(std::move(problem));
    return problems;
}

} // namespace esm
