#include "app/editor/workers/preview.h"

#include "app/editor/workers/preview_run.h"
#include "core/support/errors.h"

#include <utility>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::microseconds framePeriod{16667};

double inSeconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

/// Takes a command, unless it waits for a project that has not arrived.
std::optional<int> takeDue(std::optional<int>& command, int arrived) {
    return command && *command <= arrived ? std::exchange(command, std::nullopt) : std::nullopt;
}

} // namespace

/// The worker's own.
struct Preview::Worker {
    PreviewRun run;
    bool playing = false;
    std::chrono::steady_clock::time_point next;
    std::optional<Integrator> gauged; ///< the one whose largest stable step is sought or told
};

Preview::Preview(QObject* parent)
    : QObject(parent), m_safeSteps([this](std::optional<double> step) { takeSafeStep(step); }),
      m_factoriser(std::make_shared<MatrixFactoriser>()),
      m_preparer([this](const auto& task) { return prepare(task); }, [this] { takePrepared(); }),
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
    bool isOtherOrgan = false;
    {
        const std::lock_guard lock(m_mutex);
        ++m_inbox.asked;
        isOtherOrgan = std::exchange(m_inbox.network, project.network) != project.network;
        if (isOtherOrgan) {
            m_status = {};
            m_status.playing = m_inbox.playing;
        }
    }
    m_preparer.ask(project);
    if (isOtherOrgan) emit statusChanged();
}

int Preview::projectCount() const {
    const std::lock_guard lock(m_mutex);
    return m_inbox.asked;
}

std::shared_ptr<PreparedProject> Preview::prepare(const Preparer::Task& task) {
    const auto tell = [&](const auto& tissue) { tellTissue(tissue, task.number); };
    return std::make_shared<PreparedProject>(prepareProject(task.question, tell, m_factoriser));
}

void Preview::tellTissue(const std::shared_ptr<const TissueModel>& tissue, int number) {
    {
        const std::lock_guard lock(m_mutex);
        m_tissue = tissue;
        m_tissueProject = number;
    }
    emit tissueReady();
}

void Preview::takePrepared() {
    Outcome<std::shared_ptr<PreparedProject>> outcome = m_preparer.outcome();
    if (!outcome.failure.empty()) {
        outcome.answer = std::make_shared<PreparedProject>();
        outcome.answer->failure = outcome.failure;
    }
    send([&](Inbox& inbox) {
        inbox.arrived = outcome.number;
        if (inbox.isHeldByFailure && outcome.answer->failure.empty()) {
            inbox.isHeldByFailure = false;
            inbox.playing = true;
        }
        inbox.prepared = std::move(outcome.answer);
    });
}

void Preview::setPlaying(bool playing) {
    send([&](Inbox& inbox) {
        inbox.playing = playing;
        inbox.isHeldByFailure = false;
    });
}

bool Preview::isToPlay() const {
    const std::lock_guard lock(m_mutex);
    return m_inbox.playing;
}

void Preview::togglePlaying() {
    send([this](Inbox& inbox) {
        inbox.playing = !inbox.playing;
        inbox.isHeldByFailure = false;
        if (!m_status.failure.empty()) inbox.reset = inbox.asked;
    });
}

void Preview::reset() {
    send([](Inbox& inbox) {
        inbox.reset = inbox.asked;
        inbox.playScene.reset();
    });
}

void Preview::record() {
    send([](Inbox& inbox) {
        inbox.record = inbox.asked; // from rest
        inbox.isHeldByFailure = false;
        inbox.reset.reset();
        inbox.playScene.reset();
        inbox.playing = true;
        inbox.loads.gentleMotion = false;
    });
}

bool Preview::isRecording() const {
    const std::lock_guard lock(m_mutex);
    return m_inbox.record || m_recorder;
}

std::optional<double> Preview::recordedTime() const {
    const std::lock_guard lock(m_mutex);
    return m_recorder ? std::optional(m_recorder->poke().duration) : std::nullopt;
}

std::optional<Poke> Preview::endRecording() {
    const std::lock_guard lock(m_mutex);
    m_inbox.record.reset();
    std::optional<PokeRecorder> recorder = std::exchange(m_recorder, std::nullopt);
    return recorder ? std::optional(recorder->poke()) : std::nullopt;
}

void Preview::playScene() {
    send([](Inbox& inbox) {
        inbox.playScene = inbox.asked; // from rest
        inbox.isHeldByFailure = false;
        inbox.reset.reset();
        inbox.record.reset();
        inbox.playing = true;
        inbox.loads.gentleMotion = false;
    });
}

void Preview::setPull(const std::optional<Pull>& pull) {
    if (pull && !loads().pull) emit pullBegan();
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

std::optional<PlacedCollider> Preview::heldInstrument() const {
    const std::lock_guard lock(m_mutex);
    return m_status.playing ? m_frame.heldInstrument : std::nullopt;
}

std::shared_ptr<const TissueModel> Preview::tissue() const {
    const std::lock_guard lock(m_mutex);
    return m_tissueProject == m_inbox.asked ? m_tissue : nullptr;
}

Preview::Inbox Preview::collect(bool idle, Clock::time_point until) {
    std::unique_lock lock(m_mutex);
    if (idle)
        m_changed.wait(lock, [this] { return m_inbox.isNew; });
    else
        // New parameters are not kept waiting for the next frame.
        m_changed.wait_until(lock, until, [this] { return m_inbox.stop || m_inbox.prepared; });
    Inbox taken = m_inbox;
    m_inbox.prepared.reset();
    m_inbox.safeStep.reset();
    m_inbox.isNew = false;
    taken.reset = takeDue(m_inbox.reset, m_inbox.arrived);
    taken.playScene = takeDue(m_inbox.playScene, m_inbox.arrived);
    taken.record = takeDue(m_inbox.record, m_inbox.arrived);
    if (taken.record)
        m_recorder.emplace(m_inbox.network); // within the lock: it is always seen to be going on
    return taken;
}

void Preview::work() {
    Worker worker;
    for (bool goOn = true; goOn;) {
        try {
            goOn = workOnce(worker);
        } catch (const std::exception& error) {
            worker.playing = false;
            giveUp(worker.run, reasonOf(error));
        }
    }
}

bool Preview::workOnce(Worker& worker) {
    Inbox inbox = collect(!worker.playing, worker.next);
    if (inbox.stop) return false;
    worker.next = Clock::now() + framePeriod;
    PreviewRun& run = worker.run;
    if (inbox.prepared)
        take(worker, std::move(*inbox.prepared));
    else if (inbox.safeStep)
        run.keepWithin(*inbox.safeStep);
    if (inbox.reset) run.reset();
    if (inbox.playScene) run.beginScene();
    if (inbox.record) run.reset();
    if (inbox.reset || inbox.playScene) {
        const std::lock_guard lock(m_mutex);
        m_recorder.reset();
    }
    // An organ that another one is to replace rests.
    const bool isWanted = inbox.playing && run.network() == inbox.network;
    const bool canPlay = isWanted && run.isReady();
    worker.playing = canPlay && advance(run, inbox.loads);
    gauge(worker);
    const bool isSceneOver = canPlay && !worker.playing && run.isReady();
    if (inbox.playing && !worker.playing) pauseWhatEnded(inbox, isSceneOver);
    if (worker.playing || inbox.isNew) publish(worker, inbox.arrived);
    return true;
}

bool Preview::advance(PreviewRun& run, const PreviewLoads& loads) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_recorder && m_recorder->poke().network != run.network()) m_recorder.reset();
        if (m_recorder) m_recorder->note(run.time(), loads);
    }
    const bool goesOn = run.advance(inSeconds(framePeriod), loads);
    const std::lock_guard lock(m_mutex);
    if (m_recorder) m_recorder->goOn(run.time());
    return goesOn;
}

/// A run that came to its scene's end has to be started again by hand. One that failed goes on, from rest, by
/// the project that is being prepared, or by the next.
void Preview::pauseWhatEnded(Inbox& inbox, bool isSceneOver) {
    const std::lock_guard lock(m_mutex);
    const bool changes = m_inbox.prepared || m_inbox.arrived != m_inbox.asked;
    if ((changes && !isSceneOver) || m_inbox.reset || m_inbox.playScene || m_inbox.record) return;
    m_inbox.isHeldByFailure = m_inbox.playing && !isSceneOver;
    m_inbox.playing = false;
    inbox.isNew = true;
}

void Preview::take(Worker& worker, PreparedProject prepared) {
    // The step of other parameters says nothing of these.
    worker.gauged.reset();
    const bool hadFailed = worker.run.hasFailed();
    const bool canRun = worker.run.take(std::move(prepared));
    if (hadFailed) worker.run.reset();
    if (canRun)
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
    send([&](Inbox& inbox) { inbox.safeStep = step; });
    emit statusChanged();
}

void Preview::publish(const Worker& worker, int project) {
    const PreviewRun& run = worker.run;
    PreviewStatus status = run.status();
    bool statusIsNew = false;
    {
        const std::lock_guard lock(m_mutex);
        const bool isFormerOrgan = run.network() != m_inbox.network;
        if (isFormerOrgan && m_inbox.arrived != m_inbox.asked) return;
        m_frame.network = run.network();
        m_frame.positions = run.positions();
        m_frame.speeds = run.speeds();
        m_frame.instruments = run.sceneInstruments();
        m_frame.heldInstrument = run.heldInstrument();
        m_frame.project = project;
        status.playing = m_inbox.playing;
        status.safeStep = m_status.safeStep;
        statusIsNew = m_status.playing != status.playing || m_status.failure != status.failure ||
                      m_status.halvings != status.halvings || m_status.replaced != status.replaced ||
                      m_status.isShortened != status.isShortened;
        m_status = std::move(status);
    }
    if (!m_frameAnnounced.exchange(true)) emit frameReady();
    if (statusIsNew) emit statusChanged();
}

} // namespace esm
