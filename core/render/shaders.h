#pragma once

#include <string>

namespace esm::shaders {

/// The line that every shader begins with.
std::string version();

/// Whether the surface's shaders project a photo onto it.
enum class WithPhoto { No, Yes };

/// GLSL 3.30, each complete with its version line.
std::string backgroundVertex();
std::string backgroundFragment();
std::string surfaceVertex(WithPhoto photo = WithPhoto::No);
std::string surfaceFragment(WithPhoto photo = WithPhoto::No);
std::string ballVertex();
std::string steelFragment();
std::string shellFragment();
std::string quadVertex();
std::string quadFragment();
std::string lineVertex();
std::string lineFragment();
std::string pointVertex();
std::string pointFragment();
std::string photoDepthVertex();
std::string photoDepthFragment();

/// Parts of the surface's shaders: `vec4 photoPlaceOf(int vertex)`, and `vec3 withPhoto(vec3 beneath)`.
std::string photoPlaceSource();
std::string photoColourSource();

/// The same: `Finish finishAt(…)`, and light on a surface that has one.
std::string finishSource();

} // namespace esm::shaders
