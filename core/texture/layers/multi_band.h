#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/intrinsics.h"
#include "core/texture/photo/photo_sampler.h"

namespace esm {

/// The size in which a photo is compared with what lies beneath: its own, halved until no side is longer than
/// 1024 pixels. What is finer needs no wide border.
PhotoSize comparedSize(PhotoSize photo);

/// A photo blended in bands into what lies beneath it (Burt and Adelson 1983): colours pass gradually, and
/// details do not mix. The difference between both is taken apart in a Laplacian pyramid and added to the
/// photo. At the border of what the photo shows all of it is added; inside, each band fades over four times
/// its own wavelength. The coarsest fades over a quarter of the photo's shorter side, or over `border` where
/// that is wider. Deterministic with any number of threads.
/// @param sampler of the photo
/// @param beneath the same plane in `comparedSize()` pixels, alpha 0 where nothing is to be compared with
/// @param mask the same plane, black where the photo is erased, so that its border is there; empty where
/// nothing is
/// @param border photo pixels
/// @throws Cancelled
Image blendedInBands(const Image& photo, const PhotoSampler& sampler, const Image& beneath, const Image& mask,
                     double border, const Progress& progress = {});

/// A photo that is blended in bands fades in over so many of its pixels: there the bands have made its
/// colours agree with what lies beneath.
constexpr double bandedBorder = 4;

/// What blending in bands would add to a photo, for a picture of it in motion: in the size of `beneath`,
/// halved and from 128 on, so that a byte holds what is taken away as well. Takes what blendedInBands()
/// takes, but `beneath` in any size.
Image bandsAddedTo(const PhotoSampler& sampler, const Image& beneath, const Image& mask, double border);

} // namespace esm
