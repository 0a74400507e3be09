#pragma once

#include <memory>
#include <string>

namespace esm {

/// What was measured last, and what it is compared with.
template<typename Measured> struct Compared {
    std::shared_ptr<const Measured> latest; ///< null before anything was measured
    std::shared_ptr<const Measured> former; ///< null without
    bool isKept = false;                    ///< what is compared with, by the user
    bool isOutdated = false;                ///< what was measured last is of another organ than there is now
    std::string failure{};                  ///< why the last try has no result; empty where it has one

    /// From now on the latest is compared with, whatever is measured.
    void keepLatest() {
        former = latest;
        isKept = former != nullptr;
    }
    void forgetFormer() {
        former.reset();
        isKept = false;
    }
};

} // namespace esm
