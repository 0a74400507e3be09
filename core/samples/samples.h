#pragma once

#include "core/project/project.h"

#include <string>
#include <vector>

namespace esm {

/// tube, uterus, ventricle, liver
const std::vector<std::string>& sampleNames();

/// The project's own sample organs, made by code:
/// - tube: a fallopian tube, 17 rings of 10, 170 nodes; 330 edges and the five diameters of each end ring,
///   340 springs; every third node tethered; 10 g; the published parameters [R 5.1, C.1]
/// - uterus: the uterus' motion model, 8 nodes, 7 springs, 6 fixed; 500 g; no surface [R 5.1]
/// - ventricle: a closed ventricle-like cavity; 1 kg; the published parameters [R C.2]
/// - liver: a liver-like organ of about 2500 nodes
/// @throws InvalidModel for another name, naming those there are
Project makeSample(const std::string& name);

/// Tissue-like pictures with an alpha channel, made by code: vessels, serosa, lesion.
const std::vector<std::string>& samplePhotoNames();
std::shared_ptr<const Photo> makeSamplePhoto(const std::string& name); ///< @throws InvalidModel

} // namespace esm
