#pragma once

#include "app/editor/document/document.h"

#include <optional>

namespace esm {

// What is set of tissue by hand: of a region, or without one of the organ beneath all regions. Each is an
// edit that goes on until Document::finishGesture().

void setParameter(Document& document, std::optional<RegionId> region, Parameter parameter, double value);

/// By the region's words where its fuzzy system speaks of Young's modulus and reaches it, else by the spring
/// constant. @param youngsModulus Pa
void setYoungsModulus(Document& document, std::optional<RegionId> region, double youngsModulus);

/// The same, else by the viscosity; nothing where a region leaves its spring constant to what lies beneath.
/// @param relaxationTime s
void setRelaxationTime(Document& document, std::optional<RegionId> region, double relaxationTime);

/// Holds what the region's system says, or lets it say it again: an edit of its own.
void holdParameter(Document& document, std::optional<RegionId> region, Parameter parameter, double value);
void letParameterGo(Document& document, std::optional<RegionId> region, Parameter parameter);

} // namespace esm
