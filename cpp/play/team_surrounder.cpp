#include "play/team_surrounder.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "grid/compiler.hpp"

namespace matrixworld {

namespace {

// ---- Sets of cells -----------------------------------------------------------------------------

// A set of cells around the agent, which is in the middle: at most 11 x 11, also of a wider view.
using Cells = Bits128;
constexpr int kSide = 11;
constexpr int kReach = kSide / 2;

constexpr int number(Offset at) { return (at.row + kReach) * kSide + at.col + kReach; }
constexpr Offset offset(int number) { return {number / kSide - kReach, number % kSide - kReach}; }
constexpr bool fits(Offset at) {
    return -kReach <= at.row && at.row <= kReach && -kReach <= at.col && at.col <= kReach;
}
constexpr Cells one(int number) { return Cells{1} << number; }
constexpr Offset step(int move, int steps = 1) {
    return {kRowStep[move] * steps, kColStep[move] * steps};
}
constexpr Cells after(int move) { return one(number(step(move))); }
constexpr Cells kMe = one(number({0, 0}));
constexpr Cells kAll = one(kSide * kSide) - 1;

constexpr Cells column(int col) {
    Cells cells = 0;
    for (int row = -kReach; row <= kReach; ++row) cells |= one(number({row, col}));
    return cells;
}
constexpr Cells kWest = column(-kReach);
constexpr Cells kEast = column(kReach);

int count(Cells cells) { return count_bits(lower(cells)) + count_bits(upper(cells)); }

// Removes the first cell of a set and returns its number.
int take(Cells& cells) {
    const int first = lower(cells) ? lowest_bit(lower(cells)) : 64 + lowest_bit(upper(cells));
    cells &= cells - 1;
    return first;
}

Cells moved(Cells cells, int move) {
    if (kColStep[move] > 0) cells = (cells & ~kEast) << 1;
    if (kColStep[move] < 0) cells = (cells & ~kWest) >> 1;
    if (kRowStep[move] > 0) cells = cells << kSide & kAll;
    if (kRowStep[move] < 0) cells >>= kSide;
    return cells;
}

// ---- What an agent sees ------------------------------------------------------------------------

struct View {
    View(const World& world, const Sight& sight)
        : n_actions(world.config().n_actions()), reach(std::min(world.config().fov / 2, kReach)) {
        for (Offset at : sight.adversaries()) {
            if (fits(at)) adversaries |= one(number(at));
        }
        for (Offset at : sight.teammates()) {
            if (fits(at)) teammates |= one(number(at));
        }
        teammates &= ~kMe;  // who shares the agent's cell tells it nothing
        for (int row = -reach; row <= reach; ++row) {
            for (int col = -reach; col <= reach; ++col) {
                seen |= one(number({row, col}));
                if (sight.is_blocked({row, col})) blocked |= one(number({row, col}));
            }
        }
        loose = teammates & ~beside(adversaries);
    }

    Cells beside(Cells cells) const {
        Cells all = 0;
        for (int move = 1; move < n_actions; ++move) all |= moved(cells, move);
        return all;
    }
    // The sides of an adversary that are neither obstacles nor held by anybody.
    Cells open_sides(Cells adversary) const {
        return beside(adversary) & ~(blocked | adversaries | teammates | kMe);
    }
    // Is the border, or a wall at least three cells wide, so many steps away?
    bool is_border(int move, int steps) const {
        const Cells there = one(number(step(move, steps)));
        const int aside = move % 4 + 1;
        return !((there | moved(there, aside) | moved(there, kOpposite[aside])) & ~blocked);
    }
    int moves(Offset from, Offset to) const {
        const int rows = std::abs(from.row - to.row);
        const int cols = std::abs(from.col - to.col);
        return n_actions > kCompassMoves ? std::max(rows, cols) : rows + cols;
    }

    int n_actions;
    int reach;
    Cells adversaries = 0;
    Cells teammates = 0;
    Cells blocked = 0;
    Cells seen = 0;
    Cells loose = 0;  // teammates that hold no adversary
};

// An event of a probability in 256ths, from eight bits of a draw.
bool happens(std::uint32_t bits, int of_256) { return static_cast<int>(bits & 255) < of_256; }

constexpr int kForbidden = -1000;  // worth less than to stay, whatever that is worth

// ---- Hold --------------------------------------------------------------------------------------

constexpr int kRelease = 128;  // of 256
constexpr int kShift = 8;

// Two adversaries side by side cannot be surrounded. Where they have no side left to part by, their
// holders give way at times. To an open side of another adversary a holder moves on at times, since
// nobody else may reach it, and leaves its own side to those behind.
void rate_as_holder(const View& view, std::uint32_t draw, int* worth) {
    const Cells held = view.beside(kMe) & view.adversaries;
    for (Cells rest = held; rest && happens(draw, kRelease);) {
        const Cells adversary = one(take(rest));
        if (!(view.beside(adversary) & view.adversaries) || view.open_sides(adversary)) continue;
        std::fill_n(worth + 1, view.n_actions - 1, 1);
        return;
    }
    for (int move = 1; move < view.n_actions; ++move) {
        worth[move] = kForbidden;
        const Cells others = view.beside(after(move)) & view.adversaries;
        if (!(others & ~held) || (view.beside(others) & view.adversaries)) continue;
        const int gain = count(others) - count(held);
        const int chance = gain > 0 ? 128 : gain == 0 ? kShift : kShift / 4;
        if (happens(draw >> 8, chance)) worth[move] = 1 + count(others);
    }
}

// ---- Allocate ----------------------------------------------------------------------------------

constexpr int kMostAdversaries = 8;  // the nearest ones share
constexpr int kMostRunners = 16;     // the nearest ones, the agent among them
constexpr int kPerMove = 4;          // cost of a move, in which the others are measured
constexpr int kExit = 8;             // cost of the side to which an adversary shall flee,
constexpr int kBehind = 4;           // and gain of the opposite side

// Lists the members of a set that are nearest to the agent, in the order of their numbers, which is
// the same for all that see them.
int list_nearest(const View& view, Cells cells, int most, int* out) {
    int n = 0;
    while (cells) out[n++] = take(cells);
    if (n <= most) return n;
    const auto far = [&](int a) { return view.moves({0, 0}, offset(a)) * kSide * kSide + a; };
    std::nth_element(out, out + most, out + n, [&](int a, int b) { return far(a) < far(b); });
    std::sort(out, out + most);
    return most;
}

// The direction in which an adversary shall be driven while it is not yet surrounded: to the
// nearest obstacle or border, beside which fewer pursuers are needed.
int find_exit(const View& view, Offset adversary) {
    for (int steps = 1; steps < kSide; ++steps) {
        for (int move = 1; move < kCompassMoves; ++move) {
            const Offset at{adversary.row + kRowStep[move] * steps,
                            adversary.col + kColStep[move] * steps};
            if (fits(at) && (view.blocked & one(number(at)))) return move;
        }
    }
    return 3;  // south: everybody drives it the same way
}

int cost_of_side(const View& view, Offset adversary, int exit, Offset runner, Offset side) {
    int moves = view.moves(runner, side);
    // Straight through the adversary there is no way.
    const bool around = view.n_actions == kCompassMoves &&
                        (runner.row - adversary.row) * (side.col - adversary.col) ==
                            (runner.col - adversary.col) * (side.row - adversary.row) &&
                        (runner.row - adversary.row) * (side.row - adversary.row) +
                                (runner.col - adversary.col) * (side.col - adversary.col) <
                            0;
    if (around) moves += 2;
    const bool is_exit =
        side.row == adversary.row + kRowStep[exit] && side.col == adversary.col + kColStep[exit];
    const bool is_behind =
        side.row == adversary.row - kRowStep[exit] && side.col == adversary.col - kColStep[exit];
    return kPerMove * moves + (is_exit ? kExit : 0) - (is_behind ? kBehind : 0);
}

// The side that the agent gets when runners share the sides of an adversary at the least cost, as
// far as exchanges of two lower it; -1 for none.
int share_sides(const View& view, int adversary, Cells open, const int* runners, int n_runners) {
    const Offset at = offset(adversary);
    const int exit = find_exit(view, at);
    int sides[kDiagonalMoves];
    int n_sides = 0;
    while (open) sides[n_sides++] = take(open);
    int cost[kDiagonalMoves][kDiagonalMoves];  // by place and side; without a runner it is nothing
    for (int i = 0; i < n_sides; ++i) {
        for (int s = 0; s < n_sides; ++s) {
            cost[i][s] = i < n_runners
                             ? cost_of_side(view, at, exit, offset(runners[i]), offset(sides[s]))
                             : 0;
        }
    }
    int side_of[kDiagonalMoves];
    for (int i = 0; i < n_sides; ++i) side_of[i] = i;
    for (bool better = true; better;) {
        better = false;
        for (int i = 0; i < n_sides; ++i) {
            for (int j = 0; j < i; ++j) {
                const int a = side_of[i];
                const int b = side_of[j];
                if (cost[i][b] + cost[j][a] >= cost[i][a] + cost[j][b]) continue;
                std::swap(side_of[i], side_of[j]);
                better = true;
            }
        }
    }
    for (int i = 0; i < n_runners; ++i) {
        if (one(runners[i]) == kMe) return sides[side_of[i]];
    }
    return -1;
}

// The side that is the agent's, or -1. The nearest pair of an adversary with open sides and a
// runner comes first, and so on.
int allocate(const View& view, Cells open) {
    int adversaries[kSide * kSide];
    int runners[kSide * kSide];
    const int n_adversaries =
        list_nearest(view, view.beside(open) & view.adversaries, kMostAdversaries, adversaries);
    const int n_runners = list_nearest(view, view.loose | kMe, kMostRunners, runners);
    Cells sides[kMostAdversaries];
    int left[kMostAdversaries];  // sides without a runner
    int members[kMostAdversaries][kDiagonalMoves];
    int n_members[kMostAdversaries] = {};
    for (int a = 0; a < n_adversaries; ++a) {
        sides[a] = view.beside(one(adversaries[a])) & open;
        left[a] = count(sides[a]);
    }
    bool used[kMostRunners] = {};
    int mine = -1;
    for (;;) {
        int best = -1;
        int best_runner = 0;
        int least = 0;
        for (int a = 0; a < n_adversaries; ++a) {
            if (left[a] == 0) continue;
            for (int r = 0; r < n_runners; ++r) {
                if (used[r]) continue;
                const int moves = view.moves(offset(adversaries[a]), offset(runners[r]));
                if (best >= 0 && moves >= least) continue;
                best = a;
                best_runner = r;
                least = moves;
            }
        }
        if (best < 0) break;
        used[best_runner] = true;
        --left[best];
        members[best][n_members[best]++] = runners[best_runner];
        if (one(runners[best_runner]) == kMe) mine = best;
    }
    if (mine < 0) return -1;
    std::sort(members[mine], members[mine] + n_members[mine]);
    return share_sides(view, adversaries[mine], sides[mine], members[mine], n_members[mine]);
}

// ---- Approach ----------------------------------------------------------------------------------

// Rates moves by the way that is left to a side, around obstacles, adversaries and their holders.
// Returns whether there is one in view.
bool rate_way(const View& view, int side, int* worth) {
    const Cells free =
        view.seen & ~(view.blocked | view.adversaries | (view.teammates & ~view.loose));
    Cells reached = 0;
    Cells wave = one(side);
    const Cells wanted = (view.beside(kMe) | kMe) & free;
    std::fill_n(worth, view.n_actions, kForbidden);
    for (int moves = 0; wave && (wanted & ~reached); ++moves) {
        reached |= wave;
        for (int move = 0; move < view.n_actions; ++move) {
            if (wave & after(move)) worth[move] = -moves;
        }
        wave = view.beside(wave) & free & ~reached;
    }
    return static_cast<bool>(reached & kMe);
}

// ---- Search ------------------------------------------------------------------------------------

constexpr int kSpacing = 3;     // cells from one to the next in a line
constexpr int kSidestep = 8;    // steps for which it passes obstacles on the same hand
constexpr long kFewInView = 2;  // agents of a team in a view, on average, up to which lines pay

// A way across the grid from where one border is seen to where the other one is.
struct Crossing {
    Crossing(const Config& config, int reach)
        : side(std::max(config.rows, config.cols)), steps(std::max(1, side - 2 * reach + 1)) {}
    int side;
    int steps;
};

int right_of(int move) { return move % 4 + 1; }

// Goes on, past whatever is in the way.
void rate_onwards(int move, int hand, int* worth) {
    worth[0] = 1;
    worth[move] = 4;
    worth[hand ? right_of(move) : kOpposite[right_of(move)]] = 3;
    worth[hand ? kOpposite[right_of(move)] : right_of(move)] = 2;
}

// Components of an offset along two moves.
int along(Offset at, int move) { return at.row * kRowStep[move] + at.col * kColStep[move]; }

// A team first takes its place at a border, one behind the other from a corner on. Then it crosses
// the grid abreast, changes to the other half, crosses back, and so on. Each team begins at another
// border.
class Line {
  public:
    Line(const World& world, const View& view, int agent, int* worth)
        : view_(view), worth_(worth), crossing_(world.config(), view.reach) {
        const Config& config = world.config();
        const int team_size = config.n_actions() - 1;
        const bool pursues = world.team(agent) == Team::Pursuer;
        const int own = pursues ? agent : agent - config.n_pursuers;
        team_ = own / team_size;
        alone_ = (pursues ? config.n_pursuers : config.n_evaders) <= team_size;
        hand_ = (agent + world.steps() / kSidestep) % 2;
        time_ = world.steps() - (crossing_.side - view.reach + 1);
    }

    // After a round the teams are in pieces: then agents do better on their own, but for one team.
    bool is_over() const { return !alone_ && time_ >= round(); }

    void rate() {
        if (time_ < 0) return queue(4, 1);
        const int time = time_ % round();
        const bool returns = time >= round() / 2;
        const int ahead = returns ? 4 : 2;
        if (time % (round() / 2) < crossing_.steps) return sweep(ahead);
        queue(ahead, returns ? 1 : 3);
    }

  private:
    // Steps until a team is where it began: it crosses and changes twice.
    int round() const { return 2 * (crossing_.steps + std::max(1, crossing_.steps - kSpacing)); }
    // As the team turns the plan, which is written for the first one.
    int turned(int move) const {
        if (team_ / 4 % 2 && move % 2) move = kOpposite[move];
        return (move - 1 + team_) % 4 + 1;
    }
    bool sees_border(int move) const { return view_.is_border(move, view_.reach); }
    bool is_near_border(int move) const { return view_.is_border(move, view_.reach - 1); }
    // In every second round a single team spreads, so that three of it see the whole grid, too.
    int spacing() const {
        return alone_ && time_ >= 0 && time_ / round() % 2 ? kSpacing + 1 : kSpacing;
    }

    void queue(int home, int forward) {
        home = turned(home);
        forward = turned(forward);
        worth_[0] = 1;
        if (time_ >= 0 && wait(home, 3)) return;
        if (is_near_border(home)) worth_[kOpposite[home]] = 8;
        if (!sees_border(home)) {
            worth_[home] = 8;
            return;
        }
        int gap = kSide;  // to the next teammate ahead
        for (Cells rest = view_.loose; rest;) {
            const Offset at = offset(take(rest));
            const int ahead = along(at, forward);
            const int out = along(at, home);
            if (std::abs(out) <= 2 && (ahead > 0 || (ahead == 0 && out > 0)))
                gap = std::min(gap, ahead);
        }
        if (is_near_border(forward) || gap < spacing()) {
            worth_[kOpposite[forward]] = 4;
        } else if (!sees_border(forward) && gap > spacing()) {
            worth_[forward] = 4;
        }
    }

    void sweep(int move) {
        move = turned(move);
        worth_[0] = 1;
        if (wait(move, 1)) return;
        if (!sees_border(move)) return rate_onwards(move, hand_, worth_);
        if (is_near_border(move)) worth_[kOpposite[move]] = 4;
    }

    // A single team stays together. A teammate that falls `least` cells behind has found something:
    // the others close up to it, and to the nearest one if it goes aside. Returns whether they do.
    bool wait(int move, int least) {
        if (!alone_) return false;
        const int right = right_of(move);
        int lag = 0;
        int apart = kSide;
        Offset last{0, 0};
        Offset nearest{0, 0};
        for (Cells rest = view_.teammates; rest;) {
            const Offset at = offset(take(rest));
            if (-along(at, move) > lag) {
                lag = -along(at, move);
                last = at;
            }
            if (std::abs(along(at, right)) < apart) {
                apart = std::abs(along(at, right));
                nearest = at;
            }
        }
        const bool waits = lag >= least;
        const int aside = along(waits ? last : nearest, right);
        if (std::abs(aside) > (waits ? 2 : spacing() + 1)) {
            worth_[aside > 0 ? right : kOpposite[right]] = 4;
            return true;
        }
        if (waits && lag > 2) worth_[kOpposite[move]] = 4;
        return waits;
    }

    const View& view_;
    int* worth_;
    Crossing crossing_;
    int time_;  // steps since the teams began to cross
    int team_;
    bool alone_;  // all teammates are of this team
    int hand_;
};

// To and fro across the grid, one view further each time, and back again after the last one. Where
// an agent is in this plan, and how the plan lies, is drawn once.
void mow(const World& world, const View& view, int agent, int* worth) {
    const Crossing crossing(world.config(), view.reach);
    const int aside = 2 * view.reach + 1;
    const int n_swaths = std::max(1, (crossing.side - 1) / aside);
    const Block draws = world.key().block(Purpose::Walk, agent, 0);
    const int time = world.steps() + below(draws[0], 2 * n_swaths * (crossing.steps + aside));
    const int swath = time / (crossing.steps + aside);
    const auto flag = [&](int bit) { return static_cast<int>(draws[1] >> bit & 1); };
    const int first = flag(0) ? 1 : 2;
    const int ahead = (swath + flag(1)) % 2 ? first : kOpposite[first];
    const int shift = (swath / n_swaths + flag(2)) % 2 ? 3 - first : kOpposite[3 - first];
    worth[0] = 1;
    for (int move = 1; move < kCompassMoves; ++move) {
        if (view.is_border(move, view.reach - 1)) worth[kOpposite[move]] += 4;
    }
    const bool crosses = time % (crossing.steps + aside) < crossing.steps;
    if (crosses && !view.is_border(ahead, view.reach)) {
        worth[ahead] += 8;
        worth[shift] += 3;
        worth[kOpposite[shift]] += 2;
    } else if (!view.is_border(shift, view.reach)) {
        worth[shift] += 8;
    }
}

void search(const World& world, const View& view, int agent, int* worth) {
    const Config& config = world.config();
    const long n = world.team(agent) == Team::Pursuer ? config.n_pursuers : config.n_evaders;
    const long seen = (2 * view.reach + 1) * (2 * view.reach + 1);
    const long area = static_cast<long>(config.rows) * config.cols;
    if (n * seen < kFewInView * area && !world.terrain().has_obstacles) {
        Line line(world, view, agent, worth);
        if (!line.is_over()) return line.rate();
    }
    mow(world, view, agent, worth);
}

}  // namespace

void rate_for_team(const World& world, const Sight& sight, int agent, std::uint32_t draw,
                   int* worth) {
    const View view(world, sight);
    std::fill_n(worth, view.n_actions, 0);
    if (view.beside(kMe) & view.adversaries) return rate_as_holder(view, draw, worth);

    // The last way out of an adversary beside another one stays open, so that they can part.
    const Cells paired = view.adversaries & view.beside(view.adversaries);
    Cells shut = 0;
    for (Cells rest = paired; rest;) {
        const Cells sides = view.open_sides(one(take(rest)));
        if (count(sides) == 1) shut |= sides;
    }
    shut &= ~view.beside(view.adversaries & ~paired);

    constexpr int kDrift = 128;  // of 256
    const Cells open = view.open_sides(view.adversaries) & view.seen & ~shut;
    const int side = open ? allocate(view, open) : -1;
    if (side < 0 || !rate_way(view, side, worth)) {
        std::fill_n(worth, view.n_actions, 0);
        if (open && happens(draw, kDrift)) {
            std::fill_n(worth + 1, view.n_actions - 1, 1);  // makes room
        } else {
            search(world, view, agent, worth);
        }
    }
    for (int move = 1; move < view.n_actions; ++move) {
        if (shut & after(move)) worth[move] = 2 * kForbidden;
    }
}

std::uint32_t search_moves(const World& world, const Sight& sight, int agent) {
    const View view(world, sight);
    int worth[kDiagonalMoves] = {};
    search(world, view, agent, worth);
    for (int move = 1; move < view.n_actions; ++move) {
        if (view.blocked & after(move)) worth[move] = kForbidden;
    }
    int most = worth[0];
    for (int move = 1; move < view.n_actions; ++move) most = std::max(most, worth[move]);
    std::uint32_t best = 0;
    for (int move = 0; move < view.n_actions; ++move) best |= std::uint32_t{worth[move] == most} << move;
    return best;
}

}  // namespace matrixworld
