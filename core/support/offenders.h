#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace esm {

/// "3 springs joined to a node that does not exist (spring 4, 7, 9)": how many, and the first few of them by
/// number, so that a million offenders still make one line. Appends nothing when there is none.
/// @param subject one of them, e.g. "spring"
/// @param complaint what is wrong with it
void reportOffenders(std::vector<std::string>& problems, const std::string& subject,
                     const std::string& complaint, const std::vector<std::size_t>& offenders);

/// Adds what was found under the place it belongs to: "forces[2]: …".
void addUnder(std::vector<std::string>& problems, const std::string& place,
              const std::vector<std::string>& found);

/// Every problem where it stands first: what is missing may be looked for more than once.
std::vector<std::string> eachOnce(const std::vector<std::string>& problems);

/// The places in 0 … count − 1 where `isBad` holds.
template<class Predicate> std::vector<std::size_t> placesWhere(std::size_t count, Predicate isBad) {
    std::vector<std::size_t> places;
    for (std::size_t place = 0; place < count; ++place)
        if (isBad(place)) places.push_back(place);
    return places;
}

} // namespace esm
