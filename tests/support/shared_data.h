#pragma once

#include <gtest/gtest.h>

#include <filesystem>

/// A file of the test data that lies beside the project and is never part of it.
inline std::filesystem::path sharedData(const std::filesystem::path& name) {
    return std::filesystem::path(ESM_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

/// Ends a test that needs a file of the shared data where that is absent.
#define ESM_SKIP_WITHOUT(path)                                                                               \
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "test data not here: " << (path)
