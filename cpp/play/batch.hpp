// W worlds of one configuration, stepped together by a few threads into buffers of the caller.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "game/world.hpp"
#include "play/buffers.hpp"
#include "play/episode_statistics.hpp"
#include "play/threads.hpp"

namespace matrixworld {

// What becomes of a world whose episode has ended.
enum class Autoreset : std::uint8_t {
    Disabled,  // it stays as it is, with rewards of 0, until it is reset
    NextStep,  // the next step ignores its actions and starts its seed's next episode instead
    SameStep,  // the very step that ended it goes on to start its seed's next episode
};

// Checks the actions (A,) of a world's living agents [first, last) and writes them to `committed`;
// the others are not looked at. Throws std::invalid_argument naming world, agent and value.
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

// Are all of n values at least 0 and below a limit?
template <typename Integer>
bool all_below(int limit, const Integer* values, std::size_t n) {
    using Unsigned = std::make_unsigned_t<Integer>;  // in which negative numbers are large
    Unsigned most = 0;
    for (std::size_t i = 0; i < n; ++i) most = std::max(most, static_cast<Unsigned>(values[i]));
    return most < static_cast<Unsigned>(limit);
}

class Batch {
  public:
    Batch(std::shared_ptr<const Setup> setup, int n_worlds, int n_threads, Autoreset autoreset);

    // World w starts episode `episode` of seeds[w], or its own seed's next episode where `seeds` is
    // null; only those with mask[w] where a mask is given. `placements` is empty, one for all
    // worlds, or one for each. Throws std::invalid_argument, before anything is changed, for a
    // placement that does not fit.
    void reset(const std::uint64_t* seeds, std::uint64_t episode, const std::uint8_t* mask,
               const std::vector<Placement>& placements, const Buffers& buffers);

    // One round of every world that is not over, with actions (W, A); see `Autoreset` for the
    // others. Where a world is reset in the very step that ended it, what tells of the step
    // (rewards, terminated, captures, ...) is still of the ended episode, what tells of the moment
    // (positions, alive, steps, views, state) of the new one.
    // Throws std::invalid_argument, before anything is changed, for an action out of range of a
    // living agent in a world that is not over.
    template <typename Integer>
    void step(const Integer* actions, const Buffers& buffers) {
        commit(actions);
        play(buffers);
    }

    int n_worlds() const { return static_cast<int>(worlds_.size()); }
    const Setup& setup() const { return *setup_; }

    // Where world w is.
    Snapshot snapshot(int w) const { return worlds_[w].snapshot(workspaces_[0]->scratch); }

  private:
    // Where a thread plays worlds and looks at them.
    struct Workspace {
        explicit Workspace(const Setup& setup) : scratch(setup, false), observer(setup) {}

        Scratch scratch;
        Observer observer;
    };

    template <typename Integer>
    void commit(const Integer* actions);
    void play(const Buffers& buffers);
    template <typename Play>
    void for_each_world(Play play);
    void play(World& world, std::size_t number, Workspace& workspace, const Buffers& buffers);
    void begin(World& world, std::size_t number, EpisodeKey key, Scratch& scratch,
               const Placement& placement);
    void finish(World& world, std::size_t number, Workspace& workspace, const Buffers& buffers);

    std::shared_ptr<const Setup> setup_;
    Autoreset autoreset_;
    std::vector<World> worlds_;
    std::vector<StatisticsAccumulator> statistics_;
    std::vector<std::uint8_t> actions_;  // (W, A)
    Workers workers_;
    std::vector<std::unique_ptr<Workspace>> workspaces_;  // one a thread
};

template <typename Integer>
void Batch::commit(const Integer* actions) {
    const std::size_t n_agents = static_cast<std::size_t>(setup_->config.n_agents());
    if (all_below(setup_->config.n_actions(), actions, actions_.size())) {
        std::copy_n(actions, actions_.size(), actions_.begin());
        return;
    }
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
        if (worlds_[w].over()) continue;
        commit_actions(worlds_[w], w, 0, static_cast<int>(n_agents), actions + w * n_agents,
                       actions_.data() + w * n_agents);
    }
}

}  // namespace matrixworld
