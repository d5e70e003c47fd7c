// W worlds of one configuration, stepped together by a few threads into buffers of the caller.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "parallel.hpp"
#include "world.hpp"

namespace matrixworld {

// Where to write what, by world and then by agent or evader; nothing is written to a null one.
struct Buffers {
    std::int32_t* positions = nullptr;      // (W, A, 2) row, col; -1, -1 when gone
    std::uint8_t* alive = nullptr;          // (W, A)
    std::uint8_t* captured = nullptr;       // (W, E)
    std::uint8_t* ever_captured = nullptr;  // (W, E)
    std::int32_t* captors = nullptr;        // (W, E)
    std::uint8_t* involved = nullptr;       // (W, A, 3)
    std::uint8_t* fault = nullptr;          // (W, A, 3)
    float* rewards = nullptr;               // (W, A)
    std::int32_t* steps = nullptr;          // (W,)
    std::uint8_t* terminated = nullptr;     // (W,)
    std::uint8_t* truncated = nullptr;      // (W,)
    std::uint8_t* views = nullptr;          // (W, A, 3, fov, fov)
    std::uint8_t* state = nullptr;          // (W, 3, rows, cols)
};

// Writes one world's share; the agents must be in the occupancy.
void write(const World& world, const Occupancy& occupancy, std::size_t number,
           const Buffers& buffers);

// Checks the actions (A,) of a world's living agents and writes them to `committed`; those of gone
// agents are not looked at. Throws std::invalid_argument naming world, agent and value.
template <typename Integer>
void commit_actions(const World& world, std::size_t number, const Integer* actions,
                    std::uint8_t* committed) {
    const int n_actions = world.config().n_actions();
    for (int a : world.living()) {
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
    Batch(std::shared_ptr<const Setup> setup, int n_worlds, int n_threads, bool autoreset);

    // World w starts episode `episode` of seeds[w].
    void reset(const std::uint64_t* seeds, std::uint64_t episode, const Buffers& buffers);

    // One round of every world that is not over, with actions (W, A); a world that is over stays
    // as it is, with rewards of 0. With autoreset a world that ends starts its seed's next episode
    // at once: rewards, terminated, truncated, involved, fault and captures are still of the
    // ended one; positions, alive, steps, views and state of the new one.
    // Throws std::invalid_argument, before anything is changed, for an action out of range of a
    // living agent in a world that is not over.
    template <typename Integer>
    void step(const Integer* actions, const Buffers& buffers) {
        commit(actions);
        play(buffers);
    }

    int n_worlds() const { return static_cast<int>(worlds_.size()); }
    const Setup& setup() const { return *setup_; }

  private:
    template <typename Integer>
    void commit(const Integer* actions);
    void play(const Buffers& buffers);
    void for_each_world(const std::function<void(World&, std::size_t, Scratch&)>& play);
    void play(World& world, std::size_t number, Scratch& scratch, const Buffers& buffers);

    std::shared_ptr<const Setup> setup_;
    bool autoreset_;
    std::vector<World> worlds_;
    std::vector<std::uint8_t> actions_;  // (W, A)
    Workers workers_;
    std::vector<std::unique_ptr<Scratch>> scratches_;  // one a thread
};

template <typename Integer>
void Batch::commit(const Integer* actions) {
    const std::size_t n_agents = static_cast<std::size_t>(setup_->config.n_agents());
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
        if (worlds_[w].over()) continue;
        commit_actions(worlds_[w], w, actions + w * n_agents, actions_.data() + w * n_agents);
    }
}

}  // namespace matrixworld
