#include "tests/support/sanitized.h"

bool isSanitized() {
#ifdef ESM_SANITIZE
    return true;
#else
    return false;
#endif
}
