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

template <typename Each>
inline void visit(SeenCells seen, const Each& each) {
    for (int i = 0; i < seen.n; ++i) each(*seen.cells[i]);
}

inline bool wants(const MoveLook& look, Input input) { return look.wanted >> input & 1; }

// ---- Holding an evader --------------------------------------------------------------------------

// What is to an agent on `from` its nearest of some cells: the moves there.
inline int least_moves(const MoveLook& look, int from, SeenCells to) {
    int least = 2 * look.fov;  // more than there are in a view
    visit(to, [&](const SeenCell& seen) {
        const int moves = look.apart[seen.spot - from].moves;
        least = moves < least ? moves : least;
    });
    return least;
}

inline std::uint32_t reached(const MoveLook& look, int evader, SeenCells by) {
    std::uint32_t moves = 0;
    visit(by, [&](const SeenCell& seen) { moves |= look.apart[seen.spot - evader].reached; });
    return moves;
}

// (1 - cosine) / 2 of the directions from an evader to two pursuers.
inline float opposite(const MoveLook& look, int evader, int pursuer, int other) {
    const Apart &a = look.apart[pursuer - evader], &b = look.apart[other - evader];
    return (1.0f - (a.row * b.row + a.col * b.col)) * 0.5f;
}

// How a pursuer and its teammates hold the evader nearest to it; of several, the best.
inline void look_at_nearest_evader(const MoveLook& look, SeenCells teammates, SeenCells evaders) {
    float (&escapes)[kMoveLanes] = look.rows->of[kEscapes];
    float (&sides)[kMoveLanes] = look.rows->of[kOpposed];
    for (int move = 0; move < look.n_moves; ++move) escapes[move] = 1, sides[move] = 0;
    const int nearest = least_moves(look, 0, evaders);
    visit(evaders, [&](const SeenCell& evader) {
        if (look.apart[evader.spot].moves != nearest) return;
        const std::uint32_t open = look.open[evader.cell] | evader.unseen;
        const std::uint32_t left = open & ~reached(look, evader.spot, teammates);
        for (int move = 0; move < look.n_moves; ++move) {
            const Apart& own = look.apart[look.steps[move].spot - evader.spot];
            const float share = look.shares[count_bits(left & ~own.reached)];
            escapes[move] = share < escapes[move] ? share : escapes[move];
        }
        const int closest = least_moves(look, evader.spot, teammates);
        visit(teammates, [&](const SeenCell& mate) {
            if (look.apart[mate.spot - evader.spot].moves != closest) return;
            for (int move = 0; move < look.n_moves; ++move) {
                const float side = opposite(look, evader.spot, look.steps[move].spot, mate.spot);
                sides[move] = side > sides[move] ? side : sides[move];
            }
        });
    });
}

// How pursuers hold an evader.
inline void look_at_pursuers(const MoveLook& look, SeenCells pursuers) {
    float (&escapes)[kMoveLanes] = look.rows->of[kEscapes];
    float (&sides)[kMoveLanes] = look.rows->of[kOpposed];
    for (int move = 0; move < look.n_moves; ++move) {
        const Step& step = look.steps[move];
        const std::uint32_t open = look.open[step.cell] | step.unseen;
        escapes[move] = look.shares[count_bits(open & ~reached(look, step.spot, pursuers))];
        sides[move] = 0;
    }
    const int nearest = least_moves(look, 0, pursuers);
    visit(pursuers, [&](const SeenCell& first) {
        if (look.apart[first.spot].moves != nearest) return;
        int next = 2 * look.fov;
        visit(pursuers, [&](const SeenCell& second) {
            const int moves = look.apart[second.spot].moves;
            if (&second != &first && moves < next) next = moves;
        });
        visit(pursuers, [&](const SeenCell& second) {
            if (&second == &first || look.apart[second.spot].moves != next) return;
            for (int move = 0; move < look.n_moves; ++move) {
                const float side = opposite(look, look.steps[move].spot, first.spot, second.spot);
                sides[move] = side > sides[move] ? side : sides[move];
            }
        });
    });
}

// ---- All inputs ---------------------------------------------------------------------------------

template <int kParts>
void look_at_moves(const MoveLook& look, SeenCells teammates, SeenCells adversaries) {
    const auto nobody = all<kParts>(static_cast<float>(look.fov));
    auto teammate = nobody, adversary = nobody, unclaimed = nobody, open_side = nobody;
    auto pressure = all<kParts>(0);
    std::uint32_t forbidden = 0;
    visit(teammates, [&](const SeenCell& seen) {
        keep_least(teammate, seen.moves);
        look.taken[&seen - look.view] = look.number;
        forbidden |= look.forbids[0][seen.near];
    });
    const bool asks_claims = wants(look, kUnclaimed), asks_sides = wants(look, kOpenSide);
    bool any_unclaimed = false;
    visit(adversaries, [&](const SeenCell& seen) {
        keep_least(adversary, seen.moves);
        add_to(pressure, seen.charge);
        forbidden |= look.forbids[1][seen.near];
        if (asks_claims) {
            const bool claimed =
                least_moves(look, seen.spot, teammates) < look.apart[seen.spot].moves;
            if (!claimed) keep_least(unclaimed, seen.moves);
            any_unclaimed |= !claimed;
        }
        if (!asks_sides) return;
        std::uint32_t sides = look.open[seen.cell] & ~seen.unseen & ~1u;
        for (; sides; sides &= sides - 1) {
            const SeenCell* const side = &seen + look.steps[lowest_bit(sides)].index;
            if (look.taken[side - look.view] != look.number) keep_least(open_side, side->moves);
        }
    });
    auto& out = look.rows->of;
    store_moves(out[kTeammate], teammate, look.unit);
    store_moves(out[kAdversary], adversary, look.unit);
    store_moves(out[kPressure], pressure, 1);
    store_moves(out[kUnclaimed], any_unclaimed ? unclaimed : adversary, look.unit);
    store_moves(out[kOpenSide], open_side, look.unit);
    look.rows->forbidden |= forbidden;
    if (wants(look, kParity)) {
        for (int move = 0; move < look.n_moves; ++move) {
            const int moves = least_moves(look, look.steps[move].spot, adversaries);
            out[kParity][move] = static_cast<float>(moves & 1);  // without one it is even
        }
    }
    if (!wants(look, kEscapes) && !wants(look, kOpposed)) return;
    if (look.pursues) {
        look_at_nearest_evader(look, teammates, adversaries);
    } else {
        look_at_pursuers(look, adversaries);
    }
}

// Pursuers are the first of the positions.
template <int kParts, int kWords>
void look_from_positions(const MoveLook& at) {
    Seen<kWords> seen = look<kWords>(at.positions, at.place, at.fov);
    std::uint64_t shared = 0;
    for (int i = 0; i < kWords; ++i) shared |= seen.words[i] & at.positions.shared[i];
    if (shared) seen = without_duplicates(at.positions, seen);
    const SeenCell* cells[kWords * kPositionPad];
    int n = 0, n_pursuers = 0;
    for (int i = 0; i < kWords; ++i) {
        for (std::uint64_t bits = seen.words[i]; bits; bits &= bits - 1) {
            const int place = i * kPositionPad + lowest_bit(bits);
            const bool pursues = place < at.n_pursuers;
            const int first = seen.corner + (pursues ? at.fov * at.fov : 0);
            cells[n++] = at.view + (at.positions.cells[place] - first);
            n_pursuers += pursues;
        }
    }
    const SeenCells pursuers{cells, n_pursuers}, evaders{cells + n_pursuers, n - n_pursuers};
    if (at.pursues) {
        look_at_moves<kParts>(at, pursuers, evaders);
    } else {
        look_at_moves<kParts>(at, evaders, pursuers);
    }
}

template <int kParts>
void look_around(const MoveLook& at, SeenCells teammates, SeenCells adversaries) {
    constexpr int kMost = kMaxPositions / kPositionPad;
    const int n = at.positions.n_agents;
    if (n == 0) return look_at_moves<kParts>(at, teammates, adversaries);
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
