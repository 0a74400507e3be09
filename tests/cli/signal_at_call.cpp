// Loaded before the C library (LD_PRELOAD): a program gives itself the signal ESM_SIGNAL at the moment
// ESM_SIGNAL_AT, "before" or "after" one of the calls by which a file takes the place of another, as in
// "after linkat". What lies on the disk between two calls can be seen so, however close they follow each
// other.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <unistd.h>

namespace {

void signalAt(const std::string& moment) {
    static bool isOver = false; // a program may sync several times
    const char* const wanted = std::getenv("ESM_SIGNAL_AT");
    if (isOver || !wanted || moment != wanted) return;
    isOver = true;
    ::kill(::getpid(), std::atoi(std::getenv("ESM_SIGNAL")));
}

/// Makes the call that the C library has by that name.
template<typename... Arguments> int watched(const char* name, Arguments... arguments) {
    signalAt(std::string("before ") + name);
    const auto call = reinterpret_cast<int (*)(Arguments...)>(::dlsym(RTLD_NEXT, name));
    const int result = call(arguments...);
    signalAt(std::string("after ") + name);
    return result;
}

} // namespace

extern "C" int fsync(int descriptor) {
    return watched("fsync", descriptor);
}

extern "C" int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept {
    return watched("linkat", fromFolder, from, toFolder, to, flags);
}

extern "C" int rename(const char* from, const char* to) noexcept {
    return watched("rename", from, to);
}
