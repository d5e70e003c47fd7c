#include "observe/search.hpp"

#include <algorithm>
#include <cstdlib>

namespace matrixworld {

using namespace near_view;

namespace {

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
    Line(const World& world, const NearView& view, int agent, int* worth)
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

    const NearView& view_;
    int* worth_;
    Crossing crossing_;
    int time_;  // steps since the teams began to cross
    int team_;
    bool alone_;  // all teammates are of this team
    int hand_;
};

// To and fro across the grid, one view further each time, and back again after the last one. Where
// an agent is in this plan, and how the plan lies, is drawn once.
void mow(const World& world, const NearView& view, int agent, int* worth) {
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

}  // namespace

void rate_search(const World& world, const NearView& view, int agent, int* worth) {
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

std::uint32_t search_moves(const World& world, const Sight& sight, int agent) {
    const NearView view(world, sight);
    int worth[kDiagonalMoves] = {};
    rate_search(world, view, agent, worth);
    for (int move = 1; move < view.n_actions; ++move) {
        if (view.blocked & after(move)) worth[move] = -1;  // less than any move is worth
    }
    int most = worth[0];
    for (int move = 1; move < view.n_actions; ++move) most = std::max(most, worth[move]);
    std::uint32_t best = 0;
    for (int move = 0; move < view.n_actions; ++move)
        best |= std::uint32_t{worth[move] == most} << move;
    return best;
}

}  // namespace matrixworld
