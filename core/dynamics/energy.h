#pragma once

namespace esm {

struct Energy {
    double kinetic = 0, elastic = 0; ///< J
    double total() const { return kinetic + elastic; }
};

} // namespace esm
