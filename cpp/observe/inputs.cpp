#include "observe/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

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
        {"exits", "share of the cells around that are no obstacle", "", 1},
        {"room", "distance to the nearest obstacle to the north, east, south or west", "half views",
         1},
        {"must_yield", "1 if right of way forbids the move", "", 1},
        {"ahead", "1 if it is the direction that the agent draws for each 12 steps", "", 1},
        {"search",
         "1 if it leads on along the way on which an agent of team-surrounder searches the grid",
         "", 1},
        {"escapes",
         "share of the cells that an evader may be on after its next move which hold no obstacle "
         "and which no pursuer in view reaches in one move: of the nearest adversary, or an "
         "evader's own",
         "", 1},
        {"opposite",
         "(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the "
         "teammate "
         "nearest to it; for an evader, of the angle at itself between its two nearest adversaries",
         "", 1},
        {"parity", "1 if the distance to the nearest adversary is odd", "", 1},
    };
    return all;
}

int stride_of(const World& world, int agent, int steps) {
    const Block block = world.key().block(Purpose::Walk, agent, world.steps() / steps);
    return 1 + below(block[0], world.config().n_actions() - 1);
}

namespace {

// Places of a near cell, and of any other.
int near_place(int row, int col) {
    const bool is_near = std::max(std::abs(row), std::abs(col)) <= kNear;
    return is_near ? (row + kNear) * kNearSide + col + kNear : kNearCells;
}

}  // namespace

// ---- Before agents look -------------------------------------------------------------------------

MoveInputs::MoveInputs(const Config& config)
    : config_(config),
      n_moves_(config.n_actions()),
      half_(config.fov / 2),
      view_(static_cast<std::size_t>(config.fov) * config.fov),
      taken_(view_.size(), 0),
      sight_(config.fov),
      strides_(static_cast<std::size_t>(config.n_agents())) {
    constexpr int kCharge = 1 << 14;
    const int farthest = 2 * half_ + 1, side = 2 * farthest + 1;  // rows between two cells
    const Grid grid(config.rows, config.cols);
    const auto cell = [&](int row, int col) { return grid.cell(row, col) - grid.cell(0, 0); };
    const auto spot = [&](int row, int col) { return row * side + col; };
    const auto distance = [&](int rows, int cols) {
        rows = std::abs(rows), cols = std::abs(cols);
        return config.diagonal ? std::max(rows, cols) : rows + cols;
    };
    const auto unseen = [&](int row, int col) {
        std::uint32_t moves = 0;
        for (int move = 0; move < n_moves_; ++move) {
            const int rows = std::abs(row + kRowStep[move]), cols = std::abs(col + kColStep[move]);
            if (std::max(rows, cols) > half_) moves |= 1u << move;
        }
        return moves;
    };
    for (std::size_t i = 0; i < view_.size(); ++i) {
        SeenCell& seen = view_[i];
        seen.index = static_cast<int>(i);
        const int row = static_cast<int>(i) / config.fov - half_;
        const int col = static_cast<int>(i) % config.fov - half_;
        seen.cell = cell(row, col);
        seen.spot = spot(row, col);
        seen.near = near_place(row, col);
        seen.unseen = unseen(row, col);
        for (int move = 0; move < n_moves_; ++move) {
            const int moves = distance(row - kRowStep[move], col - kColStep[move]);
            seen.moves[move] = static_cast<float>(moves);
            seen.charge[move] = static_cast<float>(kCharge / ((1 + moves) * (1 + moves)));
            seen.charge[move] /= kCharge;
        }
    }
    for (int row = -farthest; row <= farthest; ++row) {
        for (int col = -farthest; col <= farthest; ++col) {
            Apart& apart = apart_.emplace_back();
            apart.moves = distance(row, col);
            for (int move = 0; move < n_moves_; ++move) {
                const bool is_near = distance(row - kRowStep[move], col - kColStep[move]) <= 1;
                apart.reached |= std::uint32_t{is_near} << move;
            }
            const double length = std::sqrt(static_cast<double>(row * row + col * col));
            apart.row = length > 0 ? static_cast<float>(row / length) : 0;
            apart.col = length > 0 ? static_cast<float>(col / length) : 0;
        }
    }
    for (int move = 0; move < n_moves_; ++move) {
        const int row = kRowStep[move], col = kColStep[move];
        steps_[move] = {cell(row, col), spot(row, col), row * config.fov + col, unseen(row, col)};
    }
    for (int n = 0; n <= n_moves_; ++n) {
        shares_[n] = static_cast<float>(n) / static_cast<float>(n_moves_);
    }
    for (std::uint32_t moves = 0; moves < 1u << kDiagonalMoves; ++moves) {
        const int n_open = count_bits(moves & ((1u << n_moves_) - 1) & ~1u);
        exits_[moves] = static_cast<float>(n_open) / static_cast<float>(n_moves_ - 1);
    }
    for (const Team team : {Team::Pursuer, Team::Evader}) {
        const RightOfWay ways(config, team);
        for (int order = 0; order < RightOfWay::kOrders; ++order) {
            for (int move = 1; move < n_moves_; ++move) {
                for (const RightOfWay::Cell& cell : ways.forbidding(order, move)) {
                    if (cell.channel == kObstacles) continue;  // the cell of the move
                    const bool adversary = cell.channel != channel(team);
                    auto& moves = forbids_[static_cast<int>(team)][order][adversary];
                    moves[near_place(cell.row, cell.col)] |= 1 << move;
                }
            }
        }
    }
    look_.fov = config.fov;
    look_.n_moves = n_moves_;
    look_.n_pursuers = config.n_pursuers;
    look_.unit = 2.0f / static_cast<float>(config.fov);
    look_.view = view_.data();
    look_.steps = steps_;
    look_.apart = apart_.data() + spot(farthest, farthest);  // the middle
    look_.shares = shares_;
    look_.exits = exits_;
    look_.taken = taken_.data();
    want((1u << kInputs) - 1);
}

void MoveInputs::want(std::uint32_t inputs) { look_.wanted = inputs; }

void MoveInputs::gather(const World& world, const Occupancy& occupancy) {
    world_ = &world;
    occupancy_ = &occupancy;
    if (config_.n_agents() <= kMaxPositions) {
        look_.positions = occupancy.position_table().positions();
    }
    order_ = RightOfWay::order(world.steps());
    if (wants(kAhead)) draw_strides();
    if (terrain_ == world.shared_terrain()) return;
    terrain_ = world.shared_terrain();
    survey(*terrain_);
}

// All cells at once, side by side in memory. There the last cells of a row lie beside the first of the
// next one, but the border is between them.
void MoveInputs::survey(const Terrain& terrain) {
    const Grid& grid = terrain.grid;
    const auto n_cells = static_cast<std::size_t>(grid.n_cells());
    open_.assign(n_cells, 0);
    room_.assign(n_cells, 0);
    closed_.assign(n_cells, 0);  // 0 if no obstacle is at most k cells away
    std::uint16_t* const open = open_.data();
    std::uint8_t *const room = room_.data(), *const closed = closed_.data();
    const std::uint8_t* const kind = terrain.kind.data();
    const int first = grid.cell(0, 0), last = grid.cell(grid.rows() - 1, grid.cols() - 1);
    for (int move = 0; move < n_moves_; ++move) {
        const int step = grid.delta(move);
        for (int i = first; i <= last; ++i) {
            open[i - step] |= static_cast<std::uint16_t>((kind[i] == kFree) << move);
        }
    }
    for (int k = 0; k < half_ && 2 * k < grid.rows(); ++k) {
        const int south = grid.cell(k, 0) - first;
        for (int i = first + south; i <= last - south; ++i) {
            closed[i] |= kind[i - k] | kind[i + k] | kind[i - south] | kind[i + south];
            room[i] += closed[i] == 0;
        }
    }
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

// ---- An agent -----------------------------------------------------------------------------------

void MoveInputs::look(int agent, MoveRows& rows) {
    const int cell = world_->cell(agent);
    const Team team = world_->team(agent);
    look_.pursues = team == Team::Pursuer;
    look_.place = agent;
    look_.open = open_.data() + cell;
    look_.room = room_.data() + cell;
    look_.ahead = 1u << strides_[agent];
    look_.forbids = forbids_[static_cast<int>(team)][order_];
    look_.rows = &rows;
    ++look_.number;
    if (look_.positions.n_agents == 0) list_reserved(cell, team);
    const auto cells = [&](int t) {
        return SeenCells{seen_[t].data(), static_cast<int>(seen_[t].size())};
    };
    if (wants(kSearch)) {
        sight_.look(*world_, *occupancy_, agent);
        look_.search = search_moves(*world_, sight_, agent);
    }
    kernels().look_at_moves(look_, cells(0), cells(1));
}

// Among very many agents, the cells of the view are visited.
void MoveInputs::list_reserved(int at, Team own) {
    const Grid& grid = world_->grid();
    const int row = grid.row(at), col = grid.col(at);
    const ReservationTable reservations = occupancy_->reservations();
    for (auto& seen : seen_) seen.clear();
    for (int r = std::max(-half_, -row); r <= std::min(half_, grid.rows() - 1 - row); ++r) {
        for (int c = std::max(-half_, -col); c <= std::min(half_, grid.cols() - 1 - col); ++c) {
            const int cell = grid.cell(row + r, col + c);
            if (reservations.empty(cell)) continue;
            const SeenCell* const seen = &view_[(r + half_) * config_.fov + c + half_];
            const int self = r == 0 && c == 0;
            if (reservations.at(cell, own).count() > self) seen_[0].push_back(seen);
            if (reservations.at(cell, opponent(own)).count() > 0) seen_[1].push_back(seen);
        }
    }
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
