#pragma once

#include "tests/growth/child_process.h"
#include "tests/support/temporary_folder.h"

#include <functional>
#include <string>
#include <vector>

namespace growth {

/// One surface, and what the operations make of it.
struct Files {
    std::string mesh, scene, project, uneven, packed, package, trajectory;

    explicit Files(const TemporaryFolder& folder);
};

/// What a user waits for.
struct Operation {
    std::string name;
    std::function<Usage(const Files&)> measure;
    bool isJudged; ///< what factorises grows faster by nature
};

/// In an order in which each finds the files that it needs.
std::vector<Operation> operations();

} // namespace growth
