#include "app/editor/tools/motion_device.h"

#include <QSocketNotifier>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace esm {

namespace {

using DeviceEvent = std::array<std::int32_t, 8>;

constexpr double fullDeflection = 350; ///< in the service's numbers
constexpr int longestPeriod = 50;      ///< ms; after a rest the service counts the rest as well
constexpr int searchEvery = 5000;      ///< ms

Eigen::Vector3d share(double x, double y, double z) {
    return (Eigen::Vector3d(x, y, z) / fullDeflection).cwiseMax(-1).cwiseMin(1);
}

} // namespace

/// The service's z points away from the viewer, so that its axes are left-handed, turns too.
std::optional<std::pair<DeviceMotion, double>> motionOf(const DeviceEvent& event) {
    const auto [type, x, y, z, rx, ry, rz, period] = event;
    if (type != 0) return std::nullopt;
    return std::pair(DeviceMotion{share(x, y, -double(z)), share(-double(rx), -double(ry), rz)},
                     std::clamp(period, 0, longestPeriod) / 1000.0);
}

MotionDevice::MotionDevice(std::string socketPath, QObject* parent)
    : QObject(parent), m_path(std::move(socketPath)) {
    connect(&m_search, &QTimer::timeout, this, &MotionDevice::connectToService);
    m_search.start(searchEvery);
    QTimer::singleShot(0, this, &MotionDevice::connectToService);
}

MotionDevice::~MotionDevice() {
    if (isConnected()) ::close(m_socket);
}

void MotionDevice::connectToService() {
    sockaddr_un address{};
    if (isConnected() || m_path.size() >= sizeof address.sun_path) return;
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, m_path.c_str(), m_path.size() + 1);
    const int opened = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (opened < 0) return;
    if (::connect(opened, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        ::close(opened);
        return;
    }
    m_socket = opened;
    m_notifier = std::make_unique<QSocketNotifier>(m_socket, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &MotionDevice::read);
    m_search.stop();
    emit connectionChanged(true);
}

void MotionDevice::disconnectFromService() {
    m_notifier.release()->deleteLater(); // it is telling us just now
    ::close(m_socket);
    m_socket = -1;
    m_received.clear();
    m_search.start(searchEvery);
    emit moved({}, 0);
    emit connectionChanged(false);
}

void MotionDevice::read() {
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(m_socket, buffer.data(), buffer.size());
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) return disconnectFromService();
    m_received.append(buffer.data(), static_cast<int>(count));
    int place = 0;
    for (; m_received.size() - place >= int(sizeof(DeviceEvent)); place += int(sizeof(DeviceEvent))) {
        DeviceEvent event;
        std::memcpy(event.data(), m_received.constData() + place, sizeof event);
        if (const auto motion = motionOf(event)) emit moved(motion->first, motion->second);
    }
    m_received.remove(0, place);
}

} // namespace esm
