// All states of a small world, with what every joint action leads to, and one step of backward
// induction over them. The engine's own world is put into each state and plays each action: no rule
// is written down here.
//
// A state is a moment before a turn: which cells the agents are on, who is gone, and which evaders
// count as captured. Nothing else matters for what follows: rewards and reports are written, never
// read, and steps are counted by the caller. Where all members of a team act at once, numbers cannot
// matter, and agents of a team are sorted. Where agents act one at a time, their numbers are the
// order of their turns, and are kept; and so they are where the caller asks for it, such as for agents
// that remember something.
//
// Each turn of a round has its own states, numbered from 0. In every turn the states 0 to n_evaders
// are the ends: k is every end of an episode at which k evaders count as captured. The others are
// those that some episode reaches which starts on distinct free cells.
//
// A team is one player. Its joint actions are numbered with the first agent that acts as the highest
// digit; a team that does not act has one, 0.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "game/world.hpp"
#include "play/policy.hpp"
#include "play/threads.hpp"

namespace matrixworld {

class States {
  public:
    // Called by long work about every 50 ms with the share of it that is done, from 0 to 1; if it
    // throws, the work stops.
    using Poll = std::function<void(double share)>;

    // Precondition: no obstacles are drawn at a reset. Throws std::invalid_argument where more joint
    // places of the agents exist than 31 bits count. Memory for `expected` states of each turn is
    // set aside at once: vectors that grow would be copied. `numbered` agents are never sorted.
    States(std::shared_ptr<const Setup> setup, int n_threads, const Poll& poll = {},
           std::size_t expected = 0, bool numbered = false);

    const Setup& setup() const { return *setup_; }
    int n_turns() const { return static_cast<int>(layers_.size()); }
    int n_ends() const { return setup_->config.n_evaders + 1; }
    std::int64_t n_states(int turn) const {
        return static_cast<std::int64_t>(layers_[turn].codes.size());
    }
    // The joint actions of a team in a turn.
    int n_joint(int turn, Team team) const { return layers_[turn].n_joint[static_cast<int>(team)]; }
    // (n_states, pursuers' joint actions, evaders' joint actions): states of the next turn, which
    // after the last turn is the first of the next round. An end leads to itself.
    const std::vector<std::int32_t>& successors(int turn) const { return layers_[turn].successors; }
    // States of the first turn. An episode that draws its start begins in each equally often.
    const std::vector<std::int32_t>& starts() const { return starts_; }

    // Writes a state: for each agent its index among the rows * cols cells, kGone when gone; and for
    // each evader whether it counts as captured. An end has no agents.
    void describe(int turn, std::int64_t state, int* cells, std::uint8_t* captured) const;

    // The state in which a world is before a turn, -1 if it is none of them; and the agents in the
    // order of the state: order[i] is the agent that the state calls i.
    std::int64_t find(const World& world, int turn, std::vector<int>& order) const;

    // One step of backward induction: the values of a turn's states from those of the next turn's.
    // A team whose probabilities, (n_states, its joint actions), are given plays by them; otherwise
    // it plays its best, with the probabilities that are written where `chosen` is not null (only of
    // teams that have none given). Returns the largest gap of the games (see GameValue).
    struct Play {
        const double* given[kTeams] = {nullptr, nullptr};
        double* chosen[kTeams] = {nullptr, nullptr};
    };
    double backup(int turn, const double* next, double* values, const Play& play, int n_threads,
                  const Poll& poll = {}) const;

    // A step of an episode: both may decide what a policy does in a state.
    struct When {
        EpisodeKey key;
        int step = 0;
    };
    // The probabilities with which candidate 0 of a team plays, (n_states, its joint actions). An end
    // has action 0. Throws as Policy::weigh does.
    void weigh(int turn, Team team, const Candidates& candidates, When when, double* out,
               int n_threads, const Poll& poll = {}) const;

    // The named inputs of one agent in each of some states, (n, moves, kInputs). It must be alive in
    // them.
    void look(int turn, int agent, When when, const std::int32_t* states, std::size_t n,
              float* out) const;

  private:
    using Code = std::int32_t;

    struct Layer {
        std::vector<Code> codes;  // by state
        std::vector<std::int32_t> successors;
        std::vector<std::int32_t> numbers;  // by code: its state, or -1
        int first = 0;                      // the agents that act are [first, last)
        int last = 0;
        int n_joint[kTeams] = {1, 1};
    };

    // An agent's place is a digit of the code: 0 gone, for an evader 1 gone after its capture, then
    // the cells, for an evader each twice: free or captured.
    int n_places(Team team) const;
    Code code_of(const std::vector<int>& places) const;
    void place(Code code, std::vector<int>& places) const;
    void places_in(const World& world, std::vector<int>& places) const;
    void sort(std::vector<int>& places) const;
    Team team(int agent) const {
        return agent < setup_->config.n_pursuers ? Team::Pursuer : Team::Evader;
    }

    struct Memory;
    void put(const std::vector<int>& places, Memory& memory, When when) const;
    std::int32_t number(Layer& layer, Code code);
    void add_starts(int agent, std::vector<int>& places);
    void expand(int turn, std::size_t first, int n_threads, const Poll& poll);
    void play_all(int turn, std::size_t state, Memory& memory, std::int32_t* out) const;
    static void for_each_state(std::size_t first, std::size_t last, int n_threads, const Poll& poll,
                               const std::function<void(std::size_t state, int thread)>& work);

    std::shared_ptr<const Setup> setup_;
    bool sorted_;
    int n_cells_;
    std::vector<int> cell_of_;   // by index among rows * cols: the cell on the engine's frame
    std::vector<int> index_of_;  // the other way round
    std::vector<Layer> layers_;
    std::vector<std::int32_t> starts_;
};

}  // namespace matrixworld
