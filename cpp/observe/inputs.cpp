#include "observe/inputs.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "kernels/kernels.hpp"

namespace matrixworld {

const InputText (&input_texts()) [kInputs] {
    static const InputText all[kInputs] = {
        {"adversary", "distance to the nearest adversary", "half views", 2},
        {"pressure", "sum over adversaries of 1 / (1 + moves)^2", "", 0},
        {"unclaimed",
         "distance to the nearest adversary to which no teammate is nearer than the agent; if "
         "there "
         "is none, to the nearest one",
         "half views", 2},
        {"open_side",
         "distance to the nearest cell beside an adversary without an obstacle and teammate",
         "half views", 2},
        {"teammate", "distance to the nearest teammate", "half views", 2},
        {"crowd", "sum over teammates of 1 / (1 + moves)^2", "", 0},
        {"exits", "share of the cells around that are no obstacle", "", 1},
        {"room", "distance to the nearest obstacle to the north, east, south or west", "half views",
         1},
        {"must_yield", "1 if right of way forbids the move", "", 1},
        {"stay", "1 if it is no move", "", 1},
        {"ahead", "1 if it is the direction that the agent draws for each 12 steps", "", 1},
    };
    return all;
}

int stride_of(const World& world, int agent, int steps) {
    const Block block = world.key().block(Purpose::Walk, agent, world.steps() / steps);
    return 1 + below(block[0], world.config().n_actions() - 1);
}

namespace {

// Ground is kept for grids of up to this many cells (13 MiB). On larger ones it is found anew for
// each agent and step.
constexpr int kMostGround = 1 << 17;

// Numbers of all moves: n vectors.
template <int n>
struct ByMove {
    using Vec = Lanes<float, 4>;

    static ByMove of(float number) {
        ByMove row;
        for (Vec& part : row.parts) part = splat<Vec>(number);
        return row;
    }
    static ByMove of(const Inputs::Row& numbers) {
        ByMove row;
        std::memcpy(row.parts, numbers, sizeof(row.parts));
        return row;
    }
    void least(const Inputs::Row& numbers) {
        const ByMove other = of(numbers);
        for (int i = 0; i < n; ++i)
            parts[i] = where(other.parts[i] < parts[i], other.parts[i], parts[i]);
    }
    void add(const Inputs::Row& numbers) {
        const ByMove other = of(numbers);
        for (int i = 0; i < n; ++i) parts[i] += other.parts[i];
    }
    void write(float scale, Inputs::Row& out) const {
        for (int i = 0; i < n; ++i) {
            const Vec scaled = parts[i] * splat<Vec>(scale);
            std::memcpy(out + 4 * i, &scaled, sizeof(scaled));
        }
    }

    Vec parts[n];
};

}  // namespace

// ---- Before agents look -------------------------------------------------------------------------

Inputs::Inputs(const Config& config)
    : config_(config),
      n_moves_(config.n_actions()),
      half_(config.fov / 2),
      unit_(2.0f / static_cast<float>(config.fov)),
      view_(static_cast<std::size_t>(config.fov) * config.fov),
      taken_(view_.size()),
      crowd_(config),
      places_(static_cast<std::size_t>(config.n_agents())),
      strides_(static_cast<std::size_t>(config.n_agents())),
      seen_(kTeams * view_.size()) {
    constexpr int kCharge = 1 << 14;
    for (std::size_t i = 0; i < view_.size(); ++i) {
        Seen& seen = view_[i];
        seen.row = static_cast<int>(i) / config.fov - half_;
        seen.col = static_cast<int>(i) % config.fov - half_;
        for (int lane = 0; lane < kLanes; ++lane) {
            const int move = lane < kDiagonalMoves ? lane : 0;
            const int rows = std::abs(seen.row - kRowStep[move]);
            const int cols = std::abs(seen.col - kColStep[move]);
            const int moves = config.diagonal ? std::max(rows, cols) : rows + cols;
            seen.moves[lane] = static_cast<float>(moves);
            seen.charge[lane] = static_cast<float>(kCharge / ((1 + moves) * (1 + moves)));
            seen.charge[lane] /= kCharge;
        }
    }
    for (const Team team : {Team::Pursuer, Team::Evader}) {
        const RightOfWay ways(config, team);
        for (int order = 0; order < RightOfWay::kOrders; ++order) {
            for (int move = 1; move < n_moves_; ++move) {
                for (const RightOfWay::Cell& cell : ways.forbidding(order, move)) {
                    if (cell.channel == kObstacles) continue;  // the cell of the move
                    auto& moves = forbids_[static_cast<int>(team)][order][cell.channel];
                    moves[(cell.row + 2) * 5 + cell.col + 2] |= 1 << move;
                }
            }
        }
    }
    for (int lane = 0; lane < kLanes; ++lane) rows_[kStay][lane] = lane == 0;
}

void Inputs::gather(const World& world, const Occupancy& occupancy) {
    world_ = &world;
    occupancy_ = &occupancy;
    if (config_.n_agents() <= kMaxPositions) {
        crowd_.gather(world, occupancy);
        const std::vector<int>& living = world.living();
        for (std::size_t i = 0; i < living.size(); ++i) places_[living[i]] = static_cast<int>(i);
    }
    order_ = RightOfWay::order(world.steps());
    if (wants(kAhead)) draw_strides();
    if (world.shared_terrain() == terrain_) return;
    const int n_cells = world.grid().n_cells();
    const bool keeps = n_cells <= kMostGround;
    if (!terrain_) ground_.reset(new Ground[keeps ? n_cells : 1]);
    known_.assign(keeps ? static_cast<std::size_t>(n_cells) : 0, 0);
    terrain_ = world.shared_terrain();
}

void Inputs::draw_strides() {
    const int stride = world_->steps() / kStride;
    const EpisodeKey key = world_->key();
    if (stride == stride_ && key.seed == stride_key_.seed && key.episode == stride_key_.episode)
        return;
    stride_ = stride;
    stride_key_ = key;
    for (std::size_t a = 0; a < strides_.size(); ++a) {
        strides_[a] = static_cast<std::uint8_t>(stride_of(*world_, static_cast<int>(a)));
    }
}

// ---- Obstacles ----------------------------------------------------------------------------------

const Inputs::Ground& Inputs::ground(int cell) {
    if (known_.empty()) {
        survey(cell, ground_[0]);
        return ground_[0];
    }
    if (!known_[cell]) survey(cell, ground_[cell]);
    known_[cell] = 1;
    return ground_[cell];
}

// What is out of view is not known, and counts as free.
void Inputs::survey(int cell, Ground& ground) const {
    const int row = world_->grid().row(cell), col = world_->grid().col(cell);
    const Plane& blocked = terrain_->blocked;
    const auto is_blocked = [&](int r, int c) {
        return std::abs(r) <= half_ && std::abs(c) <= half_ && *blocked.window(row + r, col + c);
    };
    ground = {};
    for (int move = 0; move < n_moves_; ++move) {
        const int r = kRowStep[move], c = kColStep[move];
        int n_exits = 0;
        int room = half_;
        for (int side = 1; side < n_moves_; ++side) {
            n_exits += !is_blocked(r + kRowStep[side], c + kColStep[side]);
        }
        for (int side = 1; side < kCompassMoves; ++side) {
            for (int k = 0; k < room; ++k) {
                if (is_blocked(r + k * kRowStep[side], c + k * kColStep[side])) room = k;
            }
        }
        ground.exits[move] = static_cast<float>(n_exits) / static_cast<float>(n_moves_ - 1);
        ground.room[move] = unit_ * static_cast<float>(room);
        if (move > 0 && is_blocked(r, c)) ground.blocked |= 1u << move;
    }
}

// ---- Agents in view -----------------------------------------------------------------------------

// Up to kMaxPositions agents are compared with the view; with more, its cells are visited.
int Inputs::list_seen(int agent) {
    if (config_.n_agents() > kMaxPositions) return list_reserved(agent);
    return kernels().list_seen(crowd_.positions(), places_[agent], seen_.data());
}

int Inputs::list_reserved(int agent) {
    const Grid& grid = world_->grid();
    const ReservationTable reservations = occupancy_->reservations();
    const int fov = config_.fov;
    int n = 0;
    for (int r = std::max(-half_, -row_); r <= std::min(half_, grid.rows() - 1 - row_); ++r) {
        for (int c = std::max(-half_, -col_); c <= std::min(half_, grid.cols() - 1 - col_); ++c) {
            const int cell = grid.cell(row_ + r, col_ + c);
            if (reservations.empty(cell)) continue;
            for (const Team team : {Team::Pursuer, Team::Evader}) {
                const int self = r == 0 && c == 0 && team == world_->team(agent);
                if (reservations.at(cell, team).count() <= self) continue;
                seen_[n++] = (channel(team) * fov + r + half_) * fov + c + half_;
            }
        }
    }
    return n;
}

template <int n>
void Inputs::look(int agent) {
    const int cell = world_->cell(agent);
    row_ = world_->grid().row(cell);
    col_ = world_->grid().col(cell);
    const Ground& ground = this->ground(cell);
    blocked_ = forbidden_ = ground.blocked;

    const auto nobody = ByMove<n>::of(static_cast<float>(config_.fov));
    auto adversary = nobody, teammate = nobody;
    auto pressure = ByMove<n>::of(0), crowd = pressure;
    adversaries_.clear();
    teammates_.clear();
    const int area = static_cast<int>(view_.size());
    const Team team = world_->team(agent);
    const int own = channel(team);
    const auto& forbids = forbids_[static_cast<int>(team)][order_];
    const int n_seen = list_seen(agent);
    for (int i = 0; i < n_seen; ++i) {
        const int other = seen_[i] >= area;  // channel
        const Seen& seen = view_[seen_[i] - other * area];
        if (other == own) {
            teammate.least(seen.moves);
            crowd.add(seen.charge);
            teammates_.push_back(&seen);
        } else {
            adversary.least(seen.moves);
            pressure.add(seen.charge);
            adversaries_.push_back(&seen);
        }
        if (wants(kMustYield) && std::abs(seen.row) <= 2 && std::abs(seen.col) <= 2) {
            forbidden_ |= forbids[other][(seen.row + 2) * 5 + seen.col + 2];
        }
    }
    adversary.write(unit_, rows_[kAdversary]);
    pressure.write(1, rows_[kPressure]);
    teammate.write(unit_, rows_[kTeammate]);
    crowd.write(1, rows_[kCrowd]);
    if (wants(kUnclaimed)) find_unclaimed<n>();
    if (wants(kOpenSide)) find_open_sides<n>();
    std::memcpy(rows_[kExits], ground.exits, sizeof(Row));
    std::memcpy(rows_[kRoom], ground.room, sizeof(Row));
    for (int move = 0; move < n_moves_; ++move) {
        rows_[kMustYield][move] = static_cast<float>(forbidden_ >> move & 1);
        rows_[kAhead][move] = move == strides_[agent];
    }
}

int Inputs::moves_between(const Seen& a, const Seen& b) const {
    const int rows = std::abs(a.row - b.row), cols = std::abs(a.col - b.col);
    return config_.diagonal ? std::max(rows, cols) : rows + cols;
}

template <int n>
void Inputs::find_unclaimed() {
    auto nearest = ByMove<n>::of(static_cast<float>(config_.fov));
    bool any = false;
    for (const Seen* adversary : adversaries_) {
        const int own = static_cast<int>(adversary->moves[0]);
        const auto is_nearer = [&](const Seen* teammate) {
            return moves_between(*teammate, *adversary) < own;
        };
        if (std::any_of(teammates_.begin(), teammates_.end(), is_nearer)) continue;
        nearest.least(adversary->moves);
        any = true;
    }
    if (any) {
        nearest.write(unit_, rows_[kUnclaimed]);
    } else {
        std::memcpy(rows_[kUnclaimed], rows_[kAdversary], sizeof(Row));
    }
}

template <int n>
void Inputs::find_open_sides() {
    auto nearest = ByMove<n>::of(static_cast<float>(config_.fov));
    for (const Seen* teammate : teammates_) taken_[teammate - view_.data()] = 1;
    for (const Seen* adversary : adversaries_) {
        for (int side = 1; side < n_moves_; ++side) {
            const int row = adversary->row + kRowStep[side], col = adversary->col + kColStep[side];
            if (std::abs(row) > half_ || std::abs(col) > half_) continue;
            const Seen* beside = adversary + kRowStep[side] * config_.fov + kColStep[side];
            if (taken_[beside - view_.data()] || *terrain_->blocked.window(row_ + row, col_ + col))
                continue;
            nearest.least(beside->moves);
        }
    }
    for (const Seen* teammate : teammates_) taken_[teammate - view_.data()] = 0;
    nearest.write(unit_, rows_[kOpenSide]);
}

void Inputs::write(const World& world, const Occupancy& occupancy, float* out) {
    const std::size_t size = static_cast<std::size_t>(n_moves_) * kInputs;
    std::fill_n(out, config_.n_agents() * size, 0.0f);
    gather(world, occupancy);
    for (const int agent : world.living()) {
        look(agent);
        float* const own = out + agent * size;
        for (int move = 0; move < n_moves_; ++move) {
            for (int input = 0; input < kInputs; ++input) {
                own[move * kInputs + input] = rows_[input][move];
            }
        }
    }
}

}  // namespace matrixworld
