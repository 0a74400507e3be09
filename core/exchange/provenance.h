#pragma once

#include "core/geometry/mesh_source.h"

#include <optional>

namespace esm {

/// What the user says of an organ that is handed over; nothing of it is made up. Empty: not said.
struct Authorship {
    std::string title, author;
    std::string date; ///< a year, a month or a day: 2026, 2026-05 or 2026-05-17
    std::string licence;

    bool operator==(const Authorship&) const = default;
};
template<>
inline constexpr auto fieldsOf<Authorship> = fieldTable(field("title", &Authorship::title).whenSet(),
                                                        field("author", &Authorship::author).whenSet(),
                                                        field("date", &Authorship::date).whenSet(),
                                                        field("licence", &Authorship::licence).whenSet());

inline constexpr std::size_t longestStatement = 1000; ///< bytes, of each

/// Every problem: what is no text or too long, and dates that no calendar has.
std::vector<std::string> validate(const Authorship& authorship);

/// Where a package comes from.
struct Provenance {
    std::string program;                ///< that wrote it, with its version
    std::optional<MeshSource> source{}; ///< of its surface; none where it was not imported
    Authorship authorship{};

    bool operator==(const Provenance&) const = default;
};
template<>
inline constexpr auto fieldsOf<Provenance> = fieldTable(field("program", &Provenance::program),
                                                        field("source", &Provenance::source).whenSet(),
                                                        fieldsOfMember(&Provenance::authorship));

std::vector<std::string> validate(const Provenance& provenance);

} // namespace esm
