#pragma once

#include "core/project/project.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace esm::test {

/// The program that stands in for runSofa: in it nodes fall freely.
inline std::filesystem::path standInSofa() {
    return std::filesystem::path(ESM_SOURCE_DIR) / "tests/core/exchange/simulators/sofa/stand_in_sofa.py";
}

/// A variable of the environment that has a value as long as it lives.
class WithVariable {
public:
    WithVariable(std::string name, const std::string& value) : m_name(std::move(name)) {
        ::setenv(m_name.c_str(), value.c_str(), 1);
    }
    WithVariable(const WithVariable&) = delete;
    WithVariable& operator=(const WithVariable&) = delete;
    ~WithVariable() { ::unsetenv(m_name.c_str()); }

private:
    std::string m_name;
};

/// Nothing holds the organ, and it falls for a tenth of a second: half of g·t² is 49.05 mm.
inline Project falling(Project project) {
    project.scene = {};
    project.scene.duration = 0.1;
    project.scene.gravity = {0, -9.81, 0};
    return project;
}
inline constexpr double fallenBy = 0.04905; ///< m

} // namespace esm::test
