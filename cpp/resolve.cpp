#include "resolve.hpp"

namespace matrixworld {

namespace {

// The layout of a word of `headed_`, for each team in its own 11 bits.
using Word = std::uint32_t;
constexpr int kTeamBits = 11;
constexpr Word kStanding = 1;  // way 0
constexpr Word kMoving = (1u << kDiagonalMoves) - 1 - kStanding;
constexpr Word kSeveral = 1u << kDiagonalMoves;  // more than one agent
constexpr Word kStandingActor = 1u << (kDiagonalMoves + 1);
constexpr Word kTeamMask = (1u << kTeamBits) - 1;

Word of_team(Word word, Team team) {
    return (word >> (kTeamBits * static_cast<int>(team))) & kTeamMask;
}

Team opponent(Team team) { return team == Team::Pursuer ? Team::Evader : Team::Pursuer; }

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
      flags_(decltype(flags_)::Zero(n_agents)),
      way_(ByteArray::Zero(n_agents)),
      target_(IntArray::Zero(n_agents)),
      headed_(decltype(headed_)::Zero(grid.n_cells())),
      first_(IntArray::Constant(grid.n_cells(), -1)),
      next_(IntArray::Constant(n_agents, -1)) {
    present_.reserve(n_agents);
    company_.reserve(n_agents);
    held_now_.reserve(n_agents);
    posted_.reserve(n_agents);
    listed_.reserve(n_agents);
}

void Resolver::resolve(const Turn& turn, std::vector<Conflict>* log) {
    turn_ = &turn;
    log_ = log;
    captures_.clear();
    held_now_.clear();
    set_out();
    obstacles();
    teammates();
    adversaries();
    chains();
}

void Resolver::set_out() {
    for (int a : turn_->cast) {
        flags_[a] = 0;
        way_[a] = turn_->move[a];
        target_[a] = turn_->cell[a] + grid_.delta(way_[a]);
    }
}

// ---- Stage 1 ------------------------------------------------------------------------------

void Resolver::obstacles() {
    present_.clear();
    for (int a : turn_->cast) {
        const std::uint8_t ground = way_[a] ? turn_->ground[target_[a]] : std::uint8_t{kFree};
        if (ground != kFree) {
            const bool no_cell_beyond = ground == kBorder && rules_.obstacle == Outcome::Reach;
            const Outcome outcome = no_cell_beyond ? Outcome::Bounce : rules_.obstacle;
            flags_[a] |= involved(Kind::Obstacle) | at_fault(Kind::Obstacle);
            if (log_) log_obstacle(a, outcome);
            if (outcome == Outcome::Disappear) {
                flags_[a] |= kCrashed;
                continue;
            }
            if (outcome == Outcome::Bounce) {
                flags_[a] |= kHeld;
                way_[a] = 0;
                target_[a] = turn_->cell[a];
            }
        }
        present_.push_back(a);
    }
}

// ---- Who heads where ------------------------------------------------------------------------

void Resolver::post() {
    for (int a : present_) {
        Word& word = headed_[target_[a]];
        if (word == 0) posted_.push_back(target_[a]);
        const int shift = kTeamBits * static_cast<int>(team(a));
        Word news = 1u << way_[a];
        if (word & ((kMoving | kStanding) << shift)) news |= kSeveral;
        if (way_[a] == 0 && turn_->acts(a)) news |= kStandingActor;
        word |= news << shift;
    }
}

// Those who are not alone: somebody else heads for the same cell, or for the cell that they leave.
// Nobody else can be in conflict.
void Resolver::find_company() {
    company_.clear();
    for (int a : present_) {
        const Word alone = 1u << (kTeamBits * static_cast<int>(team(a)) + way_[a]);
        const Word there = headed_[target_[a]] & ~(kStandingActor | kStandingActor << kTeamBits);
        if (there != alone || (way_[a] && headed_[turn_->cell[a]])) company_.push_back(a);
    }
}

void Resolver::unpost() {
    for (int cell : posted_) headed_[cell] = 0;
    posted_.clear();
}

// From stage 3 on the targets stay as they are: the lists are made once, by whoever needs them.
void Resolver::list_targets() {
    if (!listed_.empty()) return;
    for (int a : present_) {
        const int cell = target_[a];
        if (first_[cell] < 0) listed_.push_back(cell);
        next_[a] = first_[cell];
        first_[cell] = a;
    }
}

void Resolver::unlist_targets() {
    for (int cell : listed_) first_[cell] = -1;
    listed_.clear();
}

bool Resolver::swap(int a, int b) const {
    return way_[a] && target_[a] == turn_->cell[b] && target_[b] == turn_->cell[a];
}

// ---- Stage 2 ------------------------------------------------------------------------------

void Resolver::teammates() {
    post();
    find_company();
    if (log_) {
        list_targets();
        log_pairs(Kind::Teammate);
        unlist_targets();
    }
    for (int a : company_) {
        if (!meets_teammate(a)) continue;
        flags_[a] |= involved(Kind::Teammate) | at_fault(Kind::Teammate);
        if (rules_.teammate == Outcome::Disappear) flags_[a] |= kDoomed;
        if (rules_.teammate == Outcome::Bounce && way_[a]) {
            flags_[a] |= kHeld | kBarred;
            held_now_.push_back(a);
        }
    }
    if (held_now_.empty()) return;
    spread_bounce();
    unpost();  // stage 3 judges what stage 2 left
    post();
    find_company();
}

bool Resolver::meets_teammate(int a) const {
    const Word there = of_team(headed_[target_[a]], team(a));
    if (there & (turn_->acts(a) ? kSeveral : kMoving | kStandingActor)) return true;
    if (way_[a] == 0) return false;
    return of_team(headed_[turn_->cell[a]], team(a)) >> kOpposite[way_[a]] & 1;
}

// Holds, until nothing changes, every teammate that means to enter the cell of one held in this
// stage. (Where teammates bounce no two of them share a cell, so nobody stands there besides.)
void Resolver::spread_bounce() {
    list_targets();
    while (!held_now_.empty()) {
        const int b = held_now_.back();
        held_now_.pop_back();
        way_[b] = 0;
        target_[b] = turn_->cell[b];
        for (int a = first_[turn_->cell[b]]; a >= 0; a = next_[a]) {
            if (way_[a] == 0 || (flags_[a] & kBarred) || team(a) != team(b)) continue;
            for (int side : {a, b})
                flags_[side] |= involved(Kind::Teammate) | at_fault(Kind::Teammate);
            flags_[a] |= kHeld | kBarred;
            if (log_) log_pair(Form::Chain, a, b, turn_->cell[b]);
            held_now_.push_back(a);
        }
    }
    unlist_targets();
}

// ---- Stage 3 ------------------------------------------------------------------------------

void Resolver::adversaries() {
    if (log_) {
        list_targets();
        log_pairs(Kind::Adversary);
    }
    for (int a : company_) judge_adversaries(a);
    unpost();
}

void Resolver::judge_adversaries(int a) {
    const Team other_team = opponent(team(a));
    const bool moves = way_[a] != 0;
    const Word there = of_team(headed_[target_[a]], other_team);
    const Word back = moves ? of_team(headed_[turn_->cell[a]], other_team) : 0;
    const bool standing = there & (turn_->acts(a) ? kStanding : kStandingActor);
    const bool moving = there & kMoving;
    const bool swapping = moves && (back >> kOpposite[way_[a]] & 1);
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

    flags_[a] |= involved(Kind::Adversary);
    if (fault) flags_[a] |= at_fault(Kind::Adversary);
    if (own == Outcome::Disappear) flags_[a] |= kDoomed;
    if (held) {
        flags_[a] |= kHeld | kBarred;
        held_now_.push_back(a);
    }
    if (team(a) == Team::Evader && rules_.contact_captures()) note_captors(a);
}

void Resolver::note_captors(int evader) {
    list_targets();
    for (int p = first_[target_[evader]]; p >= 0; p = next_[p]) {
        if (team(p) == Team::Pursuer && (turn_->acts(p) || turn_->acts(evader))) {
            captures_.emplace_back(evader, p);
        }
    }
    if (way_[evader] == 0) return;
    for (int p = first_[turn_->cell[evader]]; p >= 0; p = next_[p]) {
        if (team(p) == Team::Pursuer && swap(p, evader)) captures_.emplace_back(evader, p);
    }
}

// ---- Stage 4 ------------------------------------------------------------------------------

// `held_now_` are the links. Those held in stage 3 are barred: they head nowhere any more; a link
// made here still counts as heading for its cell.
void Resolver::chains() {
    if (!held_now_.empty()) list_targets();
    for (std::size_t i = 0; i < held_now_.size(); ++i) {
        const int link = held_now_[i];
        for (int a = first_[turn_->cell[link]]; a >= 0; a = next_[a]) {
            const bool enters = way_[a] != 0 && !(flags_[a] & kBarred);
            if (enters && !swap(a, link)) enter_link(a, link);  // a swap was judged before
        }
    }
    unlist_targets();
}

void Resolver::enter_link(int a, int link) {
    const bool friends = team(a) == team(link);
    const Kind kind = friends ? Kind::Teammate : Kind::Adversary;
    const Outcome own = friends ? rules_.teammate : rules_.adversary(team(a));
    const Outcome other = friends ? rules_.teammate : rules_.adversary(team(link));
    const Contact contact{true, false, true, false};

    flags_[a] |= involved(kind);
    flags_[link] |= involved(kind);
    if (friends) flags_[link] |= at_fault(kind);
    if (friends || blames(contact, own, other, rules_.capture)) flags_[a] |= at_fault(kind);
    if (own == Outcome::Disappear) flags_[a] |= kDoomed;
    if (other == Outcome::Disappear) flags_[link] |= kDoomed;
    if (holds(contact, own, other) && !(flags_[a] & kHeld)) {
        flags_[a] |= kHeld;
        held_now_.push_back(a);
    }
    if (!friends && rules_.contact_captures()) {
        const bool evader_enters = team(a) == Team::Evader;
        captures_.emplace_back(evader_enters ? a : link, evader_enters ? link : a);
    }
    if (log_) log_pair(Form::Chain, a, link, turn_->cell[link]);
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
        for (int b = first_[target_[a]]; b >= 0; b = next_[b]) {
            if (concerns(a, b) && (turn_->acts(a) || turn_->acts(b))) {
                log_pair(Form::Vertex, a, b, target_[a]);
            }
        }
        for (int b = first_[turn_->cell[a]]; b >= 0; b = next_[b]) {
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
