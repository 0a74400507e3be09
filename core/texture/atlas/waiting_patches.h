#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace esm {

/// What waits to be placed, tallest first, in a chain from which any link can be taken.
class WaitingPatches {
public:
    explicit WaitingPatches(std::size_t count) : m_next(count + 1) {
        std::iota(m_next.begin(), m_next.end(), 0U);
    }

    bool isEmpty() const { return first() == m_next.size() - 1; }
    std::uint32_t first() const { return m_next[0]; }

    /// Calls `visit(shape, link)` for each of the first ones until it returns false.
    template<class Visit> void forFirst(std::size_t most, const Visit& visit) const {
        std::uint32_t link = 0;
        for (std::size_t i = 0; i < most && m_next[link] != m_next.size() - 1; ++i, link = m_next[link] + 1)
            if (!visit(m_next[link], link)) return;
    }
    void take(std::uint32_t link) { m_next[link] = m_next[m_next[link] + 1]; }

private:
    /// Behind link i, which is that of shape i − 1, comes this shape; link 0 is the chain's beginning.
    std::vector<std::uint32_t> m_next;
};

} // namespace esm
