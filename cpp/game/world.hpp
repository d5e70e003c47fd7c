// One world: reset, then rounds of play. Under simultaneous play a round is one turn of
// everybody; under swarm turns the pursuers' turn and then the evaders'; under agent turns one
// turn each. A turn is the five stages: the resolver's four, then `settle` and what follows.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "game/occupancy.hpp"
#include "game/resolve.hpp"
#include "game/snapshot.hpp"
#include "game/terrain.hpp"
#include "grid/grid.hpp"
#include "grid/random.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

// What the caller fixes at a reset; whatever is empty is drawn at random.
struct Placement {
    std::vector<int> pursuers;  // (row, col) pairs, flat
    std::vector<int> evaders;   // (row, col) pairs, flat
    ByteArray map;              // (rows * cols)
};

// A configuration with what all worlds of it share.
struct Setup {
    explicit Setup(Config config);

    Config config;
    Grid grid;
    std::shared_ptr<const Terrain> terrain;  // with the obstacles of the configured map
    float penalties[kTeams][1 << kKinds];    // by the set of kinds that an agent pays for
};

// The scratch memory of one thread, for any number of worlds of one configuration.
struct Scratch {
    explicit Scratch(const Setup& setup, bool for_networks = true);

    Occupancy occupancy;
    Resolver resolver;
    IntArray order;          // every cell of the world once; a reset shuffles and restores it
    std::vector<int> swaps;  // how to restore it
    // Of turns of one agent: those that take part, in this turn and in the one before within the
    // round; where the actor stands and where it heads for.
    std::vector<int> participants;
    std::vector<int> last_participants;
    int here = 0;
    int there = 0;
};

class World {
  public:
    explicit World(std::shared_ptr<const Setup> setup);

    // Starts episode `key` and leaves the agents in the scratch, from which they must have been
    // taken out before. Throws std::invalid_argument for a placement that does not fit, before
    // anything is changed.
    void reset(EpisodeKey key, Scratch& scratch, const Placement& placement = {});

    // Writes down where the world is, and goes back there: a restored world goes on as the one that
    // was written down, and leaves its agents in the scratch as a reset does. Throws
    // std::invalid_argument, before anything is changed, for a snapshot of another configuration.
    Snapshot snapshot(const Scratch& scratch) const;
    void restore(const Snapshot& snapshot, Scratch& scratch);

    // Puts the agents into the scratch, or takes them out. A world is played between the two.
    void enter(Scratch& scratch) const;
    void leave(Scratch& scratch) const;

    // Do agents act one at a time? Else every turn lifts and posts all agents, so that a world may
    // be played without being put into the scratch before; it is in it afterwards.
    bool one_by_one() const { return config().rules.interaction == Interaction::AgentTurns; }

    // One round with the actions committed by all agents. `log` collects the conflicts.
    void step(const std::uint8_t* actions, Scratch& scratch, std::vector<Conflict>* log = nullptr);

    // The same, turn by turn, for players that look before their own turn.
    int n_turns() const;
    void begin_round();
    // Agents [first, last) act in turn `turn`.
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
    const IntArray& last_cells() const { return last_cell_; }   // by agent that is gone
    const std::vector<int>& living() const { return living_; }  // in the order of their numbers
    int n_living(Team team) const { return n_living_[static_cast<int>(team)]; }
    const Terrain& terrain() const { return *terrain_; }
    const std::shared_ptr<const Terrain>& shared_terrain() const { return terrain_; }

    // By evader; `captors` is 0 once the step of the capture is over and the evader gone.
    const ByteArray& captured() const { return captured_; }
    const ByteArray& ever_captured() const { return ever_captured_; }
    const IntArray& captors() const { return captors_; }
    // Evaders that count as captured: ever under occupation, at this moment under surround.
    int n_captured() const { return n_captured_; }
    int n_ever_captured() const { return static_cast<int>(ever_captured_.cast<int>().sum()); }

    const FloatArray& rewards() const { return rewards_; }    // by agent, of the last round
    Flags report(int agent) const { return report_[agent]; }  // involved and at_fault bits
    int steps() const { return steps_; }
    bool terminated() const { return terminated_; }
    bool truncated() const { return truncated_; }
    bool over() const { return terminated_ || truncated_; }
    EpisodeKey key() const { return key_; }

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
    void place(int agent, int cell, Scratch& scratch);

    const std::vector<int>& choose_participants(int actor, int action, Scratch& scratch) const;
    Turn make_turn(const std::vector<int>& participants, const std::uint8_t* actions, int first,
                   int last, int number) const;
    void settle(const Turn& turn, Scratch& scratch);
    void remove(int agent, int at);
    void drop_gone();
    void judge_captures(const Turn& turn, Scratch& scratch);
    void judge_contacts(const Turn& turn, Scratch& scratch);
    void add_companions(int evader, const Turn& turn, Scratch& scratch);
    void judge_surround(int evader, Scratch& scratch);
    void choose_judged(const Turn& turn, const Scratch& scratch);
    void choose_near(int cell, const Scratch& scratch);
    void choose_evader(int agent);
    void add_captor(int evader, int pursuer);
    void set_captured(int evader, bool captured);
    void release(int evader);
    bool counts_as_captured(int evader) const;
    void pay_captures();
    void remove_captured(Scratch& scratch);
    void pay_actors(const Turn& turn, const Scratch& scratch);
    bool find_touch(const Turn& turn, const Scratch& scratch) const;
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
    IntArray last_cell_;       // by agent that is gone: the cell where it went
    std::vector<int> living_;  // agents, ascending
    int n_living_[kTeams] = {0, 0};
    int n_captured_ = 0;    // evaders that count as captured
    int n_uncaptured_ = 0;  // living evaders that do not

    ByteArray captured_;                       // by evader
    ByteArray ever_captured_;                  // by evader
    ByteArray capture_paid_;                   // by evader
    IntArray captors_;                         // by evader
    std::vector<std::pair<int, int>> unpaid_;  // (evader, captor) judged in this turn
    std::vector<int> judged_;                  // living evaders to judge in this turn
    ByteArray is_judged_;                      // by evader
    bool first_turn_ = false;                  // no turn of this round has been played yet
    bool teams_touch_ = false;                 // in this turn; else nobody is beside an adversary

    FloatArray rewards_;
    Eigen::Array<Flags, Eigen::Dynamic, 1> report_;
    int steps_ = 0;
    bool terminated_ = false;
    bool truncated_ = false;
};

}  // namespace matrixworld
