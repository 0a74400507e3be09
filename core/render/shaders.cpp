#include "core/render/shaders.h"

namespace esm::shaders {
namespace {

// Where the viewer is, in the camera's space.
const char* const viewing = R"(
uniform mat4 projection;
bool isOrthographic() { return projection[3][3] > 0.5; }
vec3 towardsEye(vec3 position) { return isOrthographic() ? vec3(0.0, 0.0, 1.0) : normalize(-position); }
// Towards the eye along the line of sight: over the surface, at the same place of the picture.
vec3 lifted(vec3 p, float lift) {
    return isOrthographic() ? p + vec3(0.0, 0.0, lift) : p * (1.0 - min(lift / length(p), 0.5));
}
)";

// All in the camera's space and in linear light: x right, y up, z towards the viewer.
const char* const lighting = R"(
// Squares stand in for the display's curve of 2.2 and for powers of a highlight: a processor that draws without a
// graphics card pays for every exponential in every pixel.
vec3 toLinear(vec3 c) { return c * c; }
vec3 toDisplay(vec3 c) { return sqrt(clamp(c, 0.0, 1.0)); }
float squared(float x) { return x * x; }

struct Sheen { float broad; float wet; float rim; };

// A soft sky, a key light over the viewer's left shoulder, a weak cool one from the right below, a moist sheen.
vec3 lit(vec3 albedo, vec3 n, vec3 toEye, Sheen sheen) {
    const vec3 key = normalize(vec3(-0.42, 0.55, 0.72));
    const vec3 fill = normalize(vec3(0.75, -0.35, 0.45));
    float sky = 0.5 + 0.5 * n.y;
    float facing = max(dot(n, toEye), 0.0);
    // Light scattered in tissue reaches a little beyond the shadow's edge, red farthest.
    vec3 wrap = vec3(0.34, 0.20, 0.18);
    vec3 diffuse = clamp((dot(n, key) + wrap) / (1.0 + wrap), 0.0, 1.0);
    vec3 ambient = mix(vec3(0.055, 0.045, 0.05), vec3(0.17, 0.175, 0.19), sky);
    vec3 colour = albedo * (ambient + 0.74 * diffuse * diffuse * (3.0 - 2.0 * diffuse) * vec3(1.0, 0.98, 0.95)
                            + 0.10 * max(dot(n, fill), 0.0) * vec3(0.75, 0.85, 1.0));
    float highlight = max(dot(n, normalize(key + toEye)), 0.0);
    float eighth = squared(squared(squared(highlight)));
    float broad = squared(eighth), wet = squared(squared(squared(broad)));
    float rim = squared(squared(1.0 - facing));
    colour += sheen.broad * broad * mix(vec3(1.0), albedo * 2.0, 0.45) + sheen.wet * wet;
    colour += sheen.rim * rim * (0.35 + 0.65 * sky) * mix(vec3(0.8, 0.9, 1.0), albedo * 3.0, 0.5);
    return colour;
}

// Tissue of which nobody said how it shines. Colours that mean something are not reddened, shine little, and are read
// in the shade as well.
vec3 plainlyLit(vec3 albedo, vec4 tint, vec3 n, vec3 toEye) {
    vec3 inside = mix(vec3(0.62, 0.50, 0.50), vec3(0.62), tint.a);
    vec3 linear = albedo * (gl_FrontFacing ? vec3(1.0) : inside);
    Sheen sheen = gl_FrontFacing ? Sheen(0.085, 0.20, 0.085) : Sheen(0.03, 0.05, 0.02);
    float less = 1.0 - 0.8 * tint.a;
    sheen = Sheen(sheen.broad * less, sheen.wet * less, sheen.rim * less);
    return lit(linear, n, toEye, sheen) + 0.35 * tint.a * linear;
}
)";

} // namespace

std::string version() {
    return "#version 330 core\n";
}

std::string backgroundVertex() {
    return version() + R"(
out vec2 place;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    place = corner * 0.5 + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";
}

std::string backgroundFragment() {
    return version() + R"(
in vec2 place;
uniform vec3 top, bottom;
uniform vec2 pixels;
out vec4 colour;
void main() {
    float distance = length((place - vec2(0.5, 0.80)) * vec2(0.85, 1.0));
    vec3 shade = mix(top, bottom, smoothstep(0.0, 0.85, distance));
    // Half a step of noise hides the bands that 8 bits leave in so flat a gradient.
    vec2 pixel = floor(place * pixels);
    float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
    colour = vec4(shade + noise / 255.0, 1.0);
}
)";
}

std::string surfaceVertex(const SurfaceParts& parts) {
    const std::string ofPhoto = !parts.photo ? "#define NOTE_PHOTO_PLACE(vertex)\n" : photoPlaceSource() + R"(
out vec4 photoPlace;
out vec3 rest, restNormal;
#define NOTE_PHOTO_PLACE(vertex) \
    photoPlace = photoPlaceOf(vertex); \
    rest = texelFetch(restVertices, 2 * vertex).xyz; \
    restNormal = texelFetch(restVertices, 2 * vertex + 1).xyz
)";
    return version() + ofPhoto + R"(
layout(location = 0) in uint cornerVertex;
layout(location = 1) in vec2 firstPlace;
layout(location = 2) in vec2 secondPlace;
layout(location = 3) in vec2 thirdPlace;
uniform samplerBuffer vertices; // position and colour, normal and how much of the colour, position and …
uniform bool perCorner, tinted;
uniform mat4 view, projection;
uniform vec4 cut;
out vec3 position, normal;
out vec4 tint; // multiplied by how much of it
out vec3 shares;
flat out vec2 first, second, third;
flat out vec3 perTexel; // how much of its corner's share a texel's way from the opposite side takes
uniform float pageSize; // texels
void main() {
    int vertex = perCorner ? int(cornerVertex) : gl_VertexID;
    vec4 place = texelFetch(vertices, 2 * vertex), facing = texelFetch(vertices, 2 * vertex + 1);
    vec4 seen = view * vec4(place.xyz, 1.0);
    position = seen.xyz;
    normal = mat3(view) * facing.xyz;
    vec3 colour = tinted ? mod(floor(place.w / vec3(65536.0, 256.0, 1.0)), 256.0) / 255.0 : vec3(0.0);
    tint = facing.w * vec4(colour, 1.0);
    gl_ClipDistance[0] = dot(cut, seen);
    int corner = gl_VertexID % 3;
    shares = vec3(corner == 0, corner == 1, corner == 2);
    first = firstPlace;
    second = secondPlace;
    third = thirdPlace;
    NOTE_PHOTO_PLACE(vertex);
    vec2 along = secondPlace - firstPlace, beside = thirdPlace - firstPlace;
    float area = abs(along.x * beside.y - along.y * beside.x) * pageSize;
    perTexel = vec3(distance(second, third), distance(third, first), distance(first, second)) / max(area, 1e-12);
    gl_Position = projection * seen;
}
)";
}

std::string surfaceFragment(const SurfaceParts& parts) {
    const std::string ofPhoto =
        parts.photo ? photoColourSource() : "vec3 withPhoto(vec3 beneath, float left) { return beneath; }\n";
    const std::string ofFinish =
        parts.finish
            ? finishSource() + "#define SHADED shining(linear, tint, n, position, place(), placeOf(shares))\n"
            : "#define SHADED plainlyLit(linear, tint, n, towardsEye(position))\n";
    return version() + viewing + lighting + ofFinish + ofPhoto + R"(
in vec3 position, normal;
in vec4 tint;
in vec3 shares;
flat in vec2 first, second, third; // where the triangle's corners lie in the page
flat in vec3 perTexel;
uniform float pageSize, halfGap; // texels
uniform int levels;
uniform bool painted, masked, unlit, plainInside;
uniform vec3 baseColour;
uniform sampler2D page;
out vec4 colour;

vec2 placeOf(vec3 corners) { return corners.x * first + corners.y * second + corners.z * third; }

// A pixel on a triangle's edge may have its middle outside the triangle. What lies beside the patch in the page
// does not lie beside it on the surface, so the page is never read there; and where smaller copies of it are read,
// only as near to the patch's edge as their wider texels still show the patch.
vec2 place() {
    vec3 inside = max(shares, 0.0);
    inside /= inside.x + inside.y + inside.z;
    vec2 texel = placeOf(inside) * pageSize;
    vec2 right = dFdx(texel), down = dFdy(texel);
    float halvings = ceil(clamp(0.5 * log2(max(dot(right, right), dot(down, down))), 0.0, float(levels)));
    float inset = halvings > 0.0 ? max(0.0, 1.41421 * exp2(halvings) - halfGap) : 0.0;
    vec3 least = inset * perTexel;
    float sum = least.x + least.y + least.z;
    return placeOf(least / max(sum, 1.0) + max(0.0, 1.0 - sum) * inside);
}

void main() {
    vec4 paint = painted ? texture(page, place()) : vec4(0.0);
    // Beneath a photo in motion alpha is what strokes have left of it.
    vec3 own = withPhoto(mix(baseColour, paint.rgb, masked ? 1.0 : paint.a), masked ? paint.a : 1.0);
    if (plainInside && !gl_FrontFacing) own = baseColour;
    vec3 albedo = own * (1.0 - tint.a) + tint.rgb;
    if (unlit) {
        colour = vec4(albedo, 1.0);
        return;
    }
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 n = normalize(normal) * side;
    vec3 linear = toLinear(albedo);
    colour = vec4(toDisplay(SHADED), 1.0);
}
)";
}

std::string ballVertex() {
    return version() + R"(
layout(location = 0) in vec3 unit;
layout(location = 1) in float side; // 1 and -1: the halves of the ball
uniform mat4 model, view, projection;
uniform vec3 apart; // from the middle to the half on the side 1
out vec3 position, normal;
invariant gl_Position; // the shell of what is drawn solid already compares depths with it
void main() {
    vec4 seen = view * (model * vec4(unit, 1.0) + vec4(side * apart, 0.0));
    position = seen.xyz;
    normal = mat3(view) * (transpose(inverse(mat3(model))) * unit);
    gl_Position = projection * seen;
}
)";
}

std::string steelFragment() {
    return version() + viewing + lighting + R"(
in vec3 position, normal;
uniform vec3 baseColour;
out vec4 colour;
void main() {
    vec3 n = normalize(normal);
    vec3 toEye = towardsEye(position);
    // A bright band where the metal mirrors the horizon of the room.
    float mirrored = reflect(-toEye, n).y;
    float band = smoothstep(-0.15, 0.25, mirrored) * (1.0 - smoothstep(0.35, 0.95, mirrored));
    vec3 steel = lit(toLinear(baseColour), n, toEye, Sheen(0.30, 0.9, 0.25)) + 0.12 * band;
    colour = vec4(toDisplay(steel), 1.0);
}
)";
}

std::string shellFragment() {
    return version() + viewing + R"(
in vec3 position, normal;
uniform vec3 baseColour;
uniform float opacity;
out vec4 colour;
void main() {
    float facing = abs(dot(normalize(normal), towardsEye(position)));
    colour = vec4(baseColour, opacity * (0.45 + 1.6 * pow(1.0 - facing, 2.5)));
}
)";
}

std::string quadVertex() {
    return version() + R"(
uniform vec3 corners[4]; // bottom left, bottom right, top left, top right
uniform mat4 view, projection;
out vec2 place;
void main() {
    place = vec2(gl_VertexID & 1, 1 - (gl_VertexID >> 1));
    gl_Position = projection * view * vec4(corners[gl_VertexID], 1.0);
}
)";
}

std::string quadFragment() {
    return version() + R"(
in vec2 place;
uniform bool textured;
uniform sampler2D page;
uniform vec4 tint;
out vec4 colour;
void main() {
    colour = textured ? texture(page, place) * vec4(1.0, 1.0, 1.0, tint.a) : tint;
}
)";
}

std::string lineVertex() {
    return version() + viewing + R"(
layout(location = 0) in uvec2 ends;
layout(location = 1) in vec4 paint;
layout(location = 2) in float width;
uniform samplerBuffer points;
uniform mat4 view;
uniform vec2 pixels;
uniform vec4 cut;
uniform float pixelRatio, opacity, lift;
uniform bool thinWhenShort;
flat out vec4 lineColour;
flat out float halfWidth;
noperspective out float across;

void main() {
    vec3 a = (view * vec4(texelFetch(points, int(ends.x)).xyz, 1.0)).xyz;
    vec3 b = (view * vec4(texelFetch(points, int(ends.y)).xyz, 1.0)).xyz;
    // Without perspective the planes hold all.
    float near = isOrthographic() ? -1e30 : projection[3][2] / (projection[2][2] - 1.0);
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside: nothing to see
    gl_ClipDistance[0] = 1.0;
    lineColour = vec4(0.0);
    halfWidth = across = 0.0;
    if (a.z > -near && b.z > -near) return;
    if (a.z > -near) a = mix(b, a, (b.z + near) / (b.z - a.z));
    if (b.z > -near) b = mix(a, b, (a.z + near) / (a.z - b.z));
    vec4 first = projection * vec4(lifted(a, lift), 1.0), second = projection * vec4(lifted(b, lift), 1.0);
    vec2 along = (second.xy / second.w - first.xy / first.w) * 0.5 * pixels;
    float shown = length(along);
    float strength = thinWhenShort ? smoothstep(1.5, 12.0, shown / pixelRatio) : 1.0;
    if (strength < 0.02) return;
    vec2 direction = shown > 1e-6 ? along / shown : vec2(1.0, 0.0);
    float end = float(gl_VertexID >> 1), side = float(gl_VertexID & 1) * 2.0 - 1.0;
    halfWidth = 0.5 * width * pixelRatio;
    across = side * (halfWidth + 0.5);
    gl_ClipDistance[0] = dot(cut, vec4(end > 0.5 ? b : a, 1.0));
    vec4 corner = end > 0.5 ? second : first;
    vec2 offset = vec2(-direction.y, direction.x) * across + direction * (end - 0.5) * halfWidth;
    corner.xy += 2.0 * offset / pixels * corner.w;
    gl_Position = corner;
    lineColour = vec4(paint.rgb, paint.a * opacity * strength);
}
)";
}

std::string lineFragment() {
    return version() + R"(
flat in vec4 lineColour;
flat in float halfWidth;
noperspective in float across;
out vec4 colour;
void main() {
    float coverage = clamp(halfWidth + 0.5 - abs(across), 0.0, min(1.0, 2.0 * halfWidth));
    colour = vec4(lineColour.rgb, lineColour.a * coverage);
}
)";
}

std::string pointVertex() {
    return version() + viewing + R"(
uniform samplerBuffer points;
uniform mat4 view;
uniform vec2 pixels;
uniform vec4 cut;
uniform float radius, lift; // pixels, m
noperspective out vec2 offset;
flat out float strength;
void main() {
    vec4 point = texelFetch(points, gl_InstanceID);
    strength = point.w;
    vec3 p = (view * vec4(point.xyz, 1.0)).xyz;
    gl_ClipDistance[0] = dot(cut, vec4(p, 1.0)); // the whole dot or nothing
    vec4 centre = projection * vec4(lifted(p, lift), 1.0);
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    offset = corner * (radius + 0.5);
    centre.xy += 2.0 * offset / pixels * centre.w;
    gl_Position = centre;
}
)";
}

std::string pointFragment() {
    return version() + R"(
noperspective in vec2 offset;
flat in float strength;
uniform vec4 tint;
uniform float radius, edge;
out vec4 colour;
void main() {
    float coverage = clamp(radius + 0.5 - length(offset), 0.0, 1.0);
    if (coverage <= 0.0) discard;
    float core = clamp(radius - edge + 0.5 - length(offset), 0.0, 1.0);
    vec3 shade = edge > 0.0 ? mix(vec3(0.10, 0.11, 0.13), tint.rgb, core) : tint.rgb;
    colour = vec4(shade, tint.a * coverage * strength);
}
)";
}

} // namespace esm::shaders
