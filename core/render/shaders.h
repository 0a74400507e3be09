#pragma once

#include <string>

namespace esm::shaders {

/// The line that every shader begins with.
std::string version();

/// Whether the surface's shaders project a photo on it.
enum class Projecting { No, Yes };

/// GLSL 3.30, each complete with its version line.
std::string backgroundVertex();
std::string backgroundFragment();
std::string surfaceVertex(Projecting projecting = Projecting::No);
std::string surfaceFragment(Projecting projecting = Projecting::No);
std::string ballVertex();
std::string steelFragment();
std::string shellFragment();
std::string quadVertex();
std::string quadFragment();
std::string lineVertex();
std::string lineFragment();
std::string pointVertex();
std::string pointFragment();
std::string projectedDepthVertex();
std::string projectedDepthFragment();

/// Parts of the surface's shaders: `vec4 projectedFrom(int vertex)`, and `vec3 withPhoto(vec3 beneath)`.
std::string projectedPlace();
std::string projectedColour();

} // namespace esm::shaders
