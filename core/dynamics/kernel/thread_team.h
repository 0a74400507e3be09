#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace esm {

/// Threads that stay and share pieces of work too short to start threads for. They wait for the next piece by
/// spinning for some microseconds, then giving way to others, then sleeping: an idle team costs nothing.
///
/// Every thread has parts of its own, always the same ones, so that their data stays near it. Who is through
/// with his own takes what nobody has begun: a thread that the machine gives no time holds nobody up.
class ThreadTeam {
public:
    /// The caller of run() is one of the threads; 0 takes as many as the machine runs at once. Where the
    /// system gives fewer, the team is smaller.
    explicit ThreadTeam(std::size_t threads = 0);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam&) = delete;
    ThreadTeam& operator=(const ThreadTeam&) = delete;

    std::size_t size() const { return m_threads.size() + 1; }

    /// Calls `work(part)` once for every part below `parts` and returns when all calls have. By at most
    /// `mostThreads` threads of the team; one is a plain loop. Not from two threads at once, nor from within
    /// `work`, which must not throw.
    template<class Work> void run(std::size_t parts, Work&& work, std::size_t mostThreads = SIZE_MAX) {
        const auto call = [](void* context, std::size_t part) {
            (*static_cast<std::remove_reference_t<Work>*>(context))(part);
        };
        runJob({call, const_cast<void*>(static_cast<const void*>(&work)), parts, mostThreads});
    }

private:
    struct Job {
        void (*call)(void* context, std::size_t part);
        void* context;
        std::size_t parts, threads;
    };
    /// The parts that belong to one thread, on a cache line of their own.
    struct alignas(64) Queue {
        std::atomic<std::size_t> next{0};
        std::size_t end = 0;
    };

    void runJob(Job job);
    void open(const Job& job);
    void closeAndWait();
    bool enter(std::uint64_t seen, std::size_t thread);
    void leave();
    void work(std::size_t thread);
    void attend(std::size_t thread);
    std::uint64_t waitForNews(std::uint64_t seen);

    /// Number of the job, whether it is open, and how many threads other than the caller's are inside.
    alignas(64) std::atomic<std::uint64_t> m_state{0};
    Job m_job{};
    std::vector<Queue> m_queues;

    std::mutex m_mutex; ///< of those who sleep
    std::condition_variable m_news;
    std::atomic<std::size_t> m_sleepers{0};
    std::vector<std::thread> m_threads;
};

} // namespace esm
