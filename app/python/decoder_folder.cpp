#include <dlfcn.h>

#include <filesystem>

/// Where the program lies that decodes pictures of projects: below the prefix that this module was installed
/// to, wherever that was moved. The running program is Python, and says nothing of it.
extern "C" const char* esmDecoderFolder() {
    static const std::string folder = [] {
        Dl_info module;
        if (::dladdr(reinterpret_cast<const void*>(&esmDecoderFolder), &module) == 0) return std::string();
        return (std::filesystem::path(module.dli_fname).parent_path() / ESM_DECODERS_FROM_MODULE).string();
    }();
    return folder.c_str();
}
