#include "app/editor/tools/motion_device.h"
#include "core/samples/samples.h"
#include "core/support/angles.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// From the right, a little rolled.
Camera sideCamera() {
    Camera camera;
    camera.eye = {1, 0, 0};
    camera.target = {0, 0, 0};
    camera.up = {0, 1, 0};
    return camera;
}

TEST(DeviceMotion, CarriesAlongTheScreensAxes) {
    Projector before;
    before.pose.translation() = Vector3d(0.1, 0.2, 0.3);
    const auto pushed = [&](const Vector3d& push) -> Vector3d {
        return carried(before, {push, {0, 0, 0}}, sideCamera(), 0.2, 0.5).pose.translation() -
               before.pose.translation();
    };
    EXPECT_TRUE(pushed({1, 0, 0}).isApprox(Vector3d(0, 0, -0.1), 1e-9)) << "to the right of the screen";
    EXPECT_TRUE(pushed({0, 1, 0}).isApprox(Vector3d(0, 0.1, 0), 1e-9)) << "upwards";
    EXPECT_TRUE(pushed({0, 0, -0.5}).isApprox(Vector3d(-0.05, 0, 0), 1e-9)) << "away from the viewer";
}

TEST(DeviceMotion, TurnsAboutTheProjectorsPlaceInTheScreensAxes) {
    Projector before;
    before.pose.translation() = Vector3d(0.1, 0.2, 0.3);
    const Projector after = carried(before, {{0, 0, 0}, {0, 0, 1}}, sideCamera(), 0.2, 1);
    EXPECT_TRUE(after.pose.translation().isApprox(before.pose.translation()));
    // A quarter to the left as seen from +x.
    EXPECT_TRUE((after.pose.linear() * Vector3d::UnitY()).isApprox(Vector3d::UnitZ(), 1e-9));
    Projector many = before;
    for (int i = 0; i < 1000; ++i)
        many = carried(many, {{0, 0, 0}, {0.2, 0.5, -0.7}}, sideCamera(), 0.2, 0.03);
    EXPECT_LT((many.pose.linear() * many.pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm(),
              1e-12);
}

TEST(DeviceMotion, ReadsTheServicesLeftHandedAxes) {
    const auto motion = motionOf({0, 350, -175, 70, 35, 70, 105, 16});
    ASSERT_TRUE(motion);
    EXPECT_TRUE(motion->first.push.isApprox(Vector3d(1, -0.5, -0.2)));
    EXPECT_TRUE(motion->first.turn.isApprox(Vector3d(-0.1, -0.2, 0.3)));
    EXPECT_DOUBLE_EQ(motion->second, 0.016);
    EXPECT_LE(motionOf({0, 1, 0, 0, 0, 0, 0, 60000})->second, 0.1) << "a rest is no motion";
    EXPECT_EQ(motionOf({0, 9999, 0, 0, 0, 0, 0, 1})->first.push.x(), 1);
    EXPECT_FALSE(motionOf({1, 3, 1, 0, 0, 0, 0, 0})) << "a button";
}

/// A service as the device's own.
class FakeService {
public:
    explicit FakeService(const std::string& path) : m_listening(::socket(AF_UNIX, SOCK_STREAM, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::copy(path.begin(), path.end(), address.sun_path);
        EXPECT_EQ(::bind(m_listening, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        EXPECT_EQ(::listen(m_listening, 1), 0);
    }
    ~FakeService() {
        hangUp();
        ::close(m_listening);
    }
    void answer() { m_client = ::accept(m_listening, nullptr, nullptr); }
    void send(const char* bytes, std::size_t count) const {
        EXPECT_EQ(::write(m_client, bytes, count), static_cast<ssize_t>(count));
    }
    /// Whether the device has taken all that was sent.
    bool isRead() const {
        int waiting = 0;
        EXPECT_EQ(::ioctl(m_client, SIOCOUTQ, &waiting), 0);
        return waiting == 0;
    }
    void hangUp() {
        if (m_client >= 0) ::close(m_client);
        m_client = -1;
    }

private:
    int m_listening, m_client = -1;
};

TEST(MotionDevice, ReadsEventsHoweverTheyArrive) {
    const TemporaryFolder folder;
    const std::string path = (folder / "spnav.sock").string();
    FakeService service(path);
    MotionDevice device(path);
    std::vector<DeviceMotion> motions;
    bool connected = false;
    QObject::connect(&device, &MotionDevice::moved,
                     [&](const DeviceMotion& motion, double) { motions.push_back(motion); });
    QObject::connect(&device, &MotionDevice::connectionChanged, [&](bool on) { connected = on; });
    ESM_EVENTUALLY(connected);
    service.answer();
    const std::array<std::int32_t, 16> events{0, 350, 0, 0, 0, 0, 0, 10, 0, 0, 350, 0, 0, 0, 0, 10};
    const char* bytes = reinterpret_cast<const char*>(events.data());
    service.send(bytes, 20);
    ESM_EVENTUALLY(service.isRead());
    EXPECT_TRUE(motions.empty()) << "not whole yet";
    service.send(bytes + 20, 44);
    ESM_EVENTUALLY(motions.size() == 2);
    EXPECT_EQ(motions[0].push, Vector3d(1, 0, 0));
    EXPECT_EQ(motions[1].push, Vector3d(0, 1, 0));
    service.hangUp();
    ESM_EVENTUALLY(!connected);
    EXPECT_TRUE(motions.back().isRest()) << "nothing goes on moving";
}

TEST(MotionDevice, IsSilentWithoutAService) {
    MotionDevice device("/nonexistent/spnav.sock");
    QTest::qWait(0); // it looks for the service once events are handled
    EXPECT_FALSE(device.isConnected());
}

class DeviceInTheWindow : public EditorTest {};

TEST_F(DeviceInTheWindow, CarriesThePhotoInOneStep) {
    Project before = makeSample("liver");
    before.layers.resize(1);
    before.layers[0].photo = makeSamplePhoto("serosa");
    open(before);
    window->windowActions().texture->trigger();
    auto* device = window->findChild<MotionDevice*>();
    ASSERT_NE(device, nullptr);
    const auto x = [this] { return project().layers[0].projector.pose.translation().x(); };
    const double start = x();
    for (int i = 0; i < 10; ++i)
        emit device->moved({{1, 0, 0}, {0, 0, 0}}, 0.02);
    const double size = boundingBox(before.mesh->vertices).diagonal().norm();
    EXPECT_NEAR(x() - start, 0.2 * size, 0.05 * size) << "to the right of the front view";
    EXPECT_EQ(window->document().undoStack()->count(), 1);
    emit device->moved({}, 0.02);
    emit device->moved({{-1, 0, 0}, {0, 0, 0}}, 0.02);
    EXPECT_EQ(window->document().undoStack()->count(), 2) << "the cap was let go between";
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    EXPECT_EQ(x(), start);
    window->windowActions().tissue->trigger();
    emit device->moved({{1, 0, 0}, {0, 0, 0}}, 0.02);
    EXPECT_EQ(x(), start) << "only in the workspace of photos";
}

} // namespace
