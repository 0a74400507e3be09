#pragma once

#include "core/c/esm_package.h"

#include <exception>
#include <string>

namespace esm {

/// Writes it where the caller asked for it; what is too long ends with an ellipsis, at a character's end.
void report(EsmError* error, const std::string& text);
/// The same of an exception, in the user's words.
void report(EsmError* error, const std::exception& reason);

/// What `work` gives, or `failed` with the reason in `error`: no exception leaves the library.
template<class Result, class Work> Result guarded(EsmError* error, Result failed, const Work& work) noexcept {
    report(error, "");
    try {
        return work();
    } catch (const std::exception& reason) {
        report(error, reason);
    } catch (...) {
        report(error, "failed for a reason that is not known");
    }
    return failed;
}

} // namespace esm
