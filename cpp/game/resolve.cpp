#include "game/resolve.hpp"

namespace matrixworld {

namespace {

// How two agents in conflict stand to each other, seen from one of them.
struct Contact {
    bool moves;
    bool other_moves;
    bool other_on_target;   // the other stands on the cell that this one means to enter
    bool on_others_target;  // and the reverse

    Contact reversed() const { return {other_moves, moves, on_others_target, other_on_target}; }
};

// Does the conflict by itself hold this one?
bool holds(const Contact& contact, Outcome own, Outcome other) {
    if (!contact.moves) return false;
    return own == Outcome::Bounce ||
           (own == Outcome::Reach && other == Outcome::Bounce && contact.other_on_target);
}

// Blame among adversaries: whoever is held; where nobody is, under surround, whoever moves.
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
      company_(n_agents),
      held_now_(n_agents),
      eventful_(n_agents),
      flags_(decltype(flags_)::Zero(n_agents)),
      way_(decltype(way_)::Zero(n_agents)),
      target_(IntArray::Zero(n_agents)),
      by_target_(grid, n_agents) {}

void Resolver::resolve(const Turn& turn, ReservationTable reservations,
                       std::vector<Conflict>* log) {
    turn_ = &turn;
    reservations_ = reservations;
    log_ = log;
    for (int a : eventful_) flags_[a] = 0;  // of the last turn
    eventful_.clear();
    captures_.clear();
    obstacles();
    if (somebody_meets_) {
        list_present();
        teammates();
        adversaries();
        chains();
    }
    end_up();
}

// ---- Stage 1 ------------------------------------------------------------------------------

// Everybody sets out, and whoever is still there is posted where it heads for.
void Resolver::obstacles() {
    somebody_meets_ = false;
    turn_->all_act(Team::Pursuer) ? set_out<Team::Pursuer, true>()
                                  : set_out<Team::Pursuer, false>();
    turn_->all_act(Team::Evader) ? set_out<Team::Evader, true>() : set_out<Team::Evader, false>();
}

template <Team kTeam, bool kAllAct>
void Resolver::set_out() {
    const Turn turn = *turn_;  // copies, which the compiler knows that nothing stored here changes
    const ReservationTable reservations = reservations_;
    short* const ways = way_.data();
    int* const targets = target_.data();
    bool meets = false;
    for (int a : turn.of(kTeam)) {
        const bool acts = kAllAct || turn.acts(a);
        int way = acts ? turn.actions[a] : 0;
        int target = turn.cell[a] + grid_.delta(way);
        ways[a] = static_cast<short>(way);
        targets[a] = target;
        if (turn.terrain[target] != kFree && way != 0) {
            if (!enters_obstacle(a)) continue;
            way = ways[a];
            target = targets[a];
        }
        meets |= reservations.comes_opposite(turn.cell[a], way);
        meets |= reservations.reserve(target, kTeam, Reservation::by(way, acts));
    }
    somebody_meets_ |= meets;
}

// Is an agent that runs into an obstacle still there?
bool Resolver::enters_obstacle(int a) {
    const bool border = turn_->terrain[target_[a]] == kBorder;  // there is no cell beyond
    const Outcome outcome =
        border && rules_.obstacle == Outcome::Reach ? Outcome::Bounce : rules_.obstacle;
    raise(a, involved(Kind::Obstacle) | at_fault(Kind::Obstacle));
    if (log_) log_obstacle(a, outcome);
    if (outcome == Outcome::Disappear) flags_[a] |= kCrashed;
    if (outcome == Outcome::Bounce) {
        flags_[a] |= kHeld;
        way_[a] = 0;
        target_[a] = turn_->cell[a];
    }
    return outcome != Outcome::Disappear;
}

// ---- Who meets whom -------------------------------------------------------------------------

void Resolver::list_present() {
    present_.clear();
    for (int a : turn_->participants) present_.add_if(!(flags_[a] & kCrashed), a);
}

// Those who are not alone: somebody else heads for the same cell, or comes from there to the cell
// that they leave. Nobody else is in conflict with anybody.
void Resolver::find_company() {
    const ReservationTable reservations = reservations_;
    company_.clear();
    for (int a : present_) {
        const bool alone = reservations.alone(target_[a], team(a));
        company_.add_if(!alone | reservations.comes_opposite(turn_->cell[a], way_[a]), a);
    }
}

// Who heads for a cell, one by one. The lists are made once in a stage in which somebody does, and
// targets stay as they are while there are lists.
CellLists::Range Resolver::reserving(int cell) {
    if (!reservations_.empty(cell) && !listed_) {
        for (int a : present_) by_target_.add(a, target_[a]);
        listed_ = true;
    }
    return by_target_.at(cell);
}

void Resolver::unlist_targets() {
    if (!listed_) return;
    for (int a : present_) by_target_.clear(target_[a]);
    listed_ = false;
}

bool Resolver::swap(int a, int b) const {
    return way_[a] && target_[a] == turn_->cell[b] && target_[b] == turn_->cell[a];
}

// ---- Stage 2 ------------------------------------------------------------------------------

void Resolver::teammates() {
    find_company();
    if (log_) {
        log_pairs(Kind::Teammate);
        unlist_targets();
    }
    for (int a : company_) {
        if (!meets_teammate(a)) continue;
        raise(a, involved(Kind::Teammate) | at_fault(Kind::Teammate));
        if (rules_.teammate == Outcome::Disappear) flags_[a] |= kDoomed;
        if (rules_.teammate == Outcome::Bounce && way_[a]) {
            flags_[a] |= kHeld | kBarred;
            held_now_.add(a);
        }
    }
    if (held_now_.empty()) return;
    spread_bounce();
    find_company();  // stage 3 judges what stage 2 left
}

bool Resolver::meets_teammate(int a) const {
    const Reservation there = reservations_.at(target_[a], team(a));
    if (turn_->acts(a) ? there.several() : there.moves() || there.stands_as_actor()) return true;
    if (way_[a] == 0) return false;
    return reservations_.at(turn_->cell[a], team(a)).takes(kOpposite[way_[a]]);
}

// Holds, until nothing changes, every teammate that means to enter the cell of one held in this
// stage. (Where teammates bounce no two of them share a cell, so nobody stands there besides, and
// nobody else came the same way.)
void Resolver::spread_bounce() {
    AgentList& held = held_now_;
    for (std::size_t i = 0; i < held.size(); ++i) {
        const int b = held[i];
        for (int a : reserving(turn_->cell[b])) {
            if (way_[a] == 0 || (flags_[a] & kBarred) || team(a) != team(b)) continue;
            for (int side : {a, b}) {
                raise(side, involved(Kind::Teammate) | at_fault(Kind::Teammate));
            }
            flags_[a] |= kHeld | kBarred;
            if (log_) log_pair(Form::Chain, a, b, turn_->cell[b]);
            held.add(a);
        }
    }
    unlist_targets();
    for (int a : held) hold(a);
    held.clear();
}

// From now on an agent means to stay.
void Resolver::hold(int a) {
    reservations_.release(target_[a], team(a), way_[a]);
    way_[a] = 0;
    target_[a] = turn_->cell[a];
    reservations_.reserve(target_[a], team(a), Reservation::by(0, true));
}

// ---- Stage 3 ------------------------------------------------------------------------------

void Resolver::adversaries() {
    if (log_) log_pairs(Kind::Adversary);
    for (int a : company_) judge_adversaries(a);
}

void Resolver::judge_adversaries(int a) {
    const Team other_team = opponent(team(a));
    const bool moves = way_[a] != 0;
    const Reservation there = reservations_.at(target_[a], other_team);
    const bool standing = turn_->acts(a) ? there.stands() : there.stands_as_actor();
    const bool moving = there.moves();
    const bool swapping =
        moves && reservations_.at(turn_->cell[a], other_team).takes(kOpposite[way_[a]]);
    if (!(standing || moving || swapping)) return;

    const Outcome own = rules_.adversary(team(a));
    const Outcome other = rules_.adversary(other_team);
    bool held = false;
    bool fault = false;
    const auto meet = [&](const Contact& contact) {
        held |= holds(contact, own, other);
        fault |= blames(contact, own, other, rules_.capture);
    };
    if (standing) meet({moves, false, true, !moves});
    if (moving) meet({moves, true, false, !moves});
    if (swapping) meet({true, true, true, true});

    raise(a, involved(Kind::Adversary));
    if (fault) flags_[a] |= at_fault(Kind::Adversary);
    if (own == Outcome::Disappear) flags_[a] |= kDoomed;
    if (held) {
        flags_[a] |= kHeld | kBarred;
        held_now_.add(a);
    }
    if (team(a) == Team::Evader && rules_.contact_captures()) note_captors(a);
}

void Resolver::note_captors(int evader) {
    for (int p : reserving(target_[evader])) {
        if (team(p) == Team::Pursuer && (turn_->acts(p) || turn_->acts(evader))) {
            captures_.emplace_back(evader, p);
        }
    }
    if (way_[evader] == 0) return;
    for (int p : reserving(turn_->cell[evader])) {
        if (team(p) == Team::Pursuer && swap(p, evader)) captures_.emplace_back(evader, p);
    }
}

// ---- Stage 4 ------------------------------------------------------------------------------

// `held_now_` are the links. Those held in stage 3 are barred: they head nowhere any more; a link
// made here still counts as reservation for its cell.
void Resolver::chains() {
    for (std::size_t i = 0; i < held_now_.size(); ++i) {
        const int link = held_now_[i];
        for (int a : reserving(turn_->cell[link])) {
            const bool enters = way_[a] != 0 && !(flags_[a] & kBarred);
            if (enters && !swap(a, link)) enter_link(a, link);  // a swap was judged before
        }
    }
    held_now_.clear();
    unlist_targets();
}

void Resolver::enter_link(int a, int link) {
    const bool friends = team(a) == team(link);
    const Kind kind = friends ? Kind::Teammate : Kind::Adversary;
    const Outcome own = friends ? rules_.teammate : rules_.adversary(team(a));
    const Outcome other = friends ? rules_.teammate : rules_.adversary(team(link));
    const Contact contact{true, false, true, false};

    raise(a, involved(kind));
    raise(link, involved(kind));
    if (friends) flags_[link] |= at_fault(kind);
    if (friends || blames(contact, own, other, rules_.capture)) flags_[a] |= at_fault(kind);
    if (own == Outcome::Disappear) flags_[a] |= kDoomed;
    if (other == Outcome::Disappear) flags_[link] |= kDoomed;
    if (holds(contact, own, other) && !(flags_[a] & kHeld)) {
        flags_[a] |= kHeld;
        held_now_.add(a);
    }
    if (!friends && rules_.contact_captures()) {
        const bool evader_enters = team(a) == Team::Evader;
        captures_.emplace_back(evader_enters ? a : link, evader_enters ? link : a);
    }
    if (log_) log_pair(Form::Chain, a, link, turn_->cell[link]);
}

// ---- The end --------------------------------------------------------------------------------------

void Resolver::end_up() {
    for (int a : eventful_) {
        const bool gone = flags_[a] & (kCrashed | kDoomed);
        const bool returns = flags_[a] & kHeld && target_[a] != turn_->cell[a];
        if (!(flags_[a] & kCrashed) && (gone || returns)) {
            reservations_.release(target_[a], team(a), way_[a]);
        }
        if (flags_[a] & (kCrashed | kHeld)) target_[a] = turn_->cell[a];
        if (returns && !gone) reservations_.reserve(target_[a], team(a), Reservation::by(0, true));
    }
}

// ---- The list of conflicts ------------------------------------------------------------------

void Resolver::log_obstacle(int a, Outcome outcome) {
    log_->push_back({turn_->number, Kind::Obstacle, Form::Vertex, a, -1, target_[a],
                     sides(true, false), sides(outcome == Outcome::Bounce, false),
                     sides(outcome == Outcome::Disappear, false)});
}

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
    const bool b_moves = !chain && way_[b] != 0;
    const bool edge = form == Form::Edge;
    const Contact contact{way_[a] != 0, b_moves, chain || edge || !b_moves,
                          !chain && (edge || way_[a] == 0)};
    const bool friends = team(a) == team(b);
    const Outcome own = friends ? rules_.teammate : rules_.adversary(team(a));
    const Outcome other = friends ? rules_.teammate : rules_.adversary(team(b));
    const Contact reversed = contact.reversed();
    log_->push_back({turn_->number, friends ? Kind::Teammate : Kind::Adversary, form, a, b, cell,
                     friends ? sides(true, true)
                             : sides(blames(contact, own, other, rules_.capture),
                                     blames(reversed, other, own, rules_.capture)),
                     sides(holds(contact, own, other), holds(reversed, other, own)),
                     sides(own == Outcome::Disappear, other == Outcome::Disappear)});
}

}  // namespace matrixworld
