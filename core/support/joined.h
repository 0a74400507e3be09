#pragma once

#include <string>
#include <vector>

namespace esm {

/// "a, b, c"
std::string joined(const std::vector<std::string>& words, const std::string& separator = ", ");

/// The same of the names of things that have one.
template<class List> std::string joinedNames(const List& things) {
    std::vector<std::string> names;
    names.reserve(things.size());
    for (const auto& thing : things)
        names.emplace_back(thing.name);
    return joined(names);
}

} // namespace esm
