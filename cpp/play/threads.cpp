#include "play/threads.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#endif

namespace matrixworld {

namespace {

using Clock = std::chrono::steady_clock;

// A user notices a delay from about a tenth of a second.
constexpr std::chrono::milliseconds kPollInterval{50};

// How long a thread that waits looks again and again before it sleeps. Waking a thread takes longer
// than a step of 64 worlds; a longer look would burn the time of a neighbour's core.
constexpr std::chrono::microseconds kSpin{20};

template <typename Condition>
void spin_until(Condition is_done) {
    const Clock::time_point end = Clock::now() + kSpin;
    while (!is_done() && Clock::now() < end) std::this_thread::yield();
}

std::atomic<int> n_forks{0};
#if defined(__unix__) || defined(__APPLE__)
[[maybe_unused]] const int registered = pthread_atfork(nullptr, nullptr, [] { ++n_forks; });
#endif

// Ends a piece of work because another piece has failed.
struct Stopped {};

// Tells when the poll interval has passed. Reading the clock may take as long as a step of a small
// world, so most calls only count: the clock is read at every second call, every fourth, ... for as
// long as the readings are less than a millisecond apart.
class Timer {
  public:
    bool due() {
        if (++n_calls_ < stride_) return false;
        const Clock::time_point now = Clock::now();
        n_calls_ = 0;
        stride_ = now - read_ < std::chrono::milliseconds(1) ? 2 * stride_ : 1;
        read_ = now;
        if (now < next_) return false;
        next_ = now + kPollInterval;
        return true;
    }

  private:
    int n_calls_ = 0;
    int stride_ = 1;
    Clock::time_point read_ = Clock::now();
    Clock::time_point next_ = read_ + kPollInterval;
};

}  // namespace

int fork_depth() { return n_forks; }

// ---- The threads ------------------------------------------------------------------------------

class Workers::Pool {
  public:
    explicit Pool(int n_threads) {
        try {
            for (int i = 1; i < n_threads; ++i) threads_.emplace_back([this, i] { wait(i); });
        } catch (...) {  // the system has no more threads: join those that have started
            stop();
            throw;
        }
    }

    ~Pool() { stop(); }

    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    // Was the pool made by a process of which this one is a forked child?
    bool is_inherited() const { return fork_depth_ != fork_depth(); }

    void run(std::int64_t n_pieces, const Work& work, const Poll& poll) {
        // No thread is woken for nothing.
        const std::int64_t n_helpers =
            std::min(n_pieces - 1, static_cast<std::int64_t>(threads_.size()));
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work_ = &work;
            poll_ = poll ? &poll : nullptr;
            if (poll_) timer_ = Timer();
            n_pieces_ = n_pieces;
            next_ = 0;
            n_busy_ = n_helpers_ = static_cast<int>(std::max<std::int64_t>(n_helpers, 0));
            failure_ = nullptr;
            failed_ = false;
            // A waiting thread compares this number, so no spurious wake-up works twice.
            if (n_helpers_ > 0) ++job_;
        }
        if (n_helpers_ > 0) start_.notify_all();
        take_pieces(0);
        wait_for_others();
        // Not kept: an exception of Python must not outlive the interpreter.
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

    void check(int thread) {
        if (failed_.load(std::memory_order_relaxed)) throw Stopped();
        if (thread == 0 && poll_ && timer_.due()) (*poll_)();
    }

  private:
    void stop() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            stop_ = true;
        }
        start_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

    // The life of a started thread.
    void wait(int thread) {
        long seen = 0;
        while (true) {
            spin_until([&] { return job_ != seen; });
            std::unique_lock<std::mutex> lock(mutex_);
            start_.wait(lock, [&] { return stop_ || job_ != seen; });
            if (stop_) return;
            seen = job_;
            if (thread > n_helpers_) continue;
            lock.unlock();
            take_pieces(thread);
            lock.lock();
            if (--n_busy_ == 0) done_.notify_one();
        }
    }

    void take_pieces(int thread) {
        try {
            for (std::int64_t piece = next_++; piece < n_pieces_; piece = next_++) {
                (*work_)(piece, thread);
            }
        } catch (const Stopped&) {
        } catch (...) {
            fail();
        }
    }

    // Stops the work because of the exception that is being handled.
    void fail() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        failed_ = true;
        next_ = n_pieces_;  // no thread takes another piece
    }

    // `work` is the caller's: `run` must not return before all threads have stopped using it.
    void wait_for_others() {
        spin_until([&] { return n_busy_ == 0; });
        std::unique_lock<std::mutex> lock(mutex_);
        const auto all_done = [this] { return n_busy_ == 0; };
        if (!poll_) return done_.wait(lock, all_done);
        while (!done_.wait_for(lock, kPollInterval, all_done)) {
            if (failed_) continue;
            lock.unlock();
            try {
                (*poll_)();
            } catch (...) {
                fail();
            }
            lock.lock();
        }
    }

    const int fork_depth_ = fork_depth();
    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable start_;
    std::condition_variable done_;
    const Work* work_ = nullptr;
    const Poll* poll_ = nullptr;  // null: nothing to poll
    Timer timer_;                 // of the calling thread
    std::atomic<std::int64_t> next_{0};
    std::int64_t n_pieces_ = 0;
    int n_helpers_ = 0;           // threads that work besides the caller; the first ones
    std::atomic<int> n_busy_{0};  // of them
    std::atomic<long> job_{0};
    bool stop_ = false;
    std::exception_ptr failure_;
    std::atomic<bool> failed_{false};
};

// An inherited pool is left as it is: its threads do not exist, so they cannot be joined, and its
// mutex may be locked for ever. Its memory is the price of a fork.
void Workers::DeletePool::operator()(Pool* pool) const {
    if (!pool->is_inherited()) delete pool;
}

void Workers::run(std::int64_t n_pieces, const Work& work, const Poll& poll) {
    if (!pool_ || pool_->is_inherited()) pool_.reset(new Pool(n_threads_));
    pool_->run(n_pieces, work, poll);
}

void Workers::check(int thread) { pool_->check(thread); }

namespace {

// Those of the calling thread that have no work. Null: none, or they are at work.
thread_local std::unique_ptr<Workers> idle;

}  // namespace

KeptWorkers::KeptWorkers(int n_threads) : workers_(std::move(idle)) {
    if (!workers_ || workers_->n_threads() != std::max(n_threads, 1)) {
        workers_ = std::make_unique<Workers>(n_threads);
    }
}

KeptWorkers::~KeptWorkers() { idle = std::move(workers_); }

}  // namespace matrixworld
