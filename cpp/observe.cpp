#include "observe.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "kernels.hpp"

namespace matrixworld {

namespace {

constexpr int kChunk = Board::kMaxWidth;  // cells of a row that are read at once

struct Window {
    Window(const World& world, int agent)
        : fov(world.config().fov),
          top(world.grid().row(world.cell(agent)) - fov / 2),
          left(world.grid().col(world.cell(agent)) - fov / 2) {}

    int fov;
    int top;
    int left;
};

// Is the agent alone of its team on its cell? Then the centre of its own channel stays empty.
bool alone(const World& world, const Occupancy& occupancy, int agent) {
    return occupancy.count(world.cell(agent), world.team(agent)) == 1;
}

int own_centre(const World& world, int agent) {
    const int fov = world.config().fov;
    const int channel = world.team(agent) == Team::Pursuer ? kPursuers : kEvaders;
    return (channel * fov + fov / 2) * fov + fov / 2;
}

// Calls visit(index of the first cell, bits) for the windows of a board, row by row.
template <typename Visit>
void for_each_chunk(const Board& board, const Window& window, Visit visit) {
    for (int r = 0; r < window.fov; ++r) {
        for (int c = 0; c < window.fov; c += kChunk) {
            const int width = std::min(kChunk, window.fov - c);
            const Board::Reader reader = board.window(window.top + r, window.left + c);
            visit(r * window.fov + c, reader.row(0, width));
        }
    }
}

}  // namespace

// ---- Bytes and floats ---------------------------------------------------------------------------

Lens::Lens(const Grid& grid, int fov)
    : planes_{Plane(grid, fov / 2, 0), Plane(grid, fov / 2, 0)}, fov_(fov) {}

namespace {

void copy_piece(const std::uint8_t* from, std::uint8_t* to) {
    std::memcpy(to, from, Plane::kPiece);
}

void copy_piece(const std::uint8_t* from, float* to) {
    std::array<std::uint8_t, Plane::kPiece>
        piece;  // so that the compiler sees that `to` is elsewhere
    std::memcpy(piece.data(), from, piece.size());
    for (std::size_t i = 0; i < piece.size(); ++i) to[i] = piece[i];
}

// Appends a window row by row, in whole pieces as long as there is room before `end`: what a piece
// has too much, the next row writes over.
template <int kFov, typename Number>
Number* copy_window(const Plane& plane, const Window& window, Number* out, const Number* end) {
    constexpr int kPiece = Plane::kPiece;
    const int fov = kFov ? kFov : window.fov;  // kFov where the compiler is to know it
    const std::uint8_t* row = plane.window(window.top, window.left);
    for (int r = 0; r < fov; ++r, row += plane.stride(), out += fov) {
        for (int c = 0; c < fov; c += kPiece) {
            if (end - (out + c) >= kPiece) {
                copy_piece(row + c, out + c);
            } else {
                for (int i = c; i < std::min(c + kPiece, fov); ++i) out[i] = row[i];
            }
        }
    }
    return out;
}

// The channels evaders, pursuers, obstacles.
template <int kFov, typename Number>
void copy_channels(const Plane (&teams)[kTeams], const Plane& walls, const Window& window,
                   Number* out) {
    const Number* end = out + kChannels * window.fov * window.fov;
    out = copy_window<kFov>(teams[static_cast<int>(Team::Evader)], window, out, end);
    out = copy_window<kFov>(teams[static_cast<int>(Team::Pursuer)], window, out, end);
    copy_window<kFov>(walls, window, out, end);
}

}  // namespace

template <typename Number>
void Lens::write(const World& world, const Occupancy& occupancy, Number* out) {
    constexpr int kUsual = 11;
    mark(world, 1);
    const int size = kChannels * fov_ * fov_;
    for (int a = 0; a < world.config().n_agents(); ++a, out += size) {
        if (!world.alive(a)) {
            std::fill_n(out, size, Number{0});
            continue;
        }
        const Window window(world, a);
        const auto copy = fov_ == kUsual ? copy_channels<kUsual, Number> : copy_channels<0, Number>;
        copy(planes_, world.ground().closed, window, out);
        if (alone(world, occupancy, a)) out[own_centre(world, a)] = 0;
    }
    mark(world, 0);
}

template void Lens::write(const World&, const Occupancy&, std::uint8_t*);
template void Lens::write(const World&, const Occupancy&, float*);

void Lens::mark(const World& world, std::uint8_t value) {
    for (int a : world.living()) {
        const int cell = world.cell(a);
        const int team = static_cast<int>(world.team(a));
        planes_[team].at(world.grid().row(cell), world.grid().col(cell)) = value;
    }
}

// ---- Lists ------------------------------------------------------------------------------------

namespace {

// Lists the cells that are set in the window of one board, numbered from `first`. The centre is
// left out where `hide_centre`; several rows are read to a word.
template <int kFov>
int* list_narrow(const Board& board, const Window& window, int first, bool hide_centre, int* out) {
    const int fov = kFov ? kFov : window.fov;  // kFov where the compiler is to know it
    const int rows_a_word = 64 / fov;
    const Board::Reader reader = board.window(window.top, window.left);
    for (int r = 0; r < fov; r += rows_a_word) {
        std::uint64_t bits = 0;
        for (int i = 0; i < rows_a_word && r + i < fov; ++i) {
            bits |= reader.row(r + i, fov) << (i * fov);
        }
        if (hide_centre && r <= fov / 2 && fov / 2 < r + rows_a_word) {
            bits &= ~(std::uint64_t{1} << (fov * fov / 2 - r * fov));
        }
        for (; bits; bits &= bits - 1) *out++ = first + r * fov + __builtin_ctzll(bits);
    }
    return out;
}

int* list_wide(const Board& board, const Window& window, int first, bool hide_centre, int* out) {
    const int centre = window.fov * window.fov / 2;
    for_each_chunk(board, window, [&](int index, std::uint64_t bits) {
        for (; bits; bits &= bits - 1) {
            const int place = index + __builtin_ctzll(bits);
            if (!(hide_centre && place == centre)) *out++ = first + place;
        }
    });
    return out;
}

int* list_board(const Board& board, const Window& window, int first, bool hide_centre, int* out) {
    constexpr int kUsual = 11;
    if (window.fov == kUsual) return list_narrow<kUsual>(board, window, first, hide_centre, out);
    if (window.fov <= kChunk) return list_narrow<0>(board, window, first, hide_centre, out);
    return list_wide(board, window, first, hide_centre, out);
}

int* list_places(const World& world, const Occupancy& occupancy, int agent, int* out) {
    const int fov = world.config().fov;
    const int row = occupancy.rows()[agent];
    const int col = occupancy.cols()[agent];
    int seen[Occupancy::kFewAgents];
    const int n = kernels().find_near(occupancy.rows(), occupancy.cols(), occupancy.n_agents(), row,
                                      col, fov / 2, seen);
    int* const begin = out;
    for (int i = 0; i < n; ++i) {
        const int other = seen[i];
        const int channel = world.team(other) == Team::Pursuer ? kPursuers : kEvaders;
        const int down = occupancy.rows()[other] - row + fov / 2;
        const int right = occupancy.cols()[other] - col + fov / 2;
        const int input = (channel * fov + down) * fov + right;
        const bool several = occupancy.count(world.cell(other), world.team(other)) > 1;
        if (several && std::find(begin, out, input) != out) continue;  // one bit for all of them
        *out = input;
        out += other != agent;
    }
    return out;
}

int* list_boards(const World& world, const Occupancy& occupancy, int agent, int* out) {
    const Window window(world, agent);
    const int area = window.fov * window.fov;
    const bool hide = alone(world, occupancy, agent);
    const bool pursuer = world.team(agent) == Team::Pursuer;
    out = list_board(occupancy.board(Team::Evader), window, kEvaders * area, hide && !pursuer, out);
    return list_board(occupancy.board(Team::Pursuer), window, kPursuers * area, hide && pursuer,
                      out);
}

}  // namespace

int list_view(const World& world, const Occupancy& occupancy, int agent, int* out) {
    const bool few = occupancy.n_agents() <= Occupancy::kFewAgents;
    int* end =
        few ? list_places(world, occupancy, agent, out) : list_boards(world, occupancy, agent, out);
    if (world.ground().has_obstacles) {
        const Window window(world, agent);
        const int area = window.fov * window.fov;
        end = list_board(world.ground().walls, window, kObstacles * area, false, end);
    }
    return static_cast<int>(end - out);
}

void write_state(const World& world, std::uint8_t* out) {
    const Config& config = world.config();
    const Grid& grid = world.grid();
    const int area = config.rows * config.cols;
    std::memset(out, 0, static_cast<std::size_t>(kChannels) * area);
    for (int a : world.living()) {
        const int channel = world.team(a) == Team::Pursuer ? kPursuers : kEvaders;
        const int cell = world.cell(a);
        out[channel * area + grid.row(cell) * config.cols + grid.col(cell)] = 1;
    }
    for (int i = 0; i < area; ++i) {
        out[kObstacles * area + i] =
            world.ground().kind[grid.cell(i / config.cols, i % config.cols)] == kObstacle;
    }
}

}  // namespace matrixworld
