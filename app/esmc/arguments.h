#pragma once

#include "core/fuzzy/inference.h"
#include "core/geometry/ellipsoid.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace esm {

/// Finite numbers separated by spaces or commas. @throws UsageError naming `option` and what is no number
std::vector<double> parseNumbers(const std::string& text, const std::string& option);

/// NAME=V with a finite V. @throws UsageError
NamedValues parsePairs(const std::vector<std::string>& pairs, const std::string& option);

/// "cx cy cz rx ry rz [ax ay az degrees]". @throws UsageError
Ellipsoid parseEllipsoid(const std::string& text);

/// Words separated by commas, each one of `known`. @throws UsageError listing those there are
std::vector<std::string> parseWords(const std::string& text, const std::vector<std::string>& known,
                                    const std::string& option);

/// "a, b, c"
std::string joined(const std::vector<std::string>& words);

/// A check for an option that takes a finite number above zero.
CLI::Validator positiveNumber();

/// A check for an option whose values are known; the message of any other value lists them.
CLI::Validator oneOf(const std::vector<std::string>& values);

} // namespace esm
