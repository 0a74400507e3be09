#include "app/esmc/picture_options.h"

#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"

namespace esm {

void declarePictures(CLI::App& command, PictureOptions& options) {
    addChoice(
        command, "--pictures", options.encoding.format,
        {{wordOf(PictureFormat::Png), PictureFormat::Png},
         {wordOf(PictureFormat::Jpeg), PictureFormat::Jpeg}},
        "How the pages of the texture are stored (png): every texel as it is, or a fraction of the size")
        ->each([&options](const std::string&) { options.isFormatGiven = true; });
    command
        .add_option("--quality", options.encoding.quality,
                    "Of JPEG, 1 to 100 (" + std::to_string(usualJpegQuality) + ")")
        ->transform(wholeNumber(leastJpegQuality, mostJpegQuality))
        ->each([&options](const std::string&) { options.isQualityGiven = true; });
}

void checkPictures(const PictureOptions& options) {
    if (options.isQualityGiven && options.encoding.format == PictureFormat::Png)
        throw UsageError("--quality: a PNG has none; it goes with --pictures jpeg");
}

} // namespace esm
