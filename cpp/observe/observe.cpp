#include "observe/observe.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "grid/compiler.hpp"
#include "kernels/kernels.hpp"

namespace matrixworld {

namespace {

// The default of `Config`: loops over windows are compiled for it as a constant, too.
constexpr int kUsualFov = 11;

// The square that an agent sees, by its first cell.
struct Window {
    Window(const World& world, int cell)
        : fov(world.config().fov),
          top(world.grid().row(cell) - fov / 2),
          left(world.grid().col(cell) - fov / 2) {}

    int fov;
    int top;
    int left;
};

// Is the agent the only one of its team on its cell? An agent is not in its own view, but the
// planes and bitboards of its team include it: then the centre of its own channel must be cleared.
bool only_one(const World& world, const Occupancy& occupancy, int agent) {
    return occupancy.count(world.cell(agent), world.team(agent)) == 1;
}

int own_centre(const World& world, int agent) {
    const int fov = world.config().fov;
    return (channel(world.team(agent)) * fov + fov / 2) * fov + fov / 2;
}

}  // namespace

// ---- Views as numbers ---------------------------------------------------------------------------

namespace {

// The widest view for which the visible borders are kept: their number and the size of each grow
// with fov^2.
constexpr int kLargestBorder = 15;

}  // namespace

Observer::Observer(const Setup& setup)
    : fov_(setup.config.fov),
      crowd_(setup.config),
      obstacles_(static_cast<std::size_t>(setup.config.n_agents())),
      cases_(setup.grid, fov_),
      planes_{Plane(setup.grid, fov_ / 2, 0), Plane(setup.grid, fov_ / 2, 0)} {
    if (fov_ <= kLargestBorder) make_border(setup.grid);
}

// For every case of what is seen of the border, the obstacle channel of a world without obstacles.
// A window of it is contiguous, so it is copied at once instead of row by row.
void Observer::make_border(const Grid& grid) {
    const int area = fov_ * fov_;
    border_.resize(static_cast<std::size_t>(cases_.n_cases()) * area);
    const Terrain empty(grid, fov_ / 2);
    std::vector<bool> known(cases_.n_cases());
    for (int row = 0; row < grid.rows(); ++row) {
        for (int col = 0; col < grid.cols(); ++col) {
            const int number = cases_.number(row, col);
            if (known[number]) continue;
            known[number] = true;
            std::uint8_t* seen = &border_[static_cast<std::size_t>(number) * area];
            const std::uint8_t* window = empty.blocked.window(row - fov_ / 2, col - fov_ / 2);
            for (int r = 0; r < fov_; ++r, window += empty.blocked.stride()) {
                std::copy_n(window, fov_, seen + r * fov_);
            }
        }
    }
}

const std::uint8_t* Observer::border(int row, int col) const {
    return &border_[static_cast<std::size_t>(cases_.number(row, col)) * fov_ * fov_];
}

template <typename Number>
void Observer::write(const World& world, const Occupancy& occupancy, Number* out) {
    if (world.config().n_agents() <= kMaxPositions) {
        write_from_positions(world, out);
    } else {
        write_from_planes(world, occupancy, out);
    }
}

template void Observer::write(const World&, const Occupancy&, std::uint8_t*);
template void Observer::write(const World&, const Occupancy&, float*);

namespace {

auto views_kernel(const std::uint8_t*) { return kernels().write_byte_views; }
auto views_kernel(const float*) { return kernels().write_float_views; }

}  // namespace

template <typename Number>
void Observer::write_from_positions(const World& world, Number* out) {
    crowd_.gather(world);
    const Positions positions = crowd_.positions();
    const Plane& blocked = world.terrain().blocked;
    const bool only_border = !world.terrain().has_obstacles && !border_.empty();
    for (int i = 0; i < positions.n_agents; ++i) {
        const int row = positions.rows[i];
        const int col = positions.cols[i];
        obstacles_[i] =
            only_border ? border(row, col) : blocked.window(row - fov_ / 2, col - fov_ / 2);
    }
    views_kernel(out)(positions, world.living().data(), world.config().n_agents(),
                      obstacles_.data(), only_border ? fov_ : blocked.stride(), out);
}

namespace {

void copy_piece(const std::uint8_t* from, std::uint8_t* to) {
    std::memcpy(to, from, Plane::kPiece);
}

void copy_piece(const std::uint8_t* from, float* to) {
    // A copy, so that the compiler knows that `to` does not overlap it.
    std::array<std::uint8_t, Plane::kPiece> piece;
    std::memcpy(piece.data(), from, piece.size());
    for (std::size_t i = 0; i < piece.size(); ++i) to[i] = piece[i];
}

// Appends a window row by row and returns its end. Rows are copied in whole pieces as long as there
// is room before `end`: a piece is faster than its cells, and what it writes beyond its row is
// overwritten by the next row.
template <int kFov, typename Number>
Number* copy_window(const Plane& plane, const Window& window, Number* out, const Number* end) {
    constexpr int kPiece = Plane::kPiece;
    const int fov = kFov ? kFov : window.fov;  // a constant lets the compiler unroll the loops
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

// All three channels, one after the other.
template <int kFov, typename Number>
void copy_channels(const Plane (&teams)[kTeams], const Plane& blocked, const Window& window,
                   Number* out) {
    const Number* end = out + kChannels * window.fov * window.fov;
    out = copy_window<kFov>(teams[static_cast<int>(Team::Evader)], window, out, end);
    out = copy_window<kFov>(teams[static_cast<int>(Team::Pursuer)], window, out, end);
    copy_window<kFov>(blocked, window, out, end);
}

}  // namespace

template <typename Number>
void Observer::write_from_planes(const World& world, const Occupancy& occupancy, Number* out) {
    mark(world, 1);
    const int size = kChannels * fov_ * fov_;
    for (int a = 0; a < world.config().n_agents(); ++a, out += size) {
        if (!world.alive(a)) {
            std::fill_n(out, size, Number{0});
            continue;
        }
        const Window window(world, world.cell(a));
        const auto channels =
            fov_ == kUsualFov ? copy_channels<kUsualFov, Number> : copy_channels<0, Number>;
        channels(planes_, world.terrain().blocked, window, out);
        if (only_one(world, occupancy, a)) out[own_centre(world, a)] = 0;
    }
    mark(world, 0);
}

// Sets or clears the living agents' cells on the planes, which are empty between two calls:
// clearing them costs O(agents), clearing whole planes O(cells).
void Observer::mark(const World& world, std::uint8_t value) {
    for (int a : world.living()) {
        const int cell = world.cell(a);
        const int team = static_cast<int>(world.team(a));
        planes_[team].at(world.grid().row(cell), world.grid().col(cell)) = value;
    }
}

// ---- Views as lists -----------------------------------------------------------------------------

namespace {

// Appends the cells that are set in the window of one bitboard, numbered from `first`, without the
// centre if `hide_centre`, and returns the end. Several rows share a word, so that a window of 11 x
// 11 takes three loops over bits instead of eleven.
template <int kFov>
int* list_packed(const Bitboard& bitboard, const Window& window, int first, bool hide_centre,
                 int* out) {
    const int fov = kFov ? kFov : window.fov;  // a constant lets the compiler unroll the loops
    const int rows_a_word = 64 / fov;
    const Bitboard::Reader reader = bitboard.window(window.top, window.left);
    for (int r = 0; r < fov; r += rows_a_word) {
        std::uint64_t bits = 0;
        for (int i = 0; i < rows_a_word && r + i < fov; ++i) {
            bits |= reader.row(r + i, fov) << (i * fov);
        }
        if (hide_centre && r <= fov / 2 && fov / 2 < r + rows_a_word) {
            bits &= ~(std::uint64_t{1} << (fov * fov / 2 - r * fov));
        }
        for (; bits; bits &= bits - 1) *out++ = first + r * fov + lowest_bit(bits);
    }
    return out;
}

// The same for views that are wider than one read of a bitboard: rows are read in several parts.
int* list_parts(const Bitboard& bitboard, const Window& window, int first, bool hide_centre,
                int* out) {
    const int centre = window.fov / 2;
    for (int r = 0; r < window.fov; ++r) {
        for (int c = 0; c < window.fov; c += Bitboard::kMaxWidth) {
            const auto reader = bitboard.window(window.top + r, window.left + c);
            Bitboard::Word bits = reader.row(0, std::min(Bitboard::kMaxWidth, window.fov - c));
            for (; bits; bits &= bits - 1) {
                const int col = c + lowest_bit(bits);
                const bool hidden = hide_centre && r == centre && col == centre;
                if (!hidden) *out++ = first + r * window.fov + col;
            }
        }
    }
    return out;
}

int* list_window(const Bitboard& bitboard, const Window& window, int first, bool hide_centre,
                 int* out) {
    if (window.fov == kUsualFov)
        return list_packed<kUsualFov>(bitboard, window, first, hide_centre, out);
    if (window.fov <= Bitboard::kMaxWidth)
        return list_packed<0>(bitboard, window, first, hide_centre, out);
    return list_parts(bitboard, window, first, hide_centre, out);
}

// Up to kMaxPositions agents: each of them is compared with the window.
int* list_by_positions(const World& world, const Occupancy& occupancy, int agent, int* out) {
    const Window window(world, world.cell(agent));
    const auto within = [&](int offset) { return offset >= 0 && offset < window.fov; };
    int* const begin = out;
    for (int other : world.living()) {
        const int down = world.grid().row(world.cell(other)) - window.top;
        const int right = world.grid().col(world.cell(other)) - window.left;
        if (other == agent || !within(down) || !within(right)) continue;
        const int input = (channel(world.team(other)) * window.fov + down) * window.fov + right;
        const bool several = occupancy.count(world.cell(other), world.team(other)) > 1;
        if (several && std::find(begin, out, input) != out) continue;  // listed already
        *out++ = input;
    }
    return out;
}

// More agents: the bits of the window are read from the bitboard of each team.
int* list_by_bitboards(const World& world, const Occupancy& occupancy, int agent, int* out) {
    const Window window(world, world.cell(agent));
    const int area = window.fov * window.fov;
    const bool hide = only_one(world, occupancy, agent);
    const bool pursuer = world.team(agent) == Team::Pursuer;
    out = list_window(occupancy.bitboard(Team::Evader), window, kEvaders * area, hide && !pursuer,
                      out);
    return list_window(occupancy.bitboard(Team::Pursuer), window, kPursuers * area, hide && pursuer,
                       out);
}

}  // namespace

int list_agents(const World& world, const Occupancy& occupancy, int agent, int* out) {
    const bool few = world.config().n_agents() <= kMaxPositions;
    int* const end = few ? list_by_positions(world, occupancy, agent, out)
                         : list_by_bitboards(world, occupancy, agent, out);
    return static_cast<int>(end - out);
}

// ---- Obstacles as bits --------------------------------------------------------------------------

namespace {

template <int kFov>
void pack_window(const Bitboard& bitboard, int top, int left, int any_fov, std::uint64_t* words) {
    const int fov = kFov ? kFov : any_fov;  // a constant lets the compiler unroll the loops
    std::fill_n(words, n_obstacle_words(fov), 0);
    int at = 0;  // bit
    for (int r = 0; r < fov; ++r) {
        for (int c = 0; c < fov; c += Bitboard::kMaxWidth) {
            const int n = std::min(Bitboard::kMaxWidth, fov - c);
            const Bitboard::Word bits = bitboard.window(top + r, left + c).row(0, n);
            words[at / 64] |= bits << (at % 64);
            if (at % 64 + n > 64) words[at / 64 + 1] |= bits >> (64 - at % 64);
            at += n;
        }
    }
}

}  // namespace

void pack_obstacles(const World& world, int row, int col, std::uint64_t* words) {
    const int fov = world.config().fov;
    const auto pack = fov == kUsualFov ? pack_window<kUsualFov> : pack_window<0>;
    pack(world.terrain().obstacles, row - fov / 2, col - fov / 2, fov, words);
}

void write_state(const World& world, std::uint8_t* out) {
    const Config& config = world.config();
    const Grid& grid = world.grid();
    const int area = config.rows * config.cols;
    std::memset(out, 0, static_cast<std::size_t>(kChannels) * area);
    for (int a : world.living()) {
        const int cell = world.cell(a);
        out[channel(world.team(a)) * area + grid.row(cell) * config.cols + grid.col(cell)] = 1;
    }
    world.terrain().write_map(out + kObstacles * area);
}

}  // namespace matrixworld
