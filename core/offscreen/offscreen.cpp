#include "core/offscreen/offscreen.h"

#include "core/support/errors.h"

#include <GL/osmesa.h>

#include <algorithm>
#include <dlfcn.h>
#include <mutex>
#include <stdexcept>
#include <string>

namespace esm {
namespace {

constexpr int samples = 2; // per pixel in either direction
// Pixels. Larger pictures are drawn in parts, as memory and drivers have limits.
constexpr int tileSize = 1024;

std::mutex& osmesaMutex() {
    static std::mutex mutex; // OSMesa's set-up is not safe for threads, and shared by the whole process
    return mutex;
}

/// OSMesa is loaded apart from the program: its functions of OpenGL have the names of those that a window
/// draws with, and would stand in for them.
void* osMesaFunction(const char* name) {
    static void* const library = dlopen(ESM_OSMESA_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    void* const function = library ? dlsym(library, name) : nullptr;
    if (!function) throw std::runtime_error("no picture can be drawn: " ESM_OSMESA_LIBRARY " is missing");
    return function;
}

struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) createContextAttribs;
    decltype(&OSMesaMakeCurrent) makeCurrent;
    decltype(&OSMesaDestroyContext) destroyContext;
    decltype(&OSMesaGetProcAddress) getProcAddress;
};

const OsMesa& osMesa() {
    static const OsMesa functions{
        reinterpret_cast<decltype(&OSMesaCreateContextAttribs)>(osMesaFunction("OSMesaCreateContextAttribs")),
        reinterpret_cast<decltype(&OSMesaMakeCurrent)>(osMesaFunction("OSMesaMakeCurrent")),
        reinterpret_cast<decltype(&OSMesaDestroyContext)>(osMesaFunction("OSMesaDestroyContext")),
        reinterpret_cast<decltype(&OSMesaGetProcAddress)>(osMesaFunction("OSMesaGetProcAddress"))};
    return functions;
}

/// A context that draws into a square of `samples * tileSize` pixels, current as long as it lives.
class Context {
public:
    Context(int width, int height) : m_width(width) {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  24,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        m_context = osMesa().createContextAttribs(attributes, nullptr);
        if (!m_context) throw std::runtime_error("no picture can be drawn: OSMesa has no OpenGL 3.3");
        m_pixels.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        if (!osMesa().makeCurrent(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, width, height)) {
            osMesa().destroyContext(m_context);
            throw std::runtime_error("no picture can be drawn: OSMesa refuses a target of " +
                                     std::to_string(width) + " x " + std::to_string(height) + " pixels");
        }
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() {
        osMesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osMesa().destroyContext(m_context);
    }

    /// Red, green and blue of a pixel's samples, averaged; x from the left, y from the bottom.
    std::array<std::uint8_t, 3> averaged(int x, int y) const {
        std::array<unsigned, 3> sum{};
        for (int row = samples * y; row < samples * (y + 1); ++row)
            for (int column = samples * x; column < samples * (x + 1); ++column)
                for (std::size_t i = 0; i < 3; ++i)
                    sum[i] += at(column, row)[i];
        constexpr unsigned count = samples * samples;
        std::array<std::uint8_t, 3> mean{};
        for (std::size_t i = 0; i < 3; ++i)
            mean[i] = static_cast<std::uint8_t>((sum[i] + count / 2) / count);
        return mean;
    }

private:
    const std::uint8_t* at(int x, int y) const {
        return &m_pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                              static_cast<std::size_t>(x))];
    }

    OSMesaContext m_context = nullptr;
    int m_width;
    std::vector<std::uint8_t> m_pixels;
};

void* osmesaFunction(const char* name) {
    return reinterpret_cast<void*>(osMesa().getProcAddress(name));
}

void finish() {
    reinterpret_cast<void (*)()>(osMesa().getProcAddress("glFinish"))();
}

/// Copies a drawn tile, whose rows run from the bottom, to its place in the picture.
void place(const Context& tile, int left, int bottom, Image& picture) {
    const int width = std::min(tileSize, picture.width - left);
    const int height = std::min(tileSize, picture.height - bottom);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::array<std::uint8_t, 3> colour = tile.averaged(x, y);
            std::uint8_t* pixel = picture.at(left + x, picture.height - 1 - (bottom + y));
            std::copy(colour.begin(), colour.end(), pixel);
            pixel[3] = 255;
        }
}

} // namespace

Image renderOffscreen(const RenderScene& scene, const Camera& camera, int width, int height) {
    if (std::min(width, height) < 1 || std::max(width, height) > largestPictureSize)
        throw InvalidModel("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                           " pixels cannot be drawn: width and height go from 1 to " +
                           std::to_string(largestPictureSize));
    const std::lock_guard<std::mutex> lock(osmesaMutex());
    const Context context(samples * std::min(width, tileSize), samples * std::min(height, tileSize));
    Renderer renderer(osmesaFunction);
    Image picture;
    picture.width = width;
    picture.height = height;
    picture.pixels.resize(std::size_t{4} * static_cast<std::size_t>(width) *
                          static_cast<std::size_t>(height));
    for (int bottom = 0; bottom < height; bottom += tileSize)
        for (int left = 0; left < width; left += tileSize) {
            renderer.draw(scene, camera,
                          {samples * width, samples * height, samples, samples * left, samples * bottom});
            finish();
            place(context, left, bottom, picture);
        }
    return picture;
}

} // namespace esm
