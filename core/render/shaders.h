#pragma once

#include <string>

namespace esm::shaders {

/// The line that every shader begins with.
std::string version();

/// Whether the surface's shaders throw a photo on it.
enum class Throwing { No, Yes };

/// GLSL 3.30, each complete with its version line.
std::string backgroundVertex();
std::string backgroundFragment();
std::string surfaceVertex(Throwing throwing = Throwing::No);
std::string surfaceFragment(Throwing throwing = Throwing::No);
std::string ballVertex();
std::string steelFragment();
std::string shellFragment();
std::string quadVertex();
std::string quadFragment();
std::string lineVertex();
std::string lineFragment();
std::string pointVertex();
std::string pointFragment();
std::string thrownDepthVertex();
std::string thrownDepthFragment();

/// Parts of the surface's shaders: `vec4 thrownFrom(int vertex)`, and `vec3 withPhoto(vec3 beneath)`.
std::string thrownPlace();
std::string thrownColour();

} // namespace esm::shaders
