// A pool of threads that share numbered pieces of work. Which thread takes which piece is not
// determined, so the result of a piece must depend on its number alone. For example
//
//     Workers workers(4);
//     workers.run(n, [&](int piece, int thread) { out[piece] = solve(piece, memory[thread]); });
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace matrixworld {

class Workers {
  public:
    // 0 threads: as many as the machine has cores. The calling thread works, too, so one fewer is
    // started.
    explicit Workers(int n_threads) {
        const int n =
            n_threads > 0 ? n_threads : static_cast<int>(std::thread::hardware_concurrency());
        try {
            for (int i = 1; i < n; ++i) threads_.emplace_back([this, i] { wait_for_work(i); });
        } catch (...) {  // the system has no more threads: join those that have started
            stop();
            throw;
        }
    }

    ~Workers() { stop(); }

    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int n_threads() const { return static_cast<int>(threads_.size()) + 1; }

    // Calls work(piece, thread) for every piece below n_pieces, and rethrows the first exception.
    void run(int n_pieces, const std::function<void(int, int)>& work) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work_ = &work;
            n_pieces_ = n_pieces;
            next_ = 0;
            busy_ = static_cast<int>(threads_.size());
            failure_ = nullptr;
            ++job_;  // a sleeping thread compares this number, so no spurious wake-up works twice
        }
        start_.notify_all();
        take_pieces(0);
        // `work` is the caller's: it must not return before all threads have stopped using it.
        std::unique_lock<std::mutex> lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
        if (failure_) std::rethrow_exception(failure_);
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

    void wait_for_work(int thread) {
        long seen = 0;
        std::unique_lock<std::mutex> lock(mutex_);
        while (true) {
            start_.wait(lock, [&] { return stop_ || job_ != seen; });
            if (stop_) return;
            seen = job_;
            lock.unlock();
            take_pieces(thread);
            lock.lock();
            if (--busy_ == 0) done_.notify_one();
        }
    }

    void take_pieces(int thread) {
        try {
            for (int piece = next_++; piece < n_pieces_; piece = next_++) (*work_)(piece, thread);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            next_ = n_pieces_;  // no thread takes another piece
        }
    }

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable start_;
    std::condition_variable done_;
    const std::function<void(int, int)>* work_ = nullptr;
    std::atomic<int> next_{0};
    int n_pieces_ = 0;
    int busy_ = 0;
    long job_ = 0;
    bool stop_ = false;
    std::exception_ptr failure_;
};

}  // namespace matrixworld
