#include "core/render/shaders.h"

namespace esm::shaders {
namespace {

// What a place's finish is, and which way its relief tilts the surface.
const char* const finishReading = R"(
uniform bool endoscope, finishPainted;
uniform vec2 plainFinish; // wetness, roughness
uniform float exposedDistance; // m, at which the endoscope's light is as bright as the room's
uniform float filmRoughness;
uniform sampler2D finishPage;

struct Finish { float wetness; float roughness; vec3 normal; };

// The normal map's tangent space, from how place and page change across the picture: it follows tissue that moves.
vec3 tilted(vec3 n, vec2 tilt, vec3 p, vec2 onPage) {
    vec3 px = dFdx(p), py = dFdy(p);
    vec2 qx = dFdx(onPage), qy = dFdy(onPage);
    float turn = qx.x * qy.y - qy.x * qx.y;
    if (dot(tilt, tilt) < 1e-4 || turn == 0.0) return n;
    vec3 right = (px * qy.y - py * qx.y) / turn, down = (py * qx.x - px * qy.x) / turn;
    vec3 tangent = right - n * dot(n, right);
    float size = length(tangent);
    if (!(size > 0.0)) return n;
    tangent /= size;
    vec3 across = cross(n, tangent);
    vec3 bitangent = dot(across, down) < 0.0 ? across : -across;
    return normalize(tilt.x * tangent + tilt.y * bitangent + sqrt(max(0.0, 1.0 - dot(tilt, tilt))) * n);
}

Finish finishAt(vec2 place, vec3 n, vec3 p, vec2 onPage) {
    vec4 read = texture(finishPage, place);
    if (!finishPainted) return Finish(plainFinish.x, plainFinish.y, n);
    return Finish(read.r, read.g, tilted(n, (255.0 * read.ba - 128.0) / 127.0, p, onPage));
}
)";

// Mirroring a room: an environment of a sky and a few broad lamps in closed form.
const char* const roomLight = R"(
// By Schlick 1994; rough surface mirrors less where it is seen from the side.
float fresnel(float facing, float roughness) {
    return 0.04 + max(0.96 - roughness, 0.0) * squared(squared(1.0 - facing)) * (1.0 - facing);
}

// A lamp of some width, mirrored by a surface of some roughness: the wider the dimmer.
float lamp(vec3 direction, vec3 at, float width, float roughness) {
    float spread = width + squared(squared(roughness));
    return width / spread * exp((dot(direction, normalize(at)) - 1.0) / spread);
}
vec3 mirroredRoom(vec3 direction, float roughness) {
    vec3 sky = mix(vec3(0.05, 0.042, 0.045), vec3(0.22, 0.225, 0.24), smoothstep(-0.7, 0.9, direction.y));
    return sky + 17.0 * lamp(direction, vec3(-0.42, 0.55, 0.72), 0.004, roughness) * vec3(1.0, 0.98, 0.95)
         + 6.0 * lamp(direction, vec3(0.75, -0.15, 0.45), 0.02, roughness) * vec3(0.75, 0.85, 1.0)
         + 5.0 * lamp(direction, vec3(0.35, 0.85, -0.1), 0.03, roughness);
}

vec3 litInRoom(vec3 albedo, Finish finish, vec3 n, vec3 toEye) {
    float film = finish.wetness * fresnel(max(dot(n, toEye), 0.0), filmRoughness);
    float facing = max(dot(finish.normal, toEye), 0.0);
    vec3 tissue = lit(albedo, finish.normal, toEye, Sheen(0.0, 0.0, 0.0)) +
                  fresnel(facing, finish.roughness) * mirroredRoom(reflect(-toEye, finish.normal), finish.roughness);
    return mix(tissue, mirroredRoom(reflect(-toEye, n), filmRoughness), film);
}
)";

// Mirroring the lamp at the eye.
const char* const endoscopeLight = R"(
// What a lamp at the eye's own place sends back from a surface of a roughness, for an irradiance of 1.
float mirroredLamp(float facing, float roughness) {
    float alpha = max(squared(roughness), 1e-3);
    float d = alpha / (facing * facing * (alpha * alpha - 1.0) + 1.0);
    float k = 0.5 * alpha, shadowed = facing * (1.0 - k) + k;
    return facing * d * d / (4.0 * shadowed * shadowed) * 0.04;
}

vec3 litByEndoscope(vec3 albedo, Finish finish, vec3 n, vec3 toEye, vec3 p) {
    float near = isOrthographic() ? 1.0 : squared(exposedDistance) / max(dot(p, p), 1e-12);
    float beam = isOrthographic() ? 1.0 : squared(toEye.z); // darker towards the rim, as a lamp's beam is
    float facing = max(dot(finish.normal, toEye), 0.0);
    // Walls lit by the lamp light each other, in their own colour.
    vec3 tissue = albedo * (facing + 0.06 * albedo) + mirroredLamp(facing, finish.roughness);
    float smoothFacing = max(dot(n, toEye), 0.0), film = finish.wetness;
    vec3 wet = tissue * (1.0 - film * fresnel(smoothFacing, filmRoughness)) + film * mirroredLamp(smoothFacing, filmRoughness);
    return near * beam * wet;
}

// In the light of the scene. What is tinted means something and shines little.
vec3 shining(vec3 albedo, vec4 tint, vec3 n, vec3 p, vec2 place, vec2 onPage) {
    Finish finish = finishAt(place, n, p, onPage);
    if (!gl_FrontFacing) finish.normal = n;
    finish.wetness *= 1.0 - tint.a;
    finish.roughness = mix(finish.roughness, 0.7, tint.a);
    vec3 toEye = towardsEye(p);
    return endoscope ? litByEndoscope(albedo, finish, n, toEye, p) : litInRoom(albedo, finish, n, toEye);
}
)";

} // namespace

/// The materials of glTF 2.0, so that the organ looks here as where its package goes: a rough dielectric,
/// over it a clear coat where it is wet, GGX by Walter et al. 2007 with the fit of visibility by Karis 2013.
/// In a room, what is mirrored is an environment of a few broad lamps in closed form, widened by the
/// roughness, as a processor draws these pictures: no maps are read. In a body the lamp is at the eye, so
/// half-vector and line of sight are one.
std::string finishSource() {
    return std::string(finishReading) + roomLight + endoscopeLight;
}

} // namespace esm::shaders
