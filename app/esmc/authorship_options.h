#pragma once

#include "core/exchange/provenance.h"

#include <CLI/CLI.hpp>

namespace esm {

/// --title, --author, --date and --licence.
void declareAuthorship(CLI::App& command, Authorship& authorship);

/// The first of these that was given; empty where none was.
std::string givenAuthorship(const Authorship& authorship);

/// @throws UsageError for what is no text, and for a date that no calendar has
void checkAuthorship(const Authorship& authorship);

} // namespace esm
