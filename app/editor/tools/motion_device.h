#pragma once

#include "app/editor/tools/device_motion.h"

#include <QByteArray>
#include <QObject>
#include <QTimer>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class QSocketNotifier;

namespace esm {

/// A 6-degree-of-freedom device behind the service spacenavd, which speaks on a local socket: eight 32-bit
/// integers per event. Spoken directly: a library for that alone would be one more dependency. Without the
/// service nothing happens, and it is looked for again from time to time.
class MotionDevice : public QObject {
    Q_OBJECT

public:
    explicit MotionDevice(std::string socketPath, QObject* parent = nullptr);
    ~MotionDevice() override;

    /// Where spacenavd listens.
    static std::string serviceSocket() { return "/var/run/spnav.sock"; }
    bool isConnected() const { return m_socket >= 0; }

signals:
    void connectionChanged(bool connected);
    /// The cap's place, and how long it has been there, s.
    void moved(const esm::DeviceMotion& motion, double seconds);

private:
    void connectToService();
    void disconnectFromService();
    void read();

    std::string m_path;
    int m_socket = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    QByteArray m_received; ///< less than an event
    QTimer m_search;
};

/// What an event says, in the service's words: type, x, y, z, rx, ry, rz, period in ms. Nothing for a button.
std::optional<std::pair<DeviceMotion, double>> motionOf(const std::array<std::int32_t, 8>& event);

} // namespace esm
