#pragma once

#include <array>
#include <cstddef>

namespace esm {

/// A place of Gauss-Legendre quadrature over −1 to 1, and the same place mirrored.
struct GaussPair {
    double place, weight;
};

/// With n pairs polynomials up to degree 4n − 1 are integrated exactly.
struct GaussRule {
    const GaussPair* pairs;
    std::size_t size;

    const GaussPair* begin() const { return pairs; }
    const GaussPair* end() const { return pairs + size; }
};

namespace gauss {

inline constexpr std::array<GaussPair, 1> two{{{0.57735026918962573, 1}}};
inline constexpr std::array<GaussPair, 2> four{
    {{0.33998104358485626, 0.65214515486254609}, {0.86113631159405257, 0.34785484513745385}}};
inline constexpr std::array<GaussPair, 4> eight{{{0.18343464249564981, 0.36268378337836199},
                                                 {0.52553240991632899, 0.31370664587788727},
                                                 {0.79666647741362673, 0.22238103445337448},
                                                 {0.96028985649753629, 0.10122853629037626}}};
inline constexpr std::array<GaussPair, 8> sixteen{{{0.095012509837637441, 0.1894506104550685},
                                                   {0.28160355077925892, 0.18260341504492358},
                                                   {0.45801677765722737, 0.16915651939500254},
                                                   {0.61787624440264377, 0.14959598881657674},
                                                   {0.755404408355003, 0.12462897125553388},
                                                   {0.86563120238783176, 0.095158511682492786},
                                                   {0.9445750230732326, 0.062253523938647894},
                                                   {0.98940093499164994, 0.027152459411754096}}};

} // namespace gauss

/// The smallest rule that is exact for polynomials of the degree, or the largest there is: up to degree 31.
inline GaussRule gaussRuleFor(std::size_t degree) {
    if (degree <= 3) return {gauss::two.data(), gauss::two.size()};
    if (degree <= 7) return {gauss::four.data(), gauss::four.size()};
    if (degree <= 15) return {gauss::eight.data(), gauss::eight.size()};
    return {gauss::sixteen.data(), gauss::sixteen.size()};
}

inline constexpr std::size_t highestGaussDegree = 4 * gauss::sixteen.size() - 1;

} // namespace esm
