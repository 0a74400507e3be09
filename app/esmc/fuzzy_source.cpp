#include "app/esmc/fuzzy_source.h"

#include "core/exchange/fuzzy_file.h"
#include "core/support/errors.h"

#include <filesystem>

namespace esm {

std::shared_ptr<const FuzzySystem> loadFuzzySystem(const std::string& name) {
    const std::filesystem::path file(name);
    std::error_code error;
    const bool isFile =
        file.has_extension() || file.has_parent_path() || std::filesystem::exists(file, error);
    if (!isFile) return std::make_shared<const FuzzySystem>(fuzzyPreset(name));
    if (file.extension() == ".fcl" || file.extension() == ".fll")
        throw FileError(file, "FCL and FLL files are not read yet; give the system as JSON");
    return std::make_shared<const FuzzySystem>(readFuzzyFile(file));
}

} // namespace esm
