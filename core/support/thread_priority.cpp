#include "core/support/thread_priority.h"

#include <sys/resource.h>

namespace esm {

void giveWay(int niceness) {
    // On Linux a niceness is the thread's, not the process's.
    ::setpriority(PRIO_PROCESS, 0, niceness);
}

} // namespace esm
