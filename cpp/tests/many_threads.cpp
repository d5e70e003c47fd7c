// Uses the engine from several threads at once, for a build with ThreadSanitizer: rollouts with the
// workers that each caller keeps, batches that share a setup, and one batch that refuses a second
// caller. What they give is what one thread gives.
//
//     many_threads [rounds]
#include <array>
#include <future>

#include "bindings/in_use.hpp"
#include "play/batch.hpp"
#include "scenes.hpp"

namespace matrixworld::tests {
namespace {

// No divisor of the number of combinations, so that rounds play different ones.
constexpr int kStride = 31;
// Calls play(caller) in threads of their own, and throws what one of them threw.
template <typename Play>
void in_threads(int n_callers, Play play) {
    std::vector<std::future<void>> callers;
    for (int caller = 0; caller < n_callers; ++caller) {
        callers.push_back(std::async(std::launch::async, play, caller));
    }
    for (std::future<void>& caller : callers) caller.get();
}

// ---- Rollouts --------------------------------------------------------------------------------

// Three callers play the same matches, each with workers that it keeps or replaces.
void play_rollouts(const Rules& rules, Random& random) {
    const Game game = random_game(rules, 3, 20, random);
    const auto expected = game.play(1);
    in_threads(3, [&](int) {
        for (const int n_threads : {3, 3, 2}) check_same(game.play(n_threads), expected);
    });
}

// Rollouts of the paper's world that take longer than the time between two polls.
std::vector<EpisodeStatistics> play_long(const Workers::Poll& poll) {
    const auto setup = std::make_shared<const Setup>(Config());
    Candidates still;
    still.script = find_script("still");
    return play_matches(setup, still, still, {{0, 0, 7}}, 400, 3, poll);
}

// Ctrl-C: a poll that throws ends the work of all threads, and the workers serve the next call. A
// signal handler may play, too: with workers of its own.
void stop_rollouts() {
    struct Stop {};
    int n_stopped = 0;
    const auto play = [&] {
        if (n_stopped == 2) return;
        try {
            play_long([] { throw Stop(); });
        } catch (const Stop&) {
            ++n_stopped;
        }
    };
    play();
    for (const EpisodeStatistics& statistics : play_long(play)) {
        require(statistics.length == 500, "a rollout goes on after a poll");
    }
    require(n_stopped == 2, "a poll stops a rollout");
}

// A piece that fails ends the others, and the workers serve the next call.
void fail_a_piece() {
    Workers workers(3);
    for (int round = 0; round < 20; ++round) {
        std::vector<int> done(100);
        const auto work = [&](std::int64_t piece, int thread) {
            workers.check(thread);
            if (round % 2 == 0 && piece == 50) throw std::invalid_argument("piece 50");
            done[piece] = 1;
        };
        const bool failed = refused([&] { workers.run(100, work); });
        require(failed == (round % 2 == 0), "a piece that fails is told");
        require(failed || done == std::vector<int>(100, 1), "every piece is done");
    }
}

// ---- Batches ---------------------------------------------------------------------------------

// A batch with its buffers, and the rule for its callers that Python's batches have.
class GuardedBatch {
  public:
    GuardedBatch(const SharedSetup& setup, int n_threads)
        : memory_(setup->config, kWorlds), batch_(setup, kWorlds, n_threads, Autoreset::NextStep) {
        batch_.reset(nullptr, 0, nullptr, {}, memory_.buffers);
    }

    // Returns whether the call was taken.
    bool step() {
        try {
            const InUse::Call call(in_use_);
            const auto n_agents = static_cast<std::size_t>(batch_.setup().config.n_agents());
            const std::vector<std::uint8_t> actions(kWorlds * n_agents, 1);
            batch_.step(actions.data(), memory_.buffers);
            return true;
        } catch (const std::runtime_error&) {
            return false;
        }
    }

    InUse& in_use() { return in_use_; }
    const std::vector<std::vector<std::uint8_t>>& written() const { return memory_.bytes; }

  private:
    static constexpr int kWorlds = 40;

    InUse in_use_;
    Memory memory_;
    Batch batch_;
};

// However short the calls are, no two of them are in progress at once.
void take_turns() {
    InUse in_use;
    long n_inside = 0;
    std::atomic<long> n_taken{0};
    in_threads(3, [&](int) {
        for (int i = 0; i < 20000; ++i) {
            try {
                const InUse::Call call(in_use);
                ++n_inside;
                ++n_taken;
            } catch (const std::runtime_error&) {
                continue;
            }
        }
    });
    require(n_inside == n_taken, "one call at a time");
}

// Two batches of one setup, each stepped by a thread of its own.
void play_two_batches(const Rules& rules, Random& random) {
    const auto setup = std::make_shared<const Setup>(random_config(rules, random));
    std::array<GuardedBatch, 3> batches{GuardedBatch(setup, 2), GuardedBatch(setup, 2),
                                        GuardedBatch(setup, 1)};
    const auto play = [&](int number) {
        for (int step = 0; step < 5; ++step) require(batches[number].step(), "a batch of its own");
    };
    in_threads(2, play);
    play(2);
    require(batches[0].written() == batches[2].written(), "the first batch plays as if alone");
    require(batches[1].written() == batches[2].written(), "the second batch plays as if alone");
}

// Three callers of one batch: whichever of them are refused, the others' steps are played.
void share_one_batch(const Rules& rules, Random& random) {
    const auto setup = std::make_shared<const Setup>(random_config(rules, random));
    GuardedBatch shared(setup, 2);
    {
        const InUse::Call call(shared.in_use());
        in_threads(2, [&](int) { require(!shared.step(), "a second caller is refused"); });
    }
    std::atomic<int> n_played{0};
    in_threads(3, [&](int) {
        for (int step = 0; step < 5; ++step) n_played += shared.step();
    });
    GuardedBatch alone(setup, 1);
    for (int step = 0; step < n_played; ++step) alone.step();
    require(n_played > 0 && shared.written() == alone.written(),
            "only steps that were taken count");
}

}  // namespace
}  // namespace matrixworld::tests

int main(int argc, char** argv) {
    using namespace matrixworld::tests;
    Random random(23);
    run("a stop", stop_rollouts);
    run("a failure", fail_a_piece);
    run("turns", take_turns);
    play_all("rollouts", play_rollouts, argc, argv, random, kStride);
    play_all("two batches", play_two_batches, argc, argv, random, kStride);
    play_all("one batch", share_one_batch, argc, argv, random, kStride);
    return finish("many threads");
}
