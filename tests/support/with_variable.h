#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace esm::test {

/// A variable of the environment that has another value as long as this lives.
class WithVariable {
public:
    WithVariable(std::string name, const std::string& value) : m_name(std::move(name)) {
        if (const char* const before = std::getenv(m_name.c_str())) m_before = before;
        ::setenv(m_name.c_str(), value.c_str(), 1);
    }
    WithVariable(const WithVariable&) = delete;
    WithVariable& operator=(const WithVariable&) = delete;
    ~WithVariable() {
        m_before ? ::setenv(m_name.c_str(), m_before->c_str(), 1) : ::unsetenv(m_name.c_str());
    }

private:
    std::string m_name;
    std::optional<std::string> m_before;
};

} // namespace esm::test
