// One world: a reset, then rounds. Under simultaneous play a round is one turn in which all agents
// act; under swarm turns it is the pursuers' turn and then the evaders' turn; under agent turns
// every agent has its own. A turn runs the five stages of a step: the resolver's four, then
// `settle`, the captures, the rewards and the end of the episode.
//
//     const auto setup = std::make_shared<const Setup>(config);   // shared by all worlds
//     Scratch scratch(*setup);                                     // one for each thread
//     World world(setup);
//     world.reset({seed, episode}, scratch);
//     while (!world.over()) world.step(actions, scratch);
//     world.leave(scratch);                                        // free for another world
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "game/memories.hpp"
#include "game/occupancy.hpp"
#include "game/resolve.hpp"
#include "game/snapshot.hpp"
#include "game/terrain.hpp"
#include "grid/grid.hpp"
#include "grid/random.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

// What the caller fixes at a reset. What is left empty is drawn at random.
struct Placement {
    std::vector<int> pursuers;  // (row, col) pairs, flat
    std::vector<int> evaders;   // (row, col) pairs, flat
    ByteArray map;              // (rows * cols)
};

// A configuration, with what all its worlds share.
struct Setup {
    explicit Setup(Config config);

    Config config;
    Grid grid;
    std::shared_ptr<const Terrain> terrain;  // with the obstacles of the configured map
    float penalties[kTeams][1 << kKinds];    // summed, by set of kinds as bits
};

// Memory that a world needs while it is played: one for each thread serves any number of worlds of
// one configuration, so that a world itself stays small.
struct Scratch {
    explicit Scratch(const Setup& setup, bool for_networks = true);

    Occupancy occupancy;
    Resolver resolver;
    IntArray order;  // every cell once; a reset shuffles the cells it needs and restores them
    std::vector<int> swaps;  // what that reset swapped
    // Under agent turns: the participants of this turn and of the last one, the actor's cell and
    // its target.
    std::vector<int> participants;
    std::vector<int> last_participants;
    int actor_cell = 0;
    int actor_target = 0;
};

class World {
  public:
    explicit World(std::shared_ptr<const Setup> setup);

    // Starts episode `key` and enters the agents. Precondition: no world has entered the scratch.
    // Throws std::invalid_argument for a placement that does not fit, before anything is changed.
    void reset(EpisodeKey key, Scratch& scratch, const Placement& placement = {});

    // Returns a snapshot, or restores one and enters the agents as a reset does. A restored world
    // goes on as the original does. Throws std::invalid_argument, before anything is changed, for a
    // snapshot with entries of other sizes or values than this configuration has.
    Snapshot snapshot(const Scratch& scratch) const;
    void restore(const Snapshot& snapshot, Scratch& scratch);

    // Continues from a moment between two turns of which only this is known: where agents stand, by
    // agent, kGone when gone; which evaders count as captured; the episode, and how many of its
    // steps were played. What is
    // left out decides rewards and reports only. Nothing is checked or allocated: who enumerates states calls it for each.
    // Preconditions: the world was reset before; no world has entered the scratch.
    void put(const IntArray& cells, const ByteArray& captured, EpisodeKey key, int steps,
             Scratch& scratch);

    // Enters the agents into the occupancy of the scratch, or removes them from it. A world is
    // played and observed between the two.
    void enter(Scratch& scratch) const;
    void leave(Scratch& scratch) const;

    // Do agents act one at a time? Otherwise every turn affects all agents and makes all
    // reservations anew: then a world may be played without entering, and has entered afterwards.
    bool one_by_one() const { return config().rules.interaction == Interaction::AgentTurns; }

    // Plays one round with the actions that all agents have committed. `log` collects the
    // conflicts.
    void step(const std::uint8_t* actions, Scratch& scratch, std::vector<Conflict>* log = nullptr);

    // The same, turn by turn, for policies that observe before their own turn.
    int n_turns() const;
    void begin_round();
    // Sets the range [first, last) of the agents that act in a turn.
    void actors(int turn, int& first, int& last) const;
    void play_turn(int turn, const std::uint8_t* actions, Scratch& scratch,
                   std::vector<Conflict>* log = nullptr);
    void end_round();

    const Config& config() const { return setup_->config; }
    const Grid& grid() const { return setup_->grid; }
    Team team(int agent) const {
        return agent < config().n_pursuers ? Team::Pursuer : Team::Evader;
    }
    bool alive(int agent) const { return cell_[agent] != kGone; }
    int cell(int agent) const { return cell_[agent]; }
    const IntArray& cells() const { return cell_; }             // by agent
    const IntArray& last_cells() const { return last_cell_; }   // by agent: where it disappeared
    const std::vector<int>& living() const { return living_; }  // agents, ascending
    int n_living(Team team) const { return n_living_[static_cast<int>(team)]; }
    const Terrain& terrain() const { return *terrain_; }
    const std::shared_ptr<const Terrain>& shared_terrain() const { return terrain_; }
    // Does the episode have obstacles of its own, which no other world shares?
    bool has_own_terrain() const { return terrain_ != setup_->terrain; }
    // May teammates be on one cell? False only after a turn in which no two agents met.
    bool may_overlap() const { return may_overlap_; }

    // By evader. The captors of an evader that was removed are counted in the step of its capture
    // and are 0 afterwards.
    const ByteArray& captured() const { return captured_; }
    const ByteArray& ever_captured() const { return ever_captured_; }
    const IntArray& captors() const { return captors_; }
    // Evaders that count as captured: under occupation those captured at any time, under surround
    // those captured at this moment.
    int n_captured() const { return n_captured_; }
    bool counts_as_captured(int evader) const;
    int n_ever_captured() const { return static_cast<int>(ever_captured_.cast<int>().sum()); }

    const FloatArray& rewards() const { return rewards_; }          // by agent, of the last round
    Flags report(int agent) const { return report_[agent]; }        // involved and at_fault bits
    const std::vector<int>& reported() const { return reported_; }  // agents with any of them
    // Did each agent that acted receive the reward of a step, and no agent any other? False where
    // that is not known.
    bool paid_steps_only() const {
        return n_turns() == 1 && reported_.empty() && payable_captures_.empty() && !teams_adjacent_;
    }
    int steps() const { return steps_; }
    bool terminated() const { return terminated_; }
    bool truncated() const { return truncated_; }
    bool over() const { return terminated_ || truncated_; }
    EpisodeKey key() const { return key_; }
    // What policies keep for the agents; a copy of the world has a copy of it.
    Memories& memories() { return memories_; }
    const Memories& memories() const { return memories_; }

    // Throws std::invalid_argument where a reset with this placement would.
    void check(const Placement& placement) const;

  private:
    void check(const Snapshot& snapshot) const;
    template <typename AnyWorld, typename AnySnapshot, typename Copy>
    static void copy_members(AnyWorld& world, AnySnapshot& snapshot, Copy copy);
    void place_living(const IntArray& cells, Scratch& scratch);
    void begin_episode(EpisodeKey key);
    void set_terrain(const ByteArray& map);
    void count_captures();
    void place_given(const std::vector<int>& positions, int first, Scratch& scratch);
    void place_at_random(const Placement& given, Scratch& scratch);
    void place(int agent, int cell, Scratch& scratch);

    const std::vector<int>& choose_participants(int actor, int action, Scratch& scratch) const;
    Turn make_turn(const std::vector<int>& participants, const std::uint8_t* actions, int first,
                   int last, int number) const;
    void settle(const Turn& turn, Scratch& scratch);
    void remove(int agent, int cell);
    void update_living();
    void judge_captures(const Turn& turn, Scratch& scratch);
    void judge_contacts(const Turn& turn, Scratch& scratch);
    void add_captors_on_cell(int evader, const Turn& turn, Scratch& scratch);
    void judge_surround(int evader, Scratch& scratch);
    void find_affected_evaders(const Turn& turn, const Scratch& scratch);
    void add_affected_beside(int cell, const Scratch& scratch);
    void add_affected(int agent);
    void add_captor(int evader, int pursuer);
    void set_captured(int evader, bool captured);
    void clear_capture(int evader);
    void pay_captures();
    void remove_captured(Scratch& scratch);
    void pay_actors(const Turn& turn, const Scratch& scratch);
    bool teams_are_adjacent(const Turn& turn, const Scratch& scratch) const;
    void report_and_penalize(const Scratch& scratch);
    void judge_end();

    int evader_number(int agent) const { return agent - config().n_pursuers; }
    int evader_agent(int evader) const { return config().n_pursuers + evader; }
    float pay(const float (&by_team)[kTeams], int agent) const {
        return by_team[static_cast<int>(team(agent))];
    }

    std::shared_ptr<const Setup> setup_;
    std::shared_ptr<const Terrain> terrain_;
    EpisodeKey key_;

    IntArray cell_;            // by agent; kGone when gone
    IntArray last_cell_;       // by agent: the cell where it disappeared
    std::vector<int> living_;  // agents, ascending
    int n_living_[kTeams] = {0, 0};
    int n_captured_ = 0;    // evaders that count as captured
    int n_uncaptured_ = 0;  // living evaders that do not; at 0 the episode ends

    ByteArray captured_;                                 // by evader
    ByteArray ever_captured_;                            // by evader
    ByteArray capture_paid_;                             // by evader
    IntArray captors_;                                   // by evader
    std::vector<std::pair<int, int>> payable_captures_;  // (evader, captor) of this turn
    std::vector<int> affected_;  // evaders whose capture this turn can change
    ByteArray is_affected_;      // by evader
    bool first_turn_ = false;    // no turn of this round has been played
    bool may_overlap_ = false;
    bool teams_adjacent_ = false;  // false: after this turn no agent is beside an adversary

    FloatArray rewards_;
    Eigen::Array<Flags, Eigen::Dynamic, 1> report_;
    std::vector<int> reported_;  // agents whose report is not 0
    int steps_ = 0;
    bool terminated_ = false;
    bool truncated_ = false;
    Memories memories_;
};

}  // namespace matrixworld
