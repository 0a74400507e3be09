#include "app/editor/window/slow_motion.h"

#include "widgets/inputs/number_text.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Of real speed. Nearer to it nobody feels the difference.
constexpr double slowMotion = 0.8;
constexpr qint64 patience = 2000; // ms; a moment of slowness is no harm, and a moment of speed no change
constexpr double otherSpeed = 2;  // times what was said; a number that wavers is not read

/// To two digits, that nobody takes for exact.
std::size_t rounded(double nodes) {
    const double digit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(nodes, 1.0))) - 1));
    return static_cast<std::size_t>(digit * std::floor(nodes / digit));
}

} // namespace

std::size_t nodesAtRealSpeed(std::size_t nodes, double realTimeFactor) {
    constexpr double leftForOthers = 0.8, most = 0.7;
    constexpr std::size_t fewest = 200; // fewer hardly follow an organ's shape
    const double wanted = static_cast<double>(nodes) * std::min(most, leftForOthers * realTimeFactor);
    return std::max(fewest, rounded(wanted));
}

SlowMotion::SlowMotion(QWidget& view, Document& document, PassingTime clock)
    : QObject(&view), m_document(document), m_clock(std::move(clock)), m_notice(new ViewNotice(view)) {
    connect(m_notice, &ViewNotice::helpAsked, this, [this] { emit fewerNodesAsked(m_offered); });
    connect(m_notice, &ViewNotice::dismissed, this, [this] { m_isDismissed = true; });
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh) forget();
    });
}

/// What was measured is of another organ, or of other nodes.
void SlowMotion::forget() {
    m_slowSince.reset();
    m_rightSince.reset();
    m_isDismissed = false;
    m_notice->hide();
}

void SlowMotion::showStatus(const PreviewStatus& status) {
    if (!status.playing || status.realTimeFactor <= 0) { // what is paused is slow still
        m_slowSince.reset();
        m_rightSince.reset();
        return;
    }
    noteSpeed(status.realTimeFactor > 0 && status.realTimeFactor < slowMotion);
    const auto lasts = [&](const std::optional<qint64>& since) {
        return since && m_clock() - *since > patience;
    };
    if (lasts(m_rightSince)) m_notice->hide();
    if (lasts(m_slowSince) && !m_isDismissed) tell(status.realTimeFactor);
}

void SlowMotion::noteSpeed(bool isSlow) {
    std::optional<qint64>& since = isSlow ? m_slowSince : m_rightSince;
    if (!since) since = m_clock();
    (isSlow ? m_rightSince : m_slowSince).reset();
}

void SlowMotion::tell(double realTimeFactor) {
    const bool isAlike = realTimeFactor < otherSpeed * m_said && m_said < otherSpeed * realTimeFactor;
    if (!m_notice->isHidden() && isAlike) return;
    m_said = realTimeFactor;
    const Project& project = m_document.project();
    const std::size_t nodes = project.network->restPositions.size();
    m_offered = nodesAtRealSpeed(nodes, realTimeFactor);
    const auto filling = detailOf(*project.network).filling;
    const bool hasWall = filling && isWall(*filling); // which has the nodes of its surface
    const bool helps = !project.mesh->triangles.empty() && !hasWall && m_offered < nodes;
    const double times = 1 / realTimeFactor;
    m_notice->say(
        tr("Slowed down to %1 of its real speed: in a simulator that keeps up, the tissue moves %2 times "
           "as fast as here.")
            .arg(numberText(realTimeFactor, 1), numberText(times, times < 10 ? 2 : 1)),
        helps ? tr("Simulate %1 nodes").arg(countText(m_offered)) : QString(),
        tr("So many of the %1 nodes move at real speed here, likely; the surface that is seen stays "
           "the same. Otherwise lower spring constants, more viscosity or more mass help.")
            .arg(countText(nodes)));
}

} // namespace esm
