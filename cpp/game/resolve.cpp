#include "game/resolve.hpp"

namespace matrixworld {

namespace {

// The geometry of a conflict of two agents, seen from one of them.
struct Contact {
    bool moves;
    bool other_moves;
    bool other_on_target;   // the other is on the cell that this one intends to enter
    bool on_others_target;  // and the reverse

    Contact reversed() const { return {other_moves, moves, on_others_target, other_on_target}; }
};

// Does this conflict by itself hold the agent?
bool holds(const Contact& contact, Outcome own, Outcome other) {
    if (!contact.moves) return false;
    return bounces(own) || (own == Outcome::Reach && bounces(other) && contact.other_on_target);
}

// Is the agent at fault in a conflict of adversaries? An agent that is held is. Where neither is
// held: under surround, an agent that moves; under occupation neither, since contact is the aim of
// the game.
bool blames(const Contact& contact, Outcome own, Outcome other, Capture capture) {
    if (holds(contact, own, other)) return true;
    return capture == Capture::Surround && contact.moves && !holds(contact.reversed(), other, own);
}

std::uint8_t sides(bool first, bool second) {
    return static_cast<std::uint8_t>(first | (second << 1));
}

}  // namespace

Resolver::Resolver(const Grid& grid, const Rules& rules, int n_pursuers, int n_agents)
    : grid_(grid),
      rules_(rules),
      n_pursuers_(n_pursuers),
      present_(n_agents),
      candidates_(n_agents),
      held_now_(n_agents),
      flagged_(n_agents),
      flags_(decltype(flags_)::Zero(n_agents)),
      move_(decltype(move_)::Zero(n_agents)),
      target_(IntArray::Zero(n_agents)),
      by_target_(grid, n_agents) {}

void Resolver::resolve(const Turn& turn, ReservationTable reservations,
                       std::vector<Conflict>* log) {
    turn_ = &turn;
    reservations_ = reservations;
    log_ = log;
    for (int a : flagged_) flags_[a] = 0;  // of the last turn
    flagged_.clear();
    captures_.clear();
    obstacles();
    if (may_conflict_) {
        list_present();
        teammates();
        adversaries();
        chains();
    }
    apply_outcomes();
}

// ---- Stage 1 ------------------------------------------------------------------------------

// Every participant that is left after the conflicts with obstacles reserves its target.
void Resolver::obstacles() {
    may_conflict_ = false;
    turn_->all_act(Team::Pursuer) ? reserve_targets<Team::Pursuer, true>()
                                  : reserve_targets<Team::Pursuer, false>();
    turn_->all_act(Team::Evader) ? reserve_targets<Team::Evader, true>()
                                 : reserve_targets<Team::Evader, false>();
}

template <Team kTeam, bool kAllAct>
void Resolver::reserve_targets() {
    // Copies, which the compiler knows that the writes below do not change.
    const Turn turn = *turn_;
    const ReservationTable reservations = reservations_;
    short* const moves = move_.data();
    int* const targets = target_.data();
    bool may_conflict = false;
    for (int a : turn.of(kTeam)) {
        const bool acts = kAllAct || turn.acts(a);
        int move = acts ? turn.actions[a] : 0;
        int target = turn.cell[a] + grid_.delta(move);
        moves[a] = static_cast<short>(move);
        targets[a] = target;
        if (turn.terrain[target] != kFree && move != 0) {
            if (!survives_obstacle(a)) continue;
            move = moves[a];
            target = targets[a];
        }
        // Two agents with one target: the second finds it reserved. Two that swap: the second finds
        // the opposite move on the cell it leaves. So one pass finds whether there is any conflict.
        may_conflict |= reservations.has_opposite(turn.cell[a], move);
        may_conflict |= reservations.reserve(target, kTeam, Reservation::of(move, acts));
    }
    may_conflict_ |= may_conflict;
}

// Judges an agent that moves into an obstacle; returns whether it is still in the world.
bool Resolver::survives_obstacle(int a) {
    const bool border = turn_->terrain[target_[a]] == kBorder;  // there is no cell beyond
    const Outcome outcome =
        border && rules_.obstacle == Outcome::Reach ? Outcome::Bounce : rules_.obstacle;
    set_flags(a, involved(Kind::Obstacle) | at_fault(Kind::Obstacle));
    if (log_) log_obstacle(a, outcome);
    if (disappears(outcome)) flags_[a] |= kCrashed;
    if (bounces(outcome)) {
        flags_[a] |= kHeld;
        move_[a] = 0;
        target_[a] = turn_->cell[a];
    }
    return !disappears(outcome);
}

// ---- Candidates for conflicts -------------------------------------------------------------------

void Resolver::list_present() {
    present_.clear();
    for (int a : turn_->participants) present_.add_if(!(flags_[a] & kCrashed), a);
}

// The broad phase of collision detection: agents whose target another agent has reserved, too, or
// that may swap cells with another. No other agent is in conflict with an agent.
void Resolver::find_conflict_candidates() {
    const ReservationTable reservations = reservations_;
    candidates_.clear();
    for (int a : present_) {
        const bool alone = reservations.only_one(target_[a], team(a));
        candidates_.add_if(!alone | reservations.has_opposite(turn_->cell[a], move_[a]), a);
    }
}

// The agents that have reserved a cell, one by one. The lists are made at the first call of a
// stage, and only if a reserved cell is asked for; targets must not change until they are cleared.
CellLists::Range Resolver::reserving(int cell) {
    if (!reservations_.empty(cell) && !listed_) {
        for (int a : present_) by_target_.add(a, target_[a]);
        listed_ = true;
    }
    return by_target_.at(cell);
}

void Resolver::clear_target_lists() {
    if (!listed_) return;
    for (int a : present_) by_target_.clear(target_[a]);
    listed_ = false;
}

bool Resolver::swap(int a, int b) const {
    return move_[a] && target_[a] == turn_->cell[b] && target_[b] == turn_->cell[a];
}

// ---- Stage 2 ------------------------------------------------------------------------------

void Resolver::teammates() {
    find_conflict_candidates();
    if (log_) {
        log_pairs(Kind::Teammate);
        clear_target_lists();
    }
    for (int a : candidates_) {
        if (!meets_teammate(a)) continue;
        set_flags(a, involved(Kind::Teammate) | at_fault(Kind::Teammate));
        if (disappears(rules_.teammate)) flags_[a] |= kDoomed;
        if (bounces(rules_.teammate) && move_[a]) {
            flags_[a] |= kHeld | kBarred;
            held_now_.add(a);
        }
    }
    if (held_now_.empty()) return;
    spread_bounce();
    find_conflict_candidates();  // stage 3 judges what stage 2 left
}

// One look at the target and, for a mover, one at the cell it leaves.
bool Resolver::meets_teammate(int a) const {
    const Reservation at_target = reservations_.at(target_[a], team(a));
    if (turn_->acts(a) ? at_target.several()
                       : at_target.has_moving() || at_target.has_standing_actor())
        return true;
    if (move_[a] == 0) return false;
    return reservations_.at(turn_->cell[a], team(a)).has_move(kOpposite[move_[a]]);
}

// Holds, until nothing changes, every teammate that intends to enter the cell of an agent held in
// this stage. The list of held agents grows while it is read: a breadth-first search, in which each
// agent is held once. Agents are barred at once but their reservations are changed only at the end,
// so that all are judged on the same targets. (Where teammates bounce, no two of them share a cell,
// so no third one is on it and no two come to it by the same move.)
void Resolver::spread_bounce() {
    AgentList& held = held_now_;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const int b = held[i];
        for (int a : reserving(turn_->cell[b])) {
            if (move_[a] == 0 || (flags_[a] & kBarred) || team(a) != team(b)) continue;
            for (int side : {a, b}) {
                set_flags(side, involved(Kind::Teammate) | at_fault(Kind::Teammate));
            }
            flags_[a] |= kHeld | kBarred;
            if (disappears(rules_.teammate)) flags_[a] |= kDoomed;
            if (log_) log_pair(Form::Chain, a, b, turn_->cell[b]);
            held.add(a);
        }
    }
    clear_target_lists();
    for (int a : held) hold(a);
    held.clear();
}

// Cancels an agent's move: from now on it intends to stay.
void Resolver::hold(int a) {
    reservations_.release(target_[a], team(a), move_[a]);
    move_[a] = 0;
    target_[a] = turn_->cell[a];
    reservations_.reserve(target_[a], team(a), Reservation::of(0, true));
}

// ---- Stage 3 ------------------------------------------------------------------------------

void Resolver::adversaries() {
    if (log_) log_pairs(Kind::Adversary);
    for (int a : candidates_) judge_adversaries(a);
}

// An agent can be in several conflicts at once (with adversaries that stand on, come to, or leave
// its target); what any of them does to it counts.
void Resolver::judge_adversaries(int a) {
    const Team other_team = opponent(team(a));
    const bool moves = move_[a] != 0;
    const Reservation at_target = reservations_.at(target_[a], other_team);
    const bool standing =
        turn_->acts(a) ? at_target.has_standing() : at_target.has_standing_actor();
    const bool moving = at_target.has_moving();
    const bool swapping =
        moves && reservations_.at(turn_->cell[a], other_team).has_move(kOpposite[move_[a]]);
    if (!(standing || moving || swapping)) return;

    const Outcome own = rules_.adversary(team(a));
    const Outcome other = rules_.adversary(other_team);
    bool held = false;
    bool fault = false;
    const auto judge = [&](const Contact& contact) {
        held |= holds(contact, own, other);
        fault |= blames(contact, own, other, rules_.capture);
    };
    if (standing) judge({moves, false, true, !moves});
    if (moving) judge({moves, true, false, !moves});
    if (swapping) judge({true, true, true, true});

    set_flags(a, involved(Kind::Adversary));
    if (fault) flags_[a] |= at_fault(Kind::Adversary);
    if (disappears(own)) flags_[a] |= kDoomed;
    if (held) {
        flags_[a] |= kHeld | kBarred;
        held_now_.add(a);
    }
    if (team(a) == Team::Evader && rules_.contact_captures()) add_captors(a);
}

// Notes every pursuer in conflict with an evader: those with the same target, and those that swap.
void Resolver::add_captors(int evader) {
    for (int p : reserving(target_[evader])) {
        if (team(p) == Team::Pursuer && (turn_->acts(p) || turn_->acts(evader))) {
            captures_.emplace_back(evader, p);
        }
    }
    if (move_[evader] == 0) return;
    for (int p : reserving(turn_->cell[evader])) {
        if (team(p) == Team::Pursuer && swap(p, evader)) captures_.emplace_back(evader, p);
    }
}

// ---- Stage 4 ------------------------------------------------------------------------------

// `held_now_` are the links; those made here are appended and followed up in their turn. Agents
// held in earlier stages are barred: they enter no cell any more. A link made here is still judged
// on the target that it had when the stage began.
void Resolver::chains() {
    for (std::size_t i = 0; i < held_now_.size(); ++i) {
        const int link = held_now_[i];
        for (int a : reserving(turn_->cell[link])) {
            const bool enters = move_[a] != 0 && !(flags_[a] & kBarred);
            if (enters && !swap(a, link)) enter_link(a, link);  // a swap was judged before
        }
    }
    held_now_.clear();
    clear_target_lists();
}

// An agent enters the cell of a link, as if the link stood still there from the start.
void Resolver::enter_link(int a, int link) {
    const bool same_team = team(a) == team(link);
    const Kind kind = same_team ? Kind::Teammate : Kind::Adversary;
    const Outcome own = same_team ? rules_.teammate : rules_.adversary(team(a));
    const Outcome other = same_team ? rules_.teammate : rules_.adversary(team(link));
    const Contact contact{true, false, true, false};

    set_flags(a, involved(kind));
    set_flags(link, involved(kind));
    if (same_team) flags_[link] |= at_fault(kind);
    if (same_team || blames(contact, own, other, rules_.capture)) flags_[a] |= at_fault(kind);
    if (disappears(own)) flags_[a] |= kDoomed;
    if (disappears(other)) flags_[link] |= kDoomed;
    if (holds(contact, own, other) && !(flags_[a] & kHeld)) {
        flags_[a] |= kHeld;
        held_now_.add(a);
    }
    if (!same_team && rules_.contact_captures()) {
        const bool evader_enters = team(a) == Team::Evader;
        captures_.emplace_back(evader_enters ? a : link, evader_enters ? link : a);
    }
    if (log_) log_pair(Form::Chain, a, link, turn_->cell[link]);
}

// ---- Outcomes -----------------------------------------------------------------------------

// Moves the reservations of agents that disappear or return to where they belong, and sets the
// final targets. Only agents with flags can be concerned.
void Resolver::apply_outcomes() {
    for (int a : flagged_) {
        const bool gone = flags_[a] & (kCrashed | kDoomed);
        const bool returns = flags_[a] & kHeld && target_[a] != turn_->cell[a];
        if (!(flags_[a] & kCrashed) && (gone || returns)) {
            reservations_.release(target_[a], team(a), move_[a]);
        }
        if (flags_[a] & (kCrashed | kHeld)) target_[a] = turn_->cell[a];
        if (returns && !gone) reservations_.reserve(target_[a], team(a), Reservation::of(0, true));
    }
}

// ---- The list of conflicts ------------------------------------------------------------------

void Resolver::log_obstacle(int a, Outcome outcome) {
    log_->push_back({turn_->number, Kind::Obstacle, Form::Vertex, a, -1, target_[a],
                     sides(true, false), sides(bounces(outcome), false),
                     sides(disappears(outcome), false)});
}

// Lists every pair in conflict, vertex and edge, before the stage changes anything.
void Resolver::log_pairs(Kind kind) {
    const auto concerns = [&](int a, int b) {
        return a < b && (team(a) == team(b)) == (kind == Kind::Teammate);
    };
    for (int a : present_) {
        for (int b : reserving(target_[a])) {
            if (concerns(a, b) && (turn_->acts(a) || turn_->acts(b))) {
                log_pair(Form::Vertex, a, b, target_[a]);
            }
        }
        for (int b : reserving(turn_->cell[a])) {
            if (concerns(a, b) && swap(a, b)) log_pair(Form::Edge, a, b, target_[a]);
        }
    }
}

void Resolver::log_pair(Form form, int a, int b, int cell) {
    const bool chain = form == Form::Chain;
    const bool b_moves = !chain && move_[b] != 0;
    const bool edge = form == Form::Edge;
    const Contact contact{move_[a] != 0, b_moves, chain || edge || !b_moves,
                          !chain && (edge || move_[a] == 0)};
    const bool same_team = team(a) == team(b);
    const Outcome own = same_team ? rules_.teammate : rules_.adversary(team(a));
    const Outcome other = same_team ? rules_.teammate : rules_.adversary(team(b));
    const Contact reversed = contact.reversed();
    log_->push_back({turn_->number, same_team ? Kind::Teammate : Kind::Adversary, form, a, b, cell,
                     same_team ? sides(true, true)
                               : sides(blames(contact, own, other, rules_.capture),
                                       blames(reversed, other, own, rules_.capture)),
                     sides(holds(contact, own, other), holds(reversed, other, own)),
                     sides(disappears(own), disappears(other))});
}

}  // namespace matrixworld
