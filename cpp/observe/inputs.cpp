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
         "distance to the nearest adversary to which no teammate is nearer than the agent is now; "
         "without one, to the nearest adversary",
         "half views", 2},
        {"open_side",
         "distance to the nearest cell beside an adversary that holds no obstacle and no teammate",
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

// Writes bits of moves as numbers, in vectors: they are read as vectors at once.
void spread(std::uint32_t bits, float (&out)[kMoveLanes]) {
    static constexpr float kNumbers[16][4] = {
        {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 1, 0},
        {0, 1, 1, 0}, {1, 1, 1, 0}, {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1},
        {0, 0, 1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}};
    for (int i = 0; i < kMoveLanes; i += 4) {
        std::memcpy(out + i, kNumbers[bits >> i & 15], sizeof(kNumbers[0]));
    }
}

}  // namespace

// ---- Before agents look -------------------------------------------------------------------------

MoveInputs::MoveInputs(const Config& config)
    : config_(config),
      n_moves_(config.n_actions()),
      half_(config.fov / 2),
      unit_(2.0f / static_cast<float>(config.fov)),
      view_(static_cast<std::size_t>(config.fov) * config.fov),
      taken_(static_cast<std::size_t>(config.fov + 2) * (config.fov + 2), MoveLook::kOutOfView),
      crowd_(config),
      places_(static_cast<std::size_t>(config.n_agents())),
      strides_(static_cast<std::size_t>(config.n_agents())),
      cases_(Grid(config.rows, config.cols), config.fov) {
    constexpr int kCharge = 1 << 14;
    for (std::size_t i = 0; i < view_.size(); ++i) {
        SeenCell& seen = view_[i];
        seen.row = static_cast<int>(i) / config.fov - half_;
        seen.col = static_cast<int>(i) % config.fov - half_;
        seen.place = (seen.row + half_ + 1) * (config.fov + 2) + seen.col + half_ + 1;
        taken_[seen.place] = 0;
        for (int move = 0; move < n_moves_; ++move) {
            const int rows = std::abs(seen.row - kRowStep[move]);
            const int cols = std::abs(seen.col - kColStep[move]);
            const int moves = config.diagonal ? std::max(rows, cols) : rows + cols;
            seen.moves[move] = static_cast<float>(moves);
            seen.charge[move] = static_cast<float>(kCharge / ((1 + moves) * (1 + moves)));
            seen.charge[move] /= kCharge;
        }
    }
    for (const Team team : {Team::Pursuer, Team::Evader}) {
        const RightOfWay ways(config, team);
        for (int order = 0; order < RightOfWay::kOrders; ++order) {
            for (int move = 1; move < n_moves_; ++move) {
                for (const RightOfWay::Cell& cell : ways.forbidding(order, move)) {
                    if (cell.channel == kObstacles) continue;  // the cell of the move
                    const bool adversary = cell.channel != channel(team);
                    auto& moves = forbids_[static_cast<int>(team)][order][adversary];
                    moves[(cell.row + 2) * 5 + cell.col + 2] |= 1 << move;
                }
            }
        }
    }
    for (int move = 0; move < kDiagonalMoves; ++move) {
        const int row = kRowStep[move], col = kColStep[move];
        steps_[move] = {row, col, row * (config.fov + 2) + col};
    }
    look_.fov = config.fov;
    look_.n_moves = n_moves_;
    look_.diagonal = config.diagonal;
    look_.unit = unit_;
    look_.view = view_.data();
    look_.steps = steps_;
    look_.taken = taken_.data();
    want((1u << kInputs) - 1);
}

void MoveInputs::want(std::uint32_t inputs) {
    wanted_ = inputs;
    look_.asks_claims = wants(kUnclaimed);
    look_.asks_sides = wants(kOpenSide);
}

void MoveInputs::gather(const World& world, const Occupancy& occupancy) {
    world_ = &world;
    occupancy_ = &occupancy;
    if (config_.n_agents() <= kMaxPositions) {
        crowd_.gather(world, occupancy);
        look_.positions = crowd_.positions();
        const std::vector<int>& living = world.living();
        for (std::size_t i = 0; i < living.size(); ++i) places_[living[i]] = static_cast<int>(i);
        const int n_pursuers = world.n_living(Team::Pursuer);
        for (int i = 0; i < kMaxPositions / kPositionPad; ++i) {
            const int n = std::min(std::max(n_pursuers - i * kPositionPad, 0), kPositionPad);
            of_team_[0][i] = n < kPositionPad ? (std::uint64_t{1} << n) - 1 : ~std::uint64_t{0};
            of_team_[1][i] = ~of_team_[0][i];
        }
    }
    look_.walls_stride = world.terrain().blocked.stride();
    order_ = RightOfWay::order(world.steps());
    if (wants(kAhead)) draw_strides();
    if (world.shared_terrain() == terrain_) return;
    const int n_cells = world.grid().n_cells();
    const bool keeps = n_cells <= kMostGround;
    if (!terrain_) ground_.reset(new Ground[keeps ? n_cells : 1]);
    known_.assign(keeps ? static_cast<std::size_t>(n_cells) : 0, 0);
    terrain_ = world.shared_terrain();
}

void MoveInputs::draw_strides() {
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

const MoveInputs::Ground& MoveInputs::ground() {
    if (known_.empty()) {
        survey(ground_[0]);
        return ground_[0];
    }
    const int place =
        terrain_->has_obstacles ? world_->grid().cell(row_, col_) : cases_.number(row_, col_);
    if (!known_[place]) survey(ground_[place]);
    known_[place] = 1;
    return ground_[place];
}

// What is out of view is not known, and counts as free.
void MoveInputs::survey(Ground& ground) const {
    const Plane& blocked = terrain_->blocked;
    const auto is_blocked = [&](int r, int c) {
        return std::abs(r) <= half_ && std::abs(c) <= half_ && *blocked.window(row_ + r, col_ + c);
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

// Among very many agents, the cells of the view are visited.
void MoveInputs::list_reserved(int agent) {
    const Grid& grid = world_->grid();
    const ReservationTable reservations = occupancy_->reservations();
    const Team own = world_->team(agent);
    for (auto& seen : seen_) seen.clear();
    for (int r = std::max(-half_, -row_); r <= std::min(half_, grid.rows() - 1 - row_); ++r) {
        for (int c = std::max(-half_, -col_); c <= std::min(half_, grid.cols() - 1 - col_); ++c) {
            const int cell = grid.cell(row_ + r, col_ + c);
            if (reservations.empty(cell)) continue;
            const SeenCell* const seen = &view_[(r + half_) * config_.fov + c + half_];
            const int self = r == 0 && c == 0;
            if (reservations.at(cell, own).count() > self) seen_[0].push_back(seen);
            if (reservations.at(cell, opponent(own)).count() > 0) seen_[1].push_back(seen);
        }
    }
}

void MoveInputs::look(int agent, MoveRows& rows) {
    const int cell = world_->cell(agent);
    row_ = world_->grid().row(cell);
    col_ = world_->grid().col(cell);
    const Team team = world_->team(agent);
    look_.place = places_[agent];
    for (const int t : {0, 1}) {
        const Team seen = t == 0 ? team : opponent(team);
        look_.first[t] = channel(seen) * static_cast<int>(view_.size());
        look_.of_team[t] = of_team_[static_cast<int>(seen)];
    }
    look_.walls = terrain_->blocked.window(row_, col_);
    const auto& forbids = forbids_[static_cast<int>(team)][order_];
    look_.forbids = wants(kMustYield) ? forbids : nullptr;
    ++look_.number;
    if (look_.positions.n_agents == 0) list_reserved(agent);
    const auto cells = [&](int t) {
        return SeenCells{seen_[t].data(), static_cast<int>(seen_[t].size())};
    };
    const Ground& ground = this->ground();
    rows.blocked = rows.forbidden = ground.blocked;
    look_.rows = &rows;
    kernels().look_at_moves(look_, cells(0), cells(1));
    std::memcpy(rows.of[kExits], ground.exits, sizeof(ground.exits));
    std::memcpy(rows.of[kRoom], ground.room, sizeof(ground.room));
    if (wants(kMustYield)) spread(rows.forbidden, rows.of[kMustYield]);
    spread(1, rows.of[kStay]);
    if (wants(kAhead)) spread(1u << strides_[agent], rows.of[kAhead]);
}

void MoveInputs::write(const World& world, const Occupancy& occupancy, float* out) {
    const std::size_t size = static_cast<std::size_t>(n_moves_) * kInputs;
    std::fill_n(out, config_.n_agents() * size, 0.0f);
    gather(world, occupancy);
    MoveRows rows{};
    for (const int agent : world.living()) {
        look(agent, rows);
        float* const own = out + agent * size;
        for (int move = 0; move < n_moves_; ++move) {
            for (int input = 0; input < kInputs; ++input) {
                own[move * kInputs + input] = rows.of[input][move];
            }
        }
    }
}

}  // namespace matrixworld
