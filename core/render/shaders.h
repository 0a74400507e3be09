#pragma once

#include <string>

namespace esm::shaders {

/// GLSL 3.30, each complete with its version line.
std::string backgroundVertex();
std::string backgroundFragment();
std::string surfaceVertex();
std::string surfaceFragment();
std::string ballVertex();
std::string steelFragment();
std::string shellFragment();
std::string quadVertex();
std::string quadFragment();
std::string lineVertex();
std::string lineFragment();
std::string pointVertex();
std::string pointFragment();

} // namespace esm::shaders
