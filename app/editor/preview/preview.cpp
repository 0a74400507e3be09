#include "app/editor/preview/preview.h"

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds framePeriod{16667};
constexpr std::chrono::milliseconds settleTime{300};

double inSeconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

} // namespace

Preview::Preview(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

Preview::~Preview() {
    send([](Inbox& inbox) { inbox.stop = true; });
    m_thread.join();
}

template<typename Change> void Preview::send(Change change) {
    {
        const std::lock_guard lock(m_mutex);
        change(m_inbox);
        m_inbox.isNew = true;
    }
    m_changed.notify_one();
}

void Preview::setProject(const Project& project) {
    send([&](Inbox& inbox) { inbox.project = project; });
}

void Preview::setPlaying(bool playing) {
    send([&](Inbox& inbox) { inbox.playing = playing; });
}

void Preview::reset() {
    send([](Inbox& inbox) { inbox.reset = true; });
}

void Preview::setPull(const std::optional<Pull>& pull) {
    send([&](Inbox& inbox) { inbox.loads.pull = pull; });
}

void Preview::setInstrument(const std::optional<Sphere>& instrument) {
    send([&](Inbox& inbox) { inbox.loads.instrument = instrument; });
}

void Preview::setGentleMotion(bool on) {
    send([&](Inbox& inbox) { inbox.loads.gentleMotion = on; });
}

PreviewFrame Preview::frame() {
    m_frameAnnounced = false;
    const std::lock_guard lock(m_mutex);
    return m_frame;
}

PreviewStatus Preview::status() const {
    const std::lock_guard lock(m_mutex);
    return m_status;
}

Preview::Inbox Preview::collect(bool idle, Clock::time_point until) {
    std::unique_lock lock(m_mutex);
    if (idle)
        m_changed.wait_until(lock, until, [this] { return m_inbox.isNew; });
    else
        m_changed.wait_until(lock, until, [this] { return m_inbox.stop; });
    Inbox taken = m_inbox;
    m_inbox.project.reset();
    m_inbox.reset = m_inbox.isNew = false;
    return taken;
}

void Preview::work() {
    PreviewRun run;
    auto next = Clock::now(), changedAt = next;
    bool playing = false;
    for (;;) {
        Inbox inbox = collect(!playing, playing ? next : Clock::now() + settleTime);
        if (inbox.stop) return;
        const auto start = Clock::now();
        next = start + framePeriod;
        if (inbox.project) {
            run.setProject(*inbox.project);
            changedAt = start;
        }
        if (inbox.reset) run.reset();
        playing = inbox.playing && run.isReady();
        if (playing && !run.advance(inSeconds(framePeriod), inbox.loads)) playing = false;
        const bool learned = Clock::now() - changedAt > settleTime && run.updateSafeStep();
        // A run that failed has to be started again by hand.
        if (inbox.playing && !playing) {
            const std::lock_guard lock(m_mutex);
            if (!m_inbox.project && !m_inbox.reset) {
                m_inbox.playing = false;
                inbox.isNew = true;
            }
        }
        if (playing || inbox.isNew || learned) publish(run);
    }
}

void Preview::publish(const PreviewRun& run) {
    bool statusIsNew = false;
    {
        const std::lock_guard lock(m_mutex);
        m_frame.network = run.network();
        m_frame.positions = run.positions();
        const bool played = m_status.playing;
        const std::string failed = m_status.failure;
        m_status = run.status();
        m_status.playing = m_inbox.playing;
        statusIsNew = played != m_status.playing || failed != m_status.failure;
    }
    if (!m_frameAnnounced.exchange(true)) emit frameReady();
    if (statusIsNew) emit statusChanged();
}

} // namespace esm
