#include "core/dynamics/kernel/thread_team.h"

#include <algorithm>
#include <immintrin.h>
#include <system_error>

namespace esm {

namespace {

// One word holds all that threads must agree on, so that each change of it is one atomic operation. m_state:
// the lowest bits count the threads inside, then one bit says that the job is open, then one that the team
// ends; above them is the number of the job. A thread enters by comparing and swapping the whole word: it
// cannot come into a job that has been closed since it looked.
constexpr std::uint64_t insideMask = 0xffff, openBit = 0x10000, endBit = 0x20000, jobUnit = 0x40000;

constexpr int spins = 2000; ///< some tens of microseconds
constexpr int yields = 100;

/// Waits until `isOver`, leaving the processor to others when it takes longer.
template<class Condition> bool waitBriefly(int yieldsAtMost, const Condition& isOver) {
    for (int i = 0; i < spins; ++i) {
        if (isOver()) return true;
        _mm_pause();
    }
    for (int i = 0; i < yieldsAtMost; ++i) {
        if (isOver()) return true;
        std::this_thread::yield();
    }
    return isOver();
}

} // namespace

ThreadTeam::ThreadTeam(std::size_t threads)
    : m_queues(std::clamp<std::size_t>(threads > 0 ? threads : std::thread::hardware_concurrency(), 1,
                                       insideMask)) {
    m_threads.reserve(m_queues.size() - 1);
    try {
        for (std::size_t thread = 1; thread < m_queues.size(); ++thread)
            m_threads.emplace_back([this, thread] { attend(thread); });
    } catch (const std::system_error&) { // the system has no more: those there are do all the work
    }
}

ThreadTeam::~ThreadTeam() {
    {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_state.fetch_or(endBit);
    }
    m_news.notify_all();
    for (std::thread& thread : m_threads)
        thread.join();
}

void ThreadTeam::runJob(Job job) {
    job.threads = std::min({job.threads, job.parts, size()});
    if (job.threads <= 1) {
        for (std::size_t part = 0; part < job.parts; ++part)
            job.call(job.context, part);
        return;
    }
    open(job);
    work(0);
    closeAndWait();
}

// Job and queues are plain data. They are written while nobody is inside, since the job before was closed and
// waited for, and become visible to who enters by the store that opens the job.
//
// No thread may sleep through it. The opener writes the state, then reads how many sleep; a thread that goes
// to sleep adds itself to them, then reads the state. All four are sequentially consistent, so that at least
// one of the two sees the other. A thread that has looked, but does not sleep yet, holds the mutex: to lock
// it once waits for that thread.
void ThreadTeam::open(const Job& job) {
    m_job = job;
    for (std::size_t thread = 0; thread < job.threads; ++thread) {
        m_queues[thread].next.store(job.parts * thread / job.threads, std::memory_order_relaxed);
        m_queues[thread].end = job.parts * (thread + 1) / job.threads;
    }
    m_state.store(((m_state.load() & ~(insideMask | openBit)) + jobUnit) | openBit);
    if (m_sleepers.load() == 0) return;
    { const std::lock_guard<std::mutex> lock(m_mutex); }
    m_news.notify_all();
}

/// Nothing is left to begin: nobody may enter any more, and those inside end what they have begun.
void ThreadTeam::closeAndWait() {
    m_state.fetch_and(~openBit);
    const auto isEmpty = [this] { return (m_state.load(std::memory_order_acquire) & insideMask) == 0; };
    while (!waitBriefly(yields, isEmpty)) {
    }
}

// A thread beyond those that the job is worth leaves at once: it has no queue.
bool ThreadTeam::enter(std::uint64_t seen, std::size_t thread) {
    while (seen & openBit) {
        if (!m_state.compare_exchange_weak(seen, seen + 1, std::memory_order_acquire)) continue;
        if (thread < m_job.threads) return true;
        leave();
        return false;
    }
    return false;
}

void ThreadTeam::leave() {
    m_state.fetch_sub(1, std::memory_order_release);
}

// First its own queue, then what the others have not begun: a part is taken by one addition, by whoever
// comes. The plain look before it keeps threads that only find empty queues from taking the cache line from
// one that works, and the number from growing without end.
void ThreadTeam::work(std::size_t thread) {
    for (std::size_t i = 0; i < m_job.threads; ++i) {
        Queue& queue = m_queues[(thread + i) % m_job.threads];
        while (queue.next.load(std::memory_order_relaxed) < queue.end) {
            const std::size_t part = queue.next.fetch_add(1, std::memory_order_relaxed);
            if (part < queue.end) m_job.call(m_job.context, part);
        }
    }
}

void ThreadTeam::attend(std::size_t thread) {
    std::uint64_t seen = 0;
    while (true) {
        const std::uint64_t state = waitForNews(seen);
        if (state & endBit) return;
        seen = state;
        if (!enter(state, thread)) continue;
        work(thread);
        leave();
    }
}

/// The state once it is another job than the one last seen.
std::uint64_t ThreadTeam::waitForNews(std::uint64_t seen) {
    std::uint64_t state = 0;
    const auto isNew = [&] {
        state = m_state.load();
        return state / jobUnit != seen / jobUnit || (state & endBit);
    };
    if (waitBriefly(yields, isNew)) return state;
    std::unique_lock<std::mutex> lock(m_mutex);
    ++m_sleepers;
    m_news.wait(lock, isNew);
    --m_sleepers;
    return state;
}

} // namespace esm
