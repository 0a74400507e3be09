#pragma once

#include <QElapsedTimer>

#include <functional>

namespace esm {

/// Time that passes, ms: what waits for a while takes it as a parameter, so that tests need not wait.
using PassingTime = std::function<qint64()>;

inline PassingTime sinceStart() {
    QElapsedTimer timer;
    timer.start();
    return [timer] { return timer.elapsed(); };
}

} // namespace esm
