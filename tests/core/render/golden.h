#pragma once

#include "core/texture/image.h"

#include <gtest/gtest.h>

#include <string>

namespace esm {

/// Compares a picture with golden/<name>.png: the mean difference of a channel stays within 1.5 of 255, and
/// at most 0.5 % of the pixels differ by more than 24. A picture that fails is kept in the build folder
/// beside its difference. With ESM_UPDATE_GOLDEN=1 in the environment the picture becomes the new golden one
/// instead.
testing::AssertionResult matchesGolden(const Image& picture, const std::string& name);

} // namespace esm
