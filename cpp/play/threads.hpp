// A pool of threads that share numbered pieces of work. Which thread takes which piece is not
// determined, so the result of a piece must depend on its number alone. For example
//
//     Workers workers(4);
//     workers.run(n, [&](std::int64_t piece, int thread) {
//         out[piece] = solve(piece, memory[thread]);
//     });
//
// A process may be forked while it has a pool. The child has no thread but the one that forked, so
// the child abandons its copy of the pool and starts threads of its own when they are needed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>

namespace matrixworld {

// The number of forks that lie between this process and the one that loaded the engine. It differs
// between a process and its children.
int fork_depth();

// Enough worlds that taking a piece costs nothing, few enough that threads end at the same time.
constexpr std::int64_t kWorldsPerPiece = 16;

class Workers {
  public:
    using Work = std::function<void(std::int64_t piece, int thread)>;
    // Called now and then by the thread that called `run`, for example to look for signals. If it
    // throws, the work stops.
    using Poll = std::function<void()>;

    // The calling thread works, too, so one fewer is started, by the first `run`.
    explicit Workers(int n_threads) : n_threads_(std::max(n_threads, 1)) {}

    int n_threads() const { return n_threads_; }

    // Calls work(piece, thread) for every piece below n_pieces, and rethrows the first exception.
    void run(std::int64_t n_pieces, const Work& work, const Poll& poll = {});

    // To be called by long work at short intervals: calls `poll` about every 50 ms, and throws if
    // the work is to stop.
    void check(int thread);

  private:
    class Pool;
    struct DeletePool {
        void operator()(Pool* pool) const;
    };

    int n_threads_;
    std::unique_ptr<Pool, DeletePool> pool_;
};

// Workers that the calling thread keeps for its next work: to start threads takes as long as many
// rounds. Work within work, by a signal handler, gets workers of its own. For example
//
//     const KeptWorkers kept(4);
//     (*kept).run(n, work);
class KeptWorkers {
  public:
    explicit KeptWorkers(int n_threads);
    ~KeptWorkers();

    KeptWorkers(const KeptWorkers&) = delete;
    KeptWorkers& operator=(const KeptWorkers&) = delete;

    Workers& operator*() const { return *workers_; }

  private:
    std::unique_ptr<Workers> workers_;
};

}  // namespace matrixworld
