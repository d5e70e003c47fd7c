// Intents and rules -> outcomes, for one turn. Pure: no random number, no reward, no clock. The
// four methods that `resolve` calls are the first four stages of a step. Each stage judges all
// agents at once from the state that the stage found: an agent that was judged does not change what
// the next one is judged on, so renumbering the agents renumbers the outcomes and changes nothing
// else.
//
// The reservation table tells by which moves each cell is reserved. Whether an agent is in conflict
// is then a look at two cells, the one it enters and the one it leaves. Nearly all agents are in no
// conflict, and nothing more is done for them. The work is O(agents), plus the pairs of a chain or
// a capture where several agents share a cell.
//
//     resolver.resolve(turn, occupancy.reservations(), nullptr);
//     for (int a : turn.participants) cell[a] = resolver.target(a);
//     for (int a : resolver.flagged()) { if (resolver.flags(a) & kDoomed) ... }
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "game/occupancy.hpp"
#include "grid/agent_lists.hpp"
#include "grid/grid.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

// What happened to one agent in a turn, as bits.
using Flags = std::uint16_t;
constexpr Flags involved(Kind kind) { return Flags(1 << static_cast<int>(kind)); }
constexpr Flags at_fault(Kind kind) { return Flags(1 << (kKinds + static_cast<int>(kind))); }
constexpr Flags kReportMask = (1 << (2 * kKinds)) - 1;  // the bits of involved and at_fault
constexpr Flags kHeld = 1 << 6;                         // its move is cancelled: it stays
constexpr Flags kCrashed = 1 << 7;                      // gone in stage 1
constexpr Flags kDoomed = 1 << 8;                       // gone in stage 5
constexpr Flags kBarred = 1 << 9;  // held before stage 4: its former target counts no more

// One conflict, for the list that explains a step. In the last three members bit 0 stands for the
// first agent and bit 1 for the second.
struct Conflict {
    int turn;
    Kind kind;
    Form form;
    int first;
    int second;  // -1 where the other side is an obstacle
    int cell;    // the common target; for an edge and a chain, the target of `first`
    std::uint8_t at_fault;
    std::uint8_t held;
    std::uint8_t doomed;
};

// A range of agents.
struct Agents {
    const int* first;
    const int* last;

    const int* begin() const { return first; }
    const int* end() const { return last; }
};

// What a turn is resolved from: the participants (the agents that the turn can affect) and their
// actions. Agents with first_actor <= agent < last_actor act; the others intend to stay.
struct Turn {
    Agents participants;          // living agents, pursuers first
    const int* first_evader;      // of the participants
    Agents actors;                // of the participants
    const int* cell;              // by agent
    const std::uint8_t* actions;  // by agent
    const std::uint8_t* terrain;  // by cell
    int first_actor;
    int last_actor;
    int number;

    bool acts(int agent) const { return agent >= first_actor && agent < last_actor; }
    bool all_act(Team team) const {
        const Agents agents = of(team);
        return agents.first == agents.last || (acts(agents.first[0]) && acts(agents.last[-1]));
    }
    Agents of(Team team) const {
        return team == Team::Pursuer ? Agents{participants.first, first_evader}
                                     : Agents{first_evader, participants.last};
    }
};

class Resolver {
  public:
    Resolver(const Grid& grid, const Rules& rules, int n_pursuers, int n_agents);

    // Resolves one turn. Precondition: no participant holds a reservation. Postcondition: every
    // survivor has reserved its final cell, and no agent that disappears holds a reservation.
    // Appends each conflict to `log` where one is given; that costs the number of conflicts.
    void resolve(const Turn& turn, ReservationTable reservations, std::vector<Conflict>* log);

    Flags flags(int agent) const { return flags_[agent]; }
    // The final cell of a participant; for one that disappears, the cell where it does.
    int target(int agent) const { return target_[agent]; }
    // The agents with any flag; each once.
    const AgentList& flagged() const { return flagged_; }
    // False: the only conflicts of this turn were with obstacles, and no two agents share a cell.
    bool may_conflict() const { return may_conflict_; }
    // (evader, pursuer) for every contact that captures; each pair once.
    const std::vector<std::pair<int, int>>& captures() const { return captures_; }

  private:
    void obstacles();
    void teammates();
    void adversaries();
    void chains();
    void apply_outcomes();

    template <Team kTeam, bool kAllAct>
    void reserve_targets();
    bool survives_obstacle(int agent);
    void list_present();
    void find_conflict_candidates();
    CellLists::Range reserving(int cell);
    void clear_target_lists();
    void hold(int agent);
    void spread_bounce();
    void add_captors(int evader);
    void enter_link(int entrant, int link);
    bool swap(int a, int b) const;
    bool meets_teammate(int agent) const;
    void judge_adversaries(int agent);

    void log_obstacle(int agent, Outcome outcome);
    void log_pairs(Kind kind);
    void log_pair(Form form, int a, int b, int cell);

    Team team(int agent) const { return agent < n_pursuers_ ? Team::Pursuer : Team::Evader; }
    // Flags are added, never taken back, during a turn.
    void set_flags(int agent, Flags added) {
        if (flags_[agent] == 0) flagged_.add(agent);
        flags_[agent] |= added;
    }

    const Grid grid_;
    const Rules rules_;
    int n_pursuers_;

    const Turn* turn_ = nullptr;
    ReservationTable reservations_{nullptr};
    std::vector<Conflict>* log_ = nullptr;
    bool may_conflict_ = false;
    AgentList present_;     // the participants that did not crash
    AgentList candidates_;  // those of them that may be in conflict with an agent
    AgentList held_now_;    // held during this stage, their followers not yet judged
    AgentList flagged_;
    std::vector<std::pair<int, int>> captures_;

    Eigen::Array<Flags, Eigen::Dynamic, 1> flags_;  // by agent
    Eigen::Array<short, Eigen::Dynamic, 1> move_;   // by agent: the move that it still intends
    IntArray target_;                               // by agent: the cell that it intends to be on

    CellLists by_target_;  // the present agents by target, made where a stage needs single agents
    bool listed_ = false;
};

}  // namespace matrixworld
