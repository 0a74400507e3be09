#include "app/editor/workers/preview.h"

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds framePeriod{16667};

double inSeconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

} // namespace

Preview::Preview(QObject* parent)
    : QObject(parent), m_safeSteps([this](std::optional<double> step) { takeSafeStep(step); }),
      m_thread([this] { work(); }) {}

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
    send([&](Inbox& inbox) {
        inbox.project = project;
        ++inbox.projects;
    });
}

int Preview::projectCount() const {
    const std::lock_guard lock(m_mutex);
    return m_inbox.projects;
}

void Preview::setPlaying(bool playing) {
    send([&](Inbox& inbox) { inbox.playing = playing; });
}

void Preview::togglePlaying() {
    send([this](Inbox& inbox) {
        inbox.playing = !inbox.playing;
        if (!m_status.failure.empty()) inbox.reset = true;
    });
}

void Preview::reset() {
    send([](Inbox& inbox) { inbox.reset = true; });
}

void Preview::playScene() {
    send([](Inbox& inbox) {
        inbox.playScene = inbox.playing = true;
        inbox.loads.gentleMotion = false;
    });
}

void Preview::setPull(const std::optional<Pull>& pull) {
    send([&](Inbox& inbox) { inbox.loads.pull = pull; });
}

void Preview::setInstrument(const std::optional<PlacedCollider>& instrument) {
    send([&](Inbox& inbox) { inbox.loads.instrument = instrument; });
}

void Preview::setGentleMotion(bool on) {
    send([&](Inbox& inbox) { inbox.loads.gentleMotion = on; });
}

PreviewLoads Preview::loads() const {
    const std::lock_guard lock(m_mutex);
    return m_inbox.loads;
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

std::shared_ptr<const TissueModel> Preview::tissue() const {
    const std::lock_guard lock(m_mutex);
    return m_tissueProject == m_inbox.projects ? m_tissue : nullptr;
}

Preview::Inbox Preview::collect(bool idle, Clock::time_point until) {
    std::unique_lock lock(m_mutex);
    if (idle)
        m_changed.wait(lock, [this] { return m_inbox.isNew; });
    else
        m_changed.wait_until(lock, until, [this] { return m_inbox.stop; });
    Inbox taken = m_inbox;
    m_inbox.project.reset();
    m_inbox.reset = m_inbox.playScene = m_inbox.isNew = false;
    return taken;
}

void Preview::work() {
    Worker worker;
    for (bool goOn = true; goOn;) {
        try {
            goOn = workOnce(worker);
        } catch (const std::exception& error) {
            worker.playing = false;
            giveUp(worker.run, error.what());
        }
    }
}

bool Preview::workOnce(Worker& worker) {
    Inbox inbox = collect(!worker.playing, worker.next);
    if (inbox.stop) return false;
    worker.next = Clock::now() + framePeriod;
    if (inbox.project) takeProject(worker, *inbox.project, inbox.projects);
    worker.project = inbox.projects;
    if (inbox.reset) worker.run.reset();
    if (inbox.playScene) worker.run.beginScene();
    worker.playing =
        inbox.playing && worker.run.isReady() && worker.run.advance(inSeconds(framePeriod), inbox.loads);
    gauge(worker);
    // A run that failed, or came to its scene's end, has to be started again by hand.
    if (inbox.playing && !worker.playing) {
        const std::lock_guard lock(m_mutex);
        if (!m_inbox.project && !m_inbox.reset && !m_inbox.playScene) {
            m_inbox.playing = false;
            inbox.isNew = true;
        }
    }
    if (worker.playing || inbox.isNew) publish(worker);
    return true;
}

void Preview::takeProject(Worker& worker, const Project& project, int number) {
    // The step of other parameters says nothing of these.
    worker.gauged.reset();
    const bool runs = worker.run.setProject(project);
    {
        const std::lock_guard lock(m_mutex);
        m_tissue = worker.run.tissue();
        m_tissueProject = number;
    }
    emit tissueReady();
    if (runs)
        gauge(worker);
    else
        takeSafeStep(std::nullopt);
}

void Preview::gauge(Worker& worker) {
    if (!worker.run.isReady() || worker.gauged == worker.run.integrator()) return;
    worker.gauged = worker.run.integrator();
    m_safeSteps.find(worker.run.model(), *worker.gauged);
}

void Preview::giveUp(PreviewRun& run, const std::string& reason) {
    run.stop(reason);
    {
        const std::lock_guard lock(m_mutex);
        m_inbox.playing = m_status.playing = false;
        m_status.failure = reason;
    }
    emit statusChanged();
}

void Preview::takeSafeStep(std::optional<double> step) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_status.safeStep == step) return;
        m_status.safeStep = step;
    }
    emit statusChanged();
}

void Preview::publish(const Worker& worker) {
    const PreviewRun& run = worker.run;
    PreviewStatus status = run.status();
    bool statusIsNew = false;
    {
        const std::lock_guard lock(m_mutex);
        m_frame.network = run.network();
        m_frame.positions = run.positions();
        m_frame.instruments = run.sceneInstruments();
        m_frame.project = worker.project;
        status.playing = m_inbox.playing;
        status.safeStep = m_status.safeStep;
        statusIsNew = m_status.playing != status.playing || m_status.failure != status.failure ||
                      m_status.halvings != status.halvings || m_status.isReplaced != status.isReplaced ||
                      m_status.isShortened != status.isShortened;
        m_status = std::move(status);
    }
    if (!m_frameAnnounced.exchange(true)) emit frameReady();
    if (statusIsNew) emit statusChanged();
}

} // namespace esm
