#pragma once

namespace esm {

/// By how little all nodes have to be tied to where they are for a step of Newton's method to go downhill
/// (Levenberg 1944). Nodes that a step tied need as little, or less, in the next one.
class LeastTie {
public:
    /// What an attempt gives with the least tie (N/m, 0 first) that it gives something with; nothing where
    /// ties as strong as the stiffest node (N/m) do not help.
    template<typename Attempt> auto find(double stiffest, const Attempt& attempt) -> decltype(attempt(0.0)) {
        m_tie /= growth;
        if (m_tie < leastPart * stiffest) {
            if (auto result = attempt(0.0)) return result;
            m_tie = leastPart * stiffest;
        }
        for (int i = 0; i < mostAttempts; ++i, m_tie *= growth)
            if (auto result = attempt(m_tie)) return result;
        return {};
    }

private:
    static constexpr double leastPart = 1e-6; ///< of what resists the stiffest node
    static constexpr double growth = 16;
    static constexpr int mostAttempts = 10;

    double m_tie = 0; ///< N/m, by which all nodes were last tied
};

} // namespace esm
