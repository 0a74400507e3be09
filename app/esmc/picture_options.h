#pragma once

#include "core/exchange/picture_encoding.h"

#include <CLI/CLI.hpp>

namespace esm {

/// Whether pictures of the texture are PNG or JPEG, as --pictures and --quality say it.
struct PictureOptions {
    PictureEncoding encoding;
    bool isFormatGiven = false, isQualityGiven = false;
};

void declarePictures(CLI::App& command, PictureOptions& options);

/// @throws UsageError for a quality of what is exact
void checkPictures(const PictureOptions& options);

} // namespace esm
