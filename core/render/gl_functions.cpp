#include "core/render/gl_functions.h"

#include <stdexcept>
#include <string>

namespace esm {
namespace {

template<typename Function> Function resolved(const Renderer::Resolver& resolver, const char* name) {
    void* address = resolver(name);
    if (!address)
        throw std::runtime_error(std::string("the graphics driver has no ") + name +
                                 "; OpenGL 3.3 is needed, a newer driver may help");
    return reinterpret_cast<Function>(address);
}

} // namespace

GlFunctions::GlFunctions(const Renderer::Resolver& resolver) {
#define ESM_GL_RESOLVE(type, name) name = resolved<type>(resolver, "gl" #name);
    ESM_GL_FUNCTIONS(ESM_GL_RESOLVE)
#undef ESM_GL_RESOLVE
}

} // namespace esm
