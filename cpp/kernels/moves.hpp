// The named inputs of the moves of one agent, and a layer of a network that rates them: a lane of the
// vectors for each move. Included by kernels.cpp alone.
#pragma once

#include "kernels/look.hpp"

namespace matrixworld {

namespace {

// Numbers of all moves, in kParts vectors.
template <int kParts>
struct ByMove {
    Half parts[kParts];
};

template <int kParts>
inline ByMove<kParts> all(float number) {
    ByMove<kParts> row;
    for (int i = 0; i < kParts; ++i) row.parts[i] = splat<Half>(number);
    return row;
}

template <int kParts>
inline ByMove<kParts> load_moves(const float* numbers) {
    ByMove<kParts> row;
    for (int i = 0; i < kParts; ++i) row.parts[i] = load<Half>(numbers + i * kLanesOf<Half>);
    return row;
}

template <int kParts>
inline void store_moves(float* out, const ByMove<kParts>& row, float scale) {
    for (int i = 0; i < kParts; ++i) {
        store(out + i * kLanesOf<Half>, row.parts[i] * splat<Half>(scale));
    }
}

template <int kParts>
inline void keep_least(ByMove<kParts>& row, const float* numbers) {
    for (int i = 0; i < kParts; ++i) {
        const Half other = load<Half>(numbers + i * kLanesOf<Half>);
        row.parts[i] = where(other < row.parts[i], other, row.parts[i]);
    }
}

template <int kParts>
inline void add_to(ByMove<kParts>& row, const float* numbers) {
    for (int i = 0; i < kParts; ++i) row.parts[i] += load<Half>(numbers + i * kLanesOf<Half>);
}

inline int magnitude(int x) { return x < 0 ? -x : x; }

inline int moves_apart(const SeenCell& a, const SeenCell& b, bool diagonal) {
    const int rows = magnitude(a.row - b.row), cols = magnitude(a.col - b.col);
    return !diagonal ? rows + cols : rows > cols ? rows : cols;
}

// `each(team, visit)` visits the cells on which the agent sees a team: its own, or the other one.
template <int kParts, typename Each>
void look_at_moves(const MoveLook& look, const Each& each) {
    const auto nobody = all<kParts>(static_cast<float>(look.fov));
    auto teammate = nobody, adversary = nobody, unclaimed = nobody, open_side = nobody;
    auto pressure = all<kParts>(0);
    std::uint32_t forbidden = 0;
    each(0, [&](const SeenCell& seen) {
        keep_least(teammate, seen.moves);
        look.taken[seen.place] = look.number;
        forbidden |= look.forbids[0][seen.near];
    });
    bool any_unclaimed = false;
    each(1, [&](const SeenCell& seen) {
        keep_least(adversary, seen.moves);
        add_to(pressure, seen.charge);
        forbidden |= look.forbids[1][seen.near];
        if (look.asks_claims) {
            const int own = static_cast<int>(seen.moves[0]);
            bool claimed = false;
            each(0, [&](const SeenCell& mate) {
                claimed |= moves_apart(mate, seen, look.diagonal) < own;
            });
            if (!claimed) keep_least(unclaimed, seen.moves);
            any_unclaimed |= !claimed;
        }
        for (int side = 1; look.asks_sides && side < look.n_moves; ++side) {
            const MoveLook::Step& step = look.steps[side];
            const std::uint64_t taken = look.taken[seen.place + step.place];
            if (taken == look.number || taken == MoveLook::kOutOfView) continue;
            const int row = seen.row + step.row, col = seen.col + step.col;
            if (look.walls[static_cast<std::ptrdiff_t>(row) * look.walls_stride + col]) continue;
            keep_least(open_side, (&seen + step.row * look.fov + step.col)->moves);
        }
    });
    auto& out = look.rows->of;
    store_moves(out[kTeammate], teammate, look.unit);
    store_moves(out[kAdversary], adversary, look.unit);
    store_moves(out[kPressure], pressure, 1);
    store_moves(out[kUnclaimed], any_unclaimed ? unclaimed : adversary, look.unit);
    store_moves(out[kOpenSide], open_side, look.unit);
    look.rows->forbidden |= forbidden;
}

template <int kParts, int kWords>
void look_from_positions(const MoveLook& at) {
    Seen<kWords> seen = look<kWords>(at.positions, at.place, at.fov);
    std::uint64_t shared = 0;
    for (int i = 0; i < kWords; ++i) shared |= seen.words[i] & at.positions.shared[i];
    if (shared) seen = without_duplicates(at.positions, seen);
    look_at_moves<kParts>(at, [&](int team, const auto& visit) {
        const std::int32_t* cells = at.positions.cells;
        const int first = seen.corner + at.first[team];
        for (int i = 0; i < kWords; ++i, cells += kPositionPad) {
            std::uint64_t bits = seen.words[i] & at.of_team[team][i];
            for (; bits; bits &= bits - 1) visit(at.view[cells[lowest_bit(bits)] - first]);
        }
    });
}

template <int kParts>
void look_around(const MoveLook& at, SeenCells teammates, SeenCells adversaries) {
    constexpr int kMost = kMaxPositions / kPositionPad;
    const int n = at.positions.n_agents;
    if (n == 0) {
        return look_at_moves<kParts>(at, [&](int team, const auto& visit) {
            const SeenCells& cells = team == 0 ? teammates : adversaries;
            for (int i = 0; i < cells.n; ++i) visit(*cells.cells[i]);
        });
    }
    return n <= kPositionPad ? look_from_positions<kParts, 1>(at)
                             : look_from_positions<kParts, kMost>(at);
}

void look_at_moves(const MoveLook& at, SeenCells teammates, SeenCells adversaries) {
    constexpr int kFew = kMoveLanes / 2 / kLanesOf<Half>;
    return at.n_moves <= kMoveLanes / 2 ? look_around<kFew>(at, teammates, adversaries)
                                        : look_around<2 * kFew>(at, teammates, adversaries);
}

// ---- A layer ------------------------------------------------------------------------------------

// kUnits units at once: one after the other, their sums would wait for each other.
template <int kParts, int kUnits>
inline void add_products_of_moves(const float* in, const int* rows, int n_in, const float* weights,
                                  int n_units, const float* biases, float least, float* out) {
    Half sum[kUnits][kParts];
    for (int unit = 0; unit < kUnits; ++unit) {
        for (int k = 0; k < kParts; ++k) sum[unit][k] = splat<Half>(biases ? biases[unit] : 0.0f);
    }
    for (int i = 0; i < n_in; ++i, weights += n_units) {
        const ByMove<kParts> x =
            load_moves<kParts>(in + static_cast<std::ptrdiff_t>(rows[i]) * kMoveLanes);
        for (int unit = 0; unit < kUnits; ++unit) {
            const Half weight = splat<Half>(weights[unit]);
            for (int k = 0; k < kParts; ++k) sum[unit][k] += x.parts[k] * weight;
        }
    }
    const Half floor = splat<Half>(least);
    for (int unit = 0; unit < kUnits; ++unit) {
        for (int k = 0; k < kParts; ++k) {
            store(out + unit * kMoveLanes + k * kLanesOf<Half>, larger(sum[unit][k], floor));
        }
    }
}

template <int kParts>
void rate_all(const float* in, const int* rows, int n_in, const float* weights, int n_units,
              const float* biases, float least, float* out) {
    constexpr int kUnits = 4;
    int unit = 0;
    for (; unit + kUnits <= n_units; unit += kUnits) {
        add_products_of_moves<kParts, kUnits>(in, rows, n_in, weights + unit, n_units,
                                              biases ? biases + unit : nullptr, least,
                                              out + unit * kMoveLanes);
    }
    for (; unit < n_units; ++unit) {
        add_products_of_moves<kParts, 1>(in, rows, n_in, weights + unit, n_units,
                                         biases ? biases + unit : nullptr, least,
                                         out + unit * kMoveLanes);
    }
}

void rate_moves(int n_moves, const float* in, const int* rows, int n_in, const float* weights,
                int n_units, const float* biases, float least, float* out) {
    constexpr int kFew = kMoveLanes / 2 / kLanesOf<Half>;
    (n_moves <= kMoveLanes / 2 ? rate_all<kFew> : rate_all<2 * kFew>)(in, rows, n_in, weights,
                                                                      n_units, biases, least, out);
}

}  // namespace

}  // namespace matrixworld
