#pragma once

#include <string>

namespace esm::shaders {

/// The line that every shader begins with.
std::string version();

/// What the surface's shaders do besides. A processor that draws computes in every pixel all that a shader
/// could do, whatever is asked for: what is not needed must not stand in it.
struct SurfaceParts {
    bool photo = false;  ///< project a photo onto it
    bool finish = false; ///< let it shine as it is said to, or by an endoscope's light

    bool operator==(const SurfaceParts&) const = default;
};

/// GLSL 3.30, each complete with its version line.
std::string backgroundVertex();
std::string backgroundFragment();
std::string surfaceVertex(const SurfaceParts& parts);
std::string surfaceFragment(const SurfaceParts& parts);
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

/// The same: `vec3 shining(…)`, light on a surface that has a finish.
std::string finishSource();

} // namespace esm::shaders
