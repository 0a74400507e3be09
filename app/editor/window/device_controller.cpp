#include "app/editor/window/device_controller.h"

#include <chrono>

namespace esm {

namespace {

/// A service that says nothing for so long has nothing to say: the cap was let go.
constexpr std::chrono::milliseconds letGoTime{400};

} // namespace

DeviceController::DeviceController(OrganView& view, Document& document, Selection& selection,
                                   MotionDevice& device)
    : QObject(&view), m_view(view), m_document(document), m_selection(selection) {
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, &document, &Document::finishGesture);
    connect(&device, &MotionDevice::moved, this, &DeviceController::carry);
    connect(&device, &MotionDevice::connectionChanged, this, [this](bool connected) {
        emit message(connected ? tr("A 6-degree-of-freedom device is there: it carries the selected photo")
                               : tr("The 6-degree-of-freedom device is gone"));
    });
}

void DeviceController::carry(const DeviceMotion& motion, double seconds) {
    const auto selected = m_selection.photo();
    if (!m_texture || !m_texture->isChecked() || !selected) return;
    if (motion.isRest()) {
        m_rest.stop();
        return m_document.finishGesture();
    }
    m_rest.start(letGoTime);
    const double size = boundingBox(m_document.project().mesh->vertices).diagonal().norm();
    m_document.edit(tr("Carry photo"),
                    [&](Project& project) {
                        Projector& projector = partOf(project.layers, *selected).projector;
                        projector = carried(projector, motion, m_view.camera(), size, seconds);
                    },
                    {EditKind::ProjectorCarrying, *selected});
}

} // namespace esm
