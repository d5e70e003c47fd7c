// The named inputs of the moves of one agent, and a layer of a network that rates them: a lane of the
// vectors for each move. Included by kernels.cpp alone.
#pragma once

#include "kernels/look.hpp"

namespace matrixworld {

namespace {

constexpr int kCompass = 5, kDiagonal = 9;  // moves

// Vectors that numbers of all moves take.
constexpr int parts_of(int n_moves) {
    return (n_moves <= kMoveLanes / 2 ? kMoveLanes / 2 : kMoveLanes) / kLanesOf<Half>;
}

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

// ---- The ground ---------------------------------------------------------------------------------

// Writes bits of moves as numbers.
template <int kMoves>
inline void spread(std::uint32_t bits, float* out) {
    using Ints = Lanes<std::int32_t, kLanesOf<Half>>;
    static constexpr std::int32_t kBits[kMoveLanes] = {
        1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
        1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};
    for (int i = 0; i < parts_of(kMoves) * kLanesOf<Half>; i += kLanesOf<Half>) {
        Ints lanes;
        std::memcpy(&lanes, kBits + i, sizeof(Ints));
        const Mask<Half> set = as<Mask<Half>>(Ints{} < (lanes & static_cast<std::int32_t>(bits)));
        store(out + i, where(set, splat<Half>(1.0f), Half{}));
    }
}

// What is out of view is not known, and counts as free.
template <int kMoves>
inline void look_at_ground(const MoveLook& look, MoveRows& rows) {
    constexpr std::uint32_t kAll = (1u << kMoves) - 2;
    rows.blocked = ~(look.open[0] | look.steps[0].unseen) & kAll;
    for (int move = 0; move < kMoves; ++move) {
        const Step& step = look.steps[move];
        rows.of[kExits][move] = look.exits[look.open[step.cell] | step.unseen];
        rows.of[kRoom][move] = look.unit * static_cast<float>(look.room[step.cell]);
    }
    if (wants(look, kAhead)) spread<kMoves>(look.ahead, rows.of[kAhead]);
    if (wants(look, kSearch)) spread<kMoves>(look.search, rows.of[kSearch]);
}

// ---- All inputs ---------------------------------------------------------------------------------

template <int kMoves>
void look_at_moves(const MoveLook& look, SeenCells teammates, SeenCells adversaries) {
    constexpr int kParts = parts_of(kMoves);
    const auto nobody = all<kParts>(static_cast<float>(look.fov));
    auto teammate = nobody, adversary = nobody, unclaimed = nobody, open_side = nobody;
    auto pressure = all<kParts>(0);
    look_at_ground<kMoves>(look, *look.rows);
    std::uint32_t forbidden = look.rows->blocked;
    visit(teammates, [&](const SeenCell& seen) {
        keep_least(teammate, seen.moves);
        look.taken[seen.index] = look.number;
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
            const int side = seen.index + look.steps[lowest_bit(sides)].index;
            if (look.taken[side] != look.number) keep_least(open_side, look.view[side].moves);
        }
    });
    auto& out = look.rows->of;
    store_moves(out[kTeammate], teammate, look.unit);
    store_moves(out[kAdversary], adversary, look.unit);
    store_moves(out[kPressure], pressure, 1);
    store_moves(out[kUnclaimed], any_unclaimed ? unclaimed : adversary, look.unit);
    store_moves(out[kOpenSide], open_side, look.unit);
    look.rows->forbidden = forbidden;
    if (wants(look, kMustYield)) spread<kMoves>(forbidden, out[kMustYield]);
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
template <int kMoves, int kWords>
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
        look_at_moves<kMoves>(at, pursuers, evaders);
    } else {
        look_at_moves<kMoves>(at, evaders, pursuers);
    }
}

template <int kMoves>
void look_around(const MoveLook& at, SeenCells teammates, SeenCells adversaries) {
    constexpr int kMost = kMaxPositions / kPositionPad;
    const int n = at.positions.n_agents;
    if (n == 0) return look_at_moves<kMoves>(at, teammates, adversaries);
    return n <= kPositionPad ? look_from_positions<kMoves, 1>(at)
                             : look_from_positions<kMoves, kMost>(at);
}

void look_at_moves(const MoveLook& at, SeenCells teammates, SeenCells adversaries) {
    return at.n_moves == kCompass ? look_around<kCompass>(at, teammates, adversaries)
                                  : look_around<kDiagonal>(at, teammates, adversaries);
}

// ---- A layer ------------------------------------------------------------------------------------

// Of kAgents agents, kUnits units at once: one after the other, their sums would wait for each other.
template <int kParts, int kAgents, int kUnits>
inline void add_products_of_moves(const MoveLayer& layer, const float* in, int unit, float* out) {
    Half sum[kAgents][kUnits][kParts];
    for (int agent = 0; agent < kAgents; ++agent) {
        for (int u = 0; u < kUnits; ++u) {
            const Half bias = splat<Half>(layer.biases ? layer.biases[unit + u] : 0.0f);
            for (int k = 0; k < kParts; ++k) sum[agent][u][k] = bias;
        }
    }
    const float* weights = layer.weights + unit;
    for (int i = 0; i < layer.n_in; ++i, weights += layer.n_units) {
        const float* row = in + static_cast<std::ptrdiff_t>(layer.rows[i]) * kMoveLanes;
        for (int agent = 0; agent < kAgents; ++agent, row += layer.in_stride) {
            const ByMove<kParts> x = load_moves<kParts>(row);
            for (int u = 0; u < kUnits; ++u) {
                const Half weight = splat<Half>(weights[u]);
                for (int k = 0; k < kParts; ++k) sum[agent][u][k] += x.parts[k] * weight;
            }
        }
    }
    const Half floor = splat<Half>(layer.least);
    for (int agent = 0; agent < kAgents; ++agent, out += layer.out_stride) {
        for (int u = 0; u < kUnits; ++u) {
            for (int k = 0; k < kParts; ++k) {
                store(out + (unit + u) * kMoveLanes + k * kLanesOf<Half>,
                      larger(sum[agent][u][k], floor));
            }
        }
    }
}

// All units of the agents from `agent` on, as many as fill groups of kAgents.
template <int kParts, int kAgents, int kUnits>
void rate_all(const MoveLayer& layer, int& agent) {
    for (; agent + kAgents <= layer.n_agents; agent += kAgents) {
        const float* const in = layer.in + agent * layer.in_stride;
        float* const out = layer.out + agent * layer.out_stride;
        int unit = 0;
        for (; unit + kUnits <= layer.n_units; unit += kUnits) {
            add_products_of_moves<kParts, kAgents, kUnits>(layer, in, unit, out);
        }
        for (; unit < layer.n_units; ++unit) {
            add_products_of_moves<kParts, kAgents, 1>(layer, in, unit, out);
        }
    }
}

template <int kMoves>
void rate_moves_of(const MoveLayer& layer) {
    constexpr int kParts = parts_of(kMoves);
    int agent = 0;
    if (layer.n_units == 1) rate_all<kParts, 4, 1>(layer, agent);
    rate_all<kParts, 1, 4>(layer, agent);
}

void rate_moves(const MoveLayer& layer) {
    (layer.n_moves == kCompass ? rate_moves_of<kCompass> : rate_moves_of<kDiagonal>)(layer);
}

}  // namespace

}  // namespace matrixworld
