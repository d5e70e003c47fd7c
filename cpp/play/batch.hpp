// A batch: W worlds of one configuration, stepped together by several threads, which write their
// output fields into the caller's arrays.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "game/world.hpp"
#include "play/buffers.hpp"
#include "play/episode_statistics.hpp"
#include "play/policy.hpp"
#include "play/threads.hpp"

namespace matrixworld {

// What a batch does with a world whose episode has ended.
enum class Autoreset : std::uint8_t {
    Disabled,  // the world stays as it is, with rewards of 0, until the caller resets it
    NextStep,  // the next step ignores the world's actions and starts its seed's next episode
    SameStep,  // the step that ended the episode also starts the seed's next one
};

// Checks the actions (A,) of a world's living agents [first, last) and writes them to `committed`.
// Other entries are neither checked nor written. Each action is read once. Throws
// std::invalid_argument that names world, agent and value.
template <typename Integer>
void commit_actions(const World& world, std::size_t number, int first, int last,
                    const Integer* actions, std::uint8_t* committed) {
    const int n_actions = world.config().n_actions();
    for (int a : world.living()) {
        if (a < first || a >= last) continue;
        const auto action = static_cast<std::int64_t>(actions[a]);
        if (action < 0 || action >= n_actions) {
            throw std::invalid_argument("actions: expected 0 to " + std::to_string(n_actions - 1) +
                                        ", got " + std::to_string(action) + " (world " +
                                        std::to_string(number) + ", agent " + std::to_string(a) +
                                        ")");
        }
        committed[a] = static_cast<std::uint8_t>(action);
    }
}

class Batch {
  public:
    Batch(std::shared_ptr<const Setup> setup, int n_worlds, int n_threads, Autoreset autoreset);

    // World w starts episode `episode` of seeds[w], or its own seed's next episode if `seeds` is
    // null. If a mask is given, only the worlds with mask[w] start. `placements` is empty, or has
    // one entry for all worlds, or one for each. Throws std::invalid_argument for a placement that
    // does not fit; then no world has changed.
    void reset(const std::uint64_t* seeds, std::uint64_t episode, const std::uint8_t* mask,
               const std::vector<Placement>& placements, const Buffers& buffers);

    // Plays one round, with actions (W, A), in every world that is not over; `Autoreset` says what
    // happens in the others. Throws std::invalid_argument if an agent that acts has an action out
    // of range; then no world has changed. No round may be in progress. Integers are int8_t, uint8_t,
    // int32_t or int64_t.
    template <typename Integer>
    void step(const Integer* actions, const Buffers& buffers) {
        commit(actions, {0, setup_->config.n_agents()});
        play(n_turns(), buffers);
    }

    // Plays the next turn of a round, for policies that observe before their own turn. What belongs
    // to a round, such as its rewards, is written as it is so far; `Autoreset` must be Disabled.
    template <typename Integer>
    void play_turn(const Integer* actions, const Buffers& buffers) {
        commit(actions, actors());
        play(1, buffers);
    }

    int n_turns() const { return worlds_[0].n_turns(); }
    int turn() const { return turn_; }  // the next one of the round, from 0
    // The range [first, last) of the agents that act in it.
    std::pair<int, int> actors() const {
        std::pair<int, int> range;
        worlds_[0].actors(turn_, range.first, range.second);
        return range;
    }

    // Writes the actions that policies[chosen[w]] chooses for the living agents [first, last) of
    // world w, which belong to one team, into actions (W, A). A world stays as it is; its actions do,
    // too, if it is over or its policy has neither network nor script.
    void decide(const std::vector<Candidates>& policies, const std::vector<std::int32_t>& chosen,
                int first, int last, std::int64_t* actions);

    int n_worlds() const { return static_cast<int>(worlds_.size()); }
    const Setup& setup() const { return *setup_; }

    // The state of world w, from which another world can go on.
    Snapshot snapshot(int w) const { return worlds_[w].snapshot(*workspaces_[0]->scratch); }

  private:
    // The memory of one thread. Worlds enter it one after the other to be played and written.
    struct Workspace {
        explicit Workspace(const Setup& setup)
            : scratch(std::make_unique<Scratch>(setup, false)), observer(setup) {
            source.observer = &observer;
        }

        // Brings into the scratch what networks read. Keeping it costs time in each step, so a batch
        // that never decides does without.
        void serve_networks(const Setup& setup) {
            if (serves_networks) return;
            scratch = std::make_unique<Scratch>(setup);
            serves_networks = true;
        }

        std::unique_ptr<Scratch> scratch;
        bool serves_networks = false;
        Observer observer;
        OutputSource source;
    };

    template <typename Integer>
    void commit(const Integer* actions, std::pair<int, int> agents);
    void play(int turns, const Buffers& buffers);
    template <typename Play>
    void for_each_world(Play play);
    void play(int turns, World& world, std::size_t w, Workspace& workspace, const Buffers& buffers);
    void begin(World& world, std::size_t w, EpisodeKey key, Scratch& scratch,
               const Placement& placement = {});
    void advance(int turns, World& world, std::size_t w, Scratch& scratch, const Buffers& buffers);
    void finish(const World& world, std::size_t w, OutputSource& source, const Buffers& buffers);

    std::shared_ptr<const Setup> setup_;
    Autoreset autoreset_;
    std::vector<World> worlds_;
    std::vector<StatisticsAccumulator> statistics_;  // of the worlds' episodes so far
    std::vector<std::uint8_t> actions_;              // (W, A), checked
    int turn_ = 0;                                   // the next one of the round in progress
    std::vector<std::uint8_t> was_over_;             // (W,) before the round
    Workers workers_;
    std::vector<std::unique_ptr<Workspace>> workspaces_;  // by thread
};

}  // namespace matrixworld
