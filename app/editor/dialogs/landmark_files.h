#pragma once

#include "core/texture/projection/landmark_pair.h"

#include <QWidget>

#include <functional>
#include <vector>

namespace esm {

/// Asks for a pairs file and passes on what it holds; says what is wrong with one that cannot be read.
void openLandmarks(QWidget* window, const std::function<void(std::vector<LandmarkPair>)>& use);

/// Asks where to write the pairs file, which `esmc texture fit` reads as well.
void saveLandmarks(QWidget* window, const QString& suggestedName, const std::vector<LandmarkPair>& pairs);

} // namespace esm
