// Intents and rules -> outcomes, for one turn. Pure: no random number, no reward, no clock. The
// four methods that `resolve` calls are the first four stages of a step; each judges all agents
// at once from the state that it found, so the numbering of agents cannot matter.
//
// ReservationTable tell for each cell who heads for it, and by which ways. Whether an agent is in
// conflict is then a look at two cells, the one it heads for and the one it leaves. Nearly all
// agents are in none, and nothing more is asked of them. The work is O(agents), plus the pairs of a
// chain or a capture where several share a cell.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "game/occupancy.hpp"
#include "grid/agent_list.hpp"
#include "grid/cell_lists.hpp"
#include "grid/grid.hpp"
#include "grid/rules.hpp"

namespace matrixworld {

// What became of one agent, as bits.
using Flags = std::uint16_t;
constexpr Flags involved(Kind kind) { return Flags(1 << static_cast<int>(kind)); }
constexpr Flags at_fault(Kind kind) { return Flags(1 << (kKinds + static_cast<int>(kind))); }
constexpr Flags kReportMask = (1 << (2 * kKinds)) - 1;  // the bits of involved and at_fault
constexpr Flags kHeld = 1 << 6;                         // its move is cancelled
constexpr Flags kCrashed = 1 << 7;                      // gone in stage 1
constexpr Flags kDoomed = 1 << 8;                       // gone in stage 5
constexpr Flags kBarred = 1 << 9;  // held before stage 4: it heads nowhere any more

// One conflict, as a reader wants to hear of it. Sides: bit 0 the first agent, bit 1 the second.
struct Conflict {
    int turn;
    Kind kind;
    Form form;
    int first;
    int second;  // -1 where the other side is an obstacle
    int cell;    // the common target; for an edge and a chain, where `first` headed
    std::uint8_t at_fault;
    std::uint8_t held;
    std::uint8_t doomed;
};

// Some agents, one after the other.
struct Agents {
    const int* first;
    const int* last;

    const int* begin() const { return first; }
    const int* end() const { return last; }
};

// The agents that may meet in this turn and what they set out to do. Those with first_actor <=
// agent < last_actor act; the others stay where they are.
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

    // Finds nobody of the participants posted, and leaves everybody posted where it ends up, but for those
    // who disappear. Appends each conflict to `log` where one is given; that costs the
    // number of conflicts.
    void resolve(const Turn& turn, ReservationTable reservations, std::vector<Conflict>* log);

    Flags flags(int agent) const { return flags_[agent]; }
    // The cell where an agent of the participants ends up, or where it disappears.
    int target(int agent) const { return target_[agent]; }
    // Agents with any flag at all; each once.
    const AgentList& eventful() const { return eventful_; }
    // (evader, pursuer) for every contact that captures; each pair once.
    const std::vector<std::pair<int, int>>& captures() const { return captures_; }

  private:
    void obstacles();
    void teammates();
    void adversaries();
    void chains();
    void end_up();

    template <Team kTeam, bool kAllAct>
    void set_out();
    bool enters_obstacle(int agent);
    void list_present();
    void find_company();
    CellLists::Range reserving(int cell);
    void unlist_targets();
    void hold(int agent);
    void spread_bounce();
    void note_captors(int evader);
    void enter_link(int entrant, int link);
    bool swap(int a, int b) const;
    bool meets_teammate(int agent) const;
    void judge_adversaries(int agent);

    void log_obstacle(int agent, Outcome outcome);
    void log_pairs(Kind kind);
    void log_pair(Form form, int a, int b, int cell);

    Team team(int agent) const { return agent < n_pursuers_ ? Team::Pursuer : Team::Evader; }
    void raise(int agent, Flags news) {
        if (flags_[agent] == 0) eventful_.add(agent);
        flags_[agent] |= news;
    }

    const Grid grid_;
    const Rules rules_;
    int n_pursuers_;

    const Turn* turn_ = nullptr;
    ReservationTable reservations_{nullptr};
    std::vector<Conflict>* log_ = nullptr;
    bool somebody_meets_ = false;  // else there is no conflict but with obstacles
    AgentList present_;            // the participants without the crashed
    AgentList company_;            // those of them who may be in conflict
    AgentList held_now_;           // held during this stage, not yet followed up
    AgentList eventful_;
    std::vector<std::pair<int, int>> captures_;

    Eigen::Array<Flags, Eigen::Dynamic, 1> flags_;  // by agent
    Eigen::Array<short, Eigen::Dynamic, 1> way_;    // by agent: the move that it still intends
    IntArray target_;                               // by agent: the cell that it heads for

    CellLists by_target_;
    bool listed_ = false;
};

}  // namespace matrixworld
