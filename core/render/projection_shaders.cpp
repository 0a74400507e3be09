#include "core/render/shaders.h"
#include "core/texture/layers/blending.h"

#include <string>

namespace esm::shaders {

std::string photoPlaceSource() {
    return R"(
uniform samplerBuffer restVertices; // place, normal, place …
uniform mat4 intoPhoto;
vec4 photoPlaceOf(int vertex) { return intoPhoto * vec4(texelFetch(restVertices, 2 * vertex).xyz, 1.0); }
)";
}

namespace {

/// As TriangleProjection has them.
constexpr const char* photoWeights = R"(
in vec4 photoPlace; // the place in the photo (x w, y w, w), pixels, and the depth before the projector
in vec3 rest, restNormal; // on the organ at rest
uniform sampler2D photo, seen, fade, bands;
uniform vec2 photoPixels, depths, fadeNodes;
uniform vec4 light;
uniform int seenSide; // 0: the outside, 1: the inside, 2: both
uniform bool isPerspective, occlusion, falloff, hasBands;
uniform int blending; // a Blending
uniform float blendPixels, opacity, tolerance, fadeSpacing;

// Of what the depth map holds, before the projector.
float depthOf(float held) {
    float near = depths.x, far = depths.y;
    return isPerspective ? near * far / (far - held * (far - near)) : mix(near, far, held);
}

float borderWeight(vec2 pixel) {
    vec2 nearest = min(pixel, photoPixels - pixel);
    float inside = min(nearest.x, nearest.y);
    return inside < 0.0 ? 0.0 : blendPixels > 0.0 ? min(1.0, inside / blendPixels) : 1.0;
}

// All up to 60 degrees, nothing from 85 on.
float angleWeight(float cosine) {
    return 1.0 - smoothstep(radians(60.0), radians(85.0), acos(min(abs(cosine), 1.0)));
}

float cosineSeen(float cosine) {
    return seenSide == 2 ? abs(cosine) : max(0.0, seenSide == 1 ? -cosine : cosine);
}

// By how far what the map shows lies before the place, as for a ray; a map is less exact near the surface.
float seenShare(vec2 place) {
    float before = photoPlace.w - depthOf(texture(seen, place).r);
    return 1.0 - smoothstep(5.0 * tolerance, 20.0 * tolerance, before);
}

float fadeWeight(vec2 pixel) {
    if (fadeNodes.x == 0.0) return 1.0;
    return 1.0 - texture(fade, (pixel / fadeSpacing + 0.5) / fadeNodes).r;
}

float lightWeight(vec2 pixel, vec3 outward) {
    if (!falloff && !occlusion) return 1.0;
    vec3 way = light.w > 0.0 ? normalize(light.xyz - rest) : light.xyz;
    if (blendPixels == 0.0 && cosineSeen(dot(outward, way)) == 0.0) return 0.0;
    float cosine = cosineSeen(dot(normalize(restNormal), way));
    float weight = falloff ? angleWeight(cosine) : blendPixels > 0.0 ? smoothstep(0.0, 0.17365, cosine) : 1.0;
    if (!occlusion || weight <= 0.0) return weight;
    return weight * seenShare(pixel / photoPixels);
}

)";

/// As blended() in core/texture/layers/blending.h has them.
std::string blendingSource() {
    const auto is = [](Blending blending) {
        return "blending == " + std::to_string(static_cast<int>(blending));
    };
    return R"(
float luminosity(vec3 colour) { return dot(colour, vec3(0.3, 0.59, 0.11)); }

vec3 clipped(vec3 colour) {
    float grey = luminosity(colour), below = grey - min(colour.r, min(colour.g, colour.b));
    float above = max(colour.r, max(colour.g, colour.b)) - grey;
    if (below > grey && below > 0.0) colour = grey + (colour - grey) * (grey / below);
    if (above > 1.0 - grey && above > 0.0) colour = grey + (colour - grey) * ((1.0 - grey) / above);
    return clamp(colour, 0.0, 1.0);
}

vec3 overlaid(vec3 beneath, vec3 own) {
    vec3 product = 2.0 * beneath * own;
    return mix(2.0 * (beneath + own) - product - 1.0, product, lessThanEqual(beneath, vec3(0.5)));
}

vec3 blended(vec3 beneath, vec3 own) {
    if ()" +
           is(Blending::Multiply) + R"() return beneath * own;
    if ()" +
           is(Blending::Screen) + R"() return beneath + own - beneath * own;
    if ()" +
           is(Blending::Overlay) + R"() return overlaid(beneath, own);
    if ()" +
           is(Blending::Colour) + R"() return clipped(own + luminosity(beneath) - luminosity(own));
    return own;
}
)";
}

} // namespace

std::string photoColourSource() {
    return photoWeights + blendingSource() + std::string(R"(
vec3 withPhoto(vec3 beneath, float left) {
    vec3 across = cross(dFdx(rest), dFdy(rest));
    vec3 outward = normalize(gl_FrontFacing ? across : -across);
    vec2 pixel = photoPlace.xy / max(photoPlace.z, 1e-12);
    vec2 place = pixel / photoPixels;
    vec4 photoColour = texture(photo, place);
    if (photoPlace.z <= 0.0 || photoPlace.w < -tolerance) return beneath;
    float weight = left * opacity * photoColour.a * borderWeight(pixel) * fadeWeight(pixel);
    if (weight <= 0.0) return beneath;
    weight *= lightWeight(pixel, outward);
    vec3 colour = photoColour.rgb / photoColour.a; // it is stored multiplied by alpha
    if (hasBands) colour = clamp(colour + (texture(bands, place).rgb * 255.0 - 128.0) / 127.5, 0.0, 1.0);
    return mix(beneath, blended(beneath, colour), weight);
}
)");
}

std::string photoDepthVertex() {
    return version() + photoPlaceSource() + R"(
uniform vec2 photoPixels, depths;
uniform bool isPerspective;
void main() {
    vec4 seen = photoPlaceOf(gl_VertexID);
    float near = depths.x, far = depths.y, depth = seen.w;
    vec2 place = 2.0 * seen.xy / photoPixels - seen.z;
    float z = isPerspective ? ((far + near) * depth - 2.0 * far * near) / (far - near)
                            : 2.0 * (depth - near) / (far - near) - 1.0;
    gl_Position = vec4(place, z, seen.z);
}
)";
}

std::string photoDepthFragment() {
    return version() + "void main() {}\n";
}

} // namespace esm::shaders
