#include "solve/states.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "observe/inputs.hpp"
#include "solve/matrix_game.hpp"

namespace matrixworld {

namespace {

constexpr int kGonePlace = 0;
constexpr int kCapturedPlace = 1;   // of an evader: gone after its capture
constexpr std::size_t kPiece = 64;  // states; a piece of work of a thread
constexpr std::size_t kNumbersPerPoll = 1 << 22;

}  // namespace

// What a thread needs to play from states.
struct States::Memory {
    explicit Memory(const States& states, bool for_networks = false)
        : world(states.setup_),
          scratch(*states.setup_, for_networks),
          cells(states.setup_->config.n_agents()),
          captured(states.setup_->config.n_evaders),
          actions(states.setup_->config.n_agents()) {
        world.reset({}, scratch);
        world.leave(scratch);
    }

    World world;
    Scratch scratch;
    IntArray cells;
    ByteArray captured;
    std::vector<int> places;
    std::vector<std::uint8_t> actions;
};

// ---- States as numbers --------------------------------------------------------------------------

int States::n_places(Team team) const {
    return team == Team::Pursuer ? 1 + n_cells_ : 2 + 2 * n_cells_;
}

States::Code States::code_of(const std::vector<int>& places) const {
    Code code = 0;
    for (int a = 0; a < setup_->config.n_agents(); ++a) {
        code = code * n_places(team(a)) + places[a];
    }
    return code;
}

void States::place(Code code, std::vector<int>& places) const {
    places.resize(setup_->config.n_agents());
    for (int a = setup_->config.n_agents() - 1; a >= 0; --a) {
        places[a] = code % n_places(team(a));
        code /= n_places(team(a));
    }
}

// By agent of the world, before sorting.
void States::places_in(const World& world, std::vector<int>& places) const {
    const Config& config = setup_->config;
    places.resize(config.n_agents());
    for (int a = 0; a < config.n_agents(); ++a) {
        const int index = world.alive(a) ? index_of_[world.cell(a)] : kGone;
        if (a < config.n_pursuers) {
            places[a] = index + 1;
        } else {
            const int counted = world.counts_as_captured(a - config.n_pursuers);
            places[a] = index == kGone ? counted : 2 + 2 * index + counted;
        }
    }
}

void States::put(const std::vector<int>& places, Memory& memory, When when) const {
    const int n_pursuers = setup_->config.n_pursuers;
    for (int a = 0; a < n_pursuers; ++a) {
        memory.cells[a] = places[a] == kGonePlace ? kGone : cell_of_[places[a] - 1];
    }
    for (int a = n_pursuers; a < setup_->config.n_agents(); ++a) {
        memory.cells[a] = places[a] <= kCapturedPlace ? kGone : cell_of_[places[a] / 2 - 1];
        memory.captured[a - n_pursuers] = places[a] % 2;
    }
    memory.world.put(memory.cells, memory.captured, when.key, when.step, memory.scratch);
}

void States::sort(std::vector<int>& places) const {
    if (!sorted_) return;
    const auto evaders = places.begin() + setup_->config.n_pursuers;
    std::sort(places.begin(), evaders);
    std::sort(evaders, places.end());
}

void States::describe(int turn, std::int64_t state, int* cells, std::uint8_t* captured) const {
    const Config& config = setup_->config;
    std::fill_n(cells, config.n_agents(), kGone);
    if (state < n_ends()) {
        for (int e = 0; e < config.n_evaders; ++e) captured[e] = e < state;
        return;
    }
    std::vector<int> places;
    place(layers_[turn].codes[state], places);
    for (int a = 0; a < config.n_pursuers; ++a) cells[a] = places[a] - 1;
    for (int e = 0; e < config.n_evaders; ++e) {
        const int place = places[config.n_pursuers + e];
        if (place > kCapturedPlace) cells[config.n_pursuers + e] = place / 2 - 1;
        captured[e] = place % 2;
    }
}

std::int64_t States::find(const World& world, int turn, std::vector<int>& order) const {
    if (world.terminated()) return world.n_captured();
    std::vector<int> places;
    places_in(world, places);
    order.resize(places.size());
    std::iota(order.begin(), order.end(), 0);
    if (sorted_) {
        const auto by_place = [&](int a, int b) { return places[a] < places[b]; };
        const auto evaders = order.begin() + setup_->config.n_pursuers;
        std::stable_sort(order.begin(), evaders, by_place);
        std::stable_sort(evaders, order.end(), by_place);
    }
    sort(places);
    return layers_[turn].numbers[code_of(places)];
}

// ---- All states ---------------------------------------------------------------------------------

States::States(std::shared_ptr<const Setup> setup, int n_threads, const Poll& poll,
               std::size_t expected, bool numbered)
    : setup_(std::move(setup)),
      sorted_(!numbered && setup_->config.rules.interaction != Interaction::AgentTurns),
      n_cells_(setup_->config.rows * setup_->config.cols),
      cell_of_(n_cells_),
      index_of_(setup_->grid.n_cells(), kGone) {
    const Config& config = setup_->config;
    for (int i = 0; i < n_cells_; ++i) {
        cell_of_[i] = setup_->grid.cell(i / config.cols, i % config.cols);
        index_of_[cell_of_[i]] = i;
    }
    std::int64_t n_codes = 1;
    for (int a = 0; a < config.n_agents(); ++a) {
        n_codes *= n_places(team(a));
        if (n_codes > std::numeric_limits<Code>::max()) {
            throw std::invalid_argument(
                "states: expected at most 2^31 joint places of the agents, got more");
        }
    }
    const World world(setup_);
    layers_.resize(world.n_turns());
    for (int turn = 0; turn < n_turns(); ++turn) {
        Layer& layer = layers_[turn];
        layer.codes.assign(n_ends(), -1);
        layer.numbers.assign(n_codes, -1);
        world.actors(turn, layer.first, layer.last);
        for (int a = layer.first; a < layer.last; ++a) {
            layer.n_joint[static_cast<int>(team(a))] *= config.n_actions();
        }
        layer.codes.reserve(expected);
        layer.successors.reserve(expected * layer.n_joint[0] * layer.n_joint[1]);
    }
    std::vector<int> places(config.n_agents());
    add_starts(0, places);
    std::vector<std::size_t> done(n_turns(), 0);
    for (bool grew = true; grew;) {
        grew = false;
        for (int turn = 0; turn < n_turns(); ++turn) {
            const std::size_t first = std::exchange(done[turn], layers_[turn].codes.size());
            if (first == done[turn]) continue;
            const std::size_t known = std::accumulate(done.begin(), done.end(), first - done[turn]);
            const auto share_of_all = [&](double share) {
                const double n = known + share * (done[turn] - first);
                poll(std::min(1.0, n / (static_cast<double>(expected) * n_turns())));
            };
            expand(turn, first, n_threads, poll ? Poll(share_of_all) : Poll());
            grew = true;
        }
    }
}

std::int32_t States::number(Layer& layer, Code code) {
    std::int32_t& number = layer.numbers[code];
    if (number < 0) {
        number = static_cast<std::int32_t>(layer.codes.size());
        layer.codes.push_back(code);
    }
    return number;
}

// Places the agents from `agent` on in all ways on distinct free cells.
void States::add_starts(int agent, std::vector<int>& places) {
    const Config& config = setup_->config;
    if (agent == config.n_agents()) {
        starts_.push_back(number(layers_[0], code_of(places)));
        return;
    }
    const auto index = [&](int a) {
        return team(a) == Team::Pursuer ? places[a] - 1 : places[a] / 2 - 1;
    };
    const bool first_of_team = agent == 0 || agent == config.n_pursuers;
    for (int i = sorted_ && !first_of_team ? index(agent - 1) + 1 : 0; i < n_cells_; ++i) {
        bool taken = setup_->terrain->kind[cell_of_[i]] != kFree;
        for (int a = 0; a < agent; ++a) taken |= index(a) == i;
        if (taken) continue;
        places[agent] = team(agent) == Team::Pursuer ? i + 1 : 2 + 2 * i;
        add_starts(agent + 1, places);
    }
}

// Finds the successors of the states from `first` on. Threads write the numbers of states that are
// known, and -1 - code of new ones; then one thread numbers these, in their order.
void States::expand(int turn, std::size_t first, int n_threads, const Poll& poll) {
    Layer& layer = layers_[turn];
    Layer& next = layers_[(turn + 1) % n_turns()];
    const std::size_t size = static_cast<std::size_t>(layer.n_joint[0]) * layer.n_joint[1];
    const std::size_t last = layer.codes.size();
    layer.successors.resize(last * size);
    std::vector<std::unique_ptr<Memory>> memory(n_threads);
    for_each_state(first, last, n_threads, poll, [&](std::size_t state, int thread) {
        if (!memory[thread]) memory[thread] = std::make_unique<Memory>(*this);
        play_all(turn, state, *memory[thread], &layer.successors[state * size]);
    });
    for (std::size_t i = first * size; i < last * size; ++i) {
        if (poll && i % kNumbersPerPoll == 0) poll(1);
        std::int32_t& found = layer.successors[i];
        if (found < 0) found = number(next, -1 - found);
    }
}

// Actions of agents that are gone are not looked at: what action 0 leads to is copied.
void States::play_all(int turn, std::size_t state, Memory& memory, std::int32_t* out) const {
    const Layer& layer = layers_[turn];
    const Layer& next = layers_[(turn + 1) % n_turns()];
    const int size = layer.n_joint[0] * layer.n_joint[1];
    if (state < static_cast<std::size_t>(n_ends())) {
        std::fill_n(out, size, static_cast<std::int32_t>(state));
        return;
    }
    World& world = memory.world;
    std::vector<int> places;
    place(layer.codes[state], places);
    const int n_actions = setup_->config.n_actions();
    for (int joint = 0; joint < size; ++joint) {
        int same = joint;  // the joint action without what gone agents would do
        int weight = 1;
        for (int a = layer.last - 1, rest = joint; a >= layer.first; --a, weight *= n_actions) {
            memory.actions[a] = static_cast<std::uint8_t>(rest % n_actions);
            rest /= n_actions;
            const bool gone = places[a] <= (team(a) == Team::Pursuer ? kGonePlace : kCapturedPlace);
            if (gone) same -= weight * memory.actions[a];
        }
        if (same != joint) {
            out[joint] = out[same];
            continue;
        }
        put(places, memory, {});
        world.begin_round();
        world.play_turn(turn, memory.actions.data(), memory.scratch);
        if (world.terminated()) {
            out[joint] = world.n_captured();
        } else {
            places_in(world, memory.places);
            sort(memory.places);
            const Code code = code_of(memory.places);
            out[joint] = next.numbers[code] < 0 ? -1 - code : next.numbers[code];
        }
        world.leave(memory.scratch);
    }
}

void States::for_each_state(std::size_t first, std::size_t last, int n_threads, const Poll& poll,
                            const std::function<void(std::size_t state, int thread)>& work) {
    const KeptWorkers kept(n_threads);
    const std::size_t n_pieces = (last - first + kPiece - 1) / kPiece;
    double reached = 0;  // the newest piece of the calling thread, which alone polls
    const auto tell = [&] { poll(reached / n_pieces); };
    (*kept).run(
        static_cast<std::int64_t>(n_pieces),
        [&](std::int64_t piece, int thread) {
            if (thread == 0) reached = static_cast<double>(piece);
            const std::size_t begin = first + static_cast<std::size_t>(piece) * kPiece;
            const std::size_t end = std::min(begin + kPiece, last);
            for (std::size_t state = begin; state < end; ++state) {
                (*kept).check(thread);
                work(state, thread);
            }
        },
        poll ? Workers::Poll(tell) : Workers::Poll());
}

// ---- What a policy does in every state ----------------------------------------------------------

void States::weigh(int turn, Team of, const Candidates& candidates, When when, double* out,
                   int n_threads, const Poll& poll) const {
    const Layer& layer = layers_[turn];
    const int n_joint = layer.n_joint[static_cast<int>(of)];
    const int n_actions = setup_->config.n_actions();
    std::vector<std::unique_ptr<Memory>> memory(n_threads);
    std::vector<std::unique_ptr<LoadedPolicy>> loaded(n_threads);
    for_each_state(0, layer.codes.size(), n_threads, poll, [&](std::size_t state, int thread) {
        double* const joint = out + state * n_joint;
        std::fill_n(joint, n_joint, 0.0);
        joint[0] = 1;
        if (state < static_cast<std::size_t>(n_ends())) return;
        if (!memory[thread]) {
            memory[thread] = std::make_unique<Memory>(*this, true);
            loaded[thread] = std::make_unique<LoadedPolicy>(candidates, *setup_);
        }
        World& world = memory[thread]->world;
        Scratch& scratch = memory[thread]->scratch;
        place(layer.codes[state], memory[thread]->places);
        put(memory[thread]->places, *memory[thread], when);
        Policy& policy = loaded[thread]->load(0);
        // Members decide independently of each other: probabilities are multiplied.
        for (int a = layer.first, n = 1; a < layer.last; ++a) {
            if (team(a) != of) continue;
            double single[kDiagonalMoves] = {1};
            policy.weigh(world, scratch.occupancy, a, a + 1, single);
            n *= n_actions;
            for (int i = n - 1; i >= 0; --i)
                joint[i] = joint[i / n_actions] * single[i % n_actions];
        }
        world.leave(scratch);
    });
}

void States::look(int turn, int agent, When when, const std::int32_t* states, std::size_t n,
                  float* out) const {
    Memory memory(*this, true);
    MoveInputs inputs(setup_->config);
    const std::size_t size = static_cast<std::size_t>(setup_->config.n_actions()) * kInputs;
    std::vector<float> all(setup_->config.n_agents() * size);
    for (std::size_t i = 0; i < n; ++i) {
        place(layers_[turn].codes[states[i]], memory.places);
        put(memory.places, memory, when);
        inputs.write(memory.world, memory.scratch.occupancy, all.data());
        std::copy_n(all.data() + agent * size, size, out + i * size);
        memory.world.leave(memory.scratch);
    }
}

// ---- Backward induction -------------------------------------------------------------------------

namespace {

// A game in which a team's play is given is smaller: its rows, or columns, become their mean.
void mix_rows(const double* weights, int& n_rows, int n_cols, std::vector<double>& matrix) {
    for (int j = 0; j < n_cols; ++j) {
        double mean = 0;
        for (int i = 0; i < n_rows; ++i) mean += weights[i] * matrix[i * n_cols + j];
        matrix[j] = mean;
    }
    n_rows = 1;
}

void mix_cols(const double* weights, int n_rows, int& n_cols, std::vector<double>& matrix) {
    for (int i = 0; i < n_rows; ++i) {
        const double* const row = &matrix[i * n_cols];
        matrix[i] = std::inner_product(row, row + n_cols, weights, 0.0);
    }
    n_cols = 1;
}

}  // namespace

double States::backup(int turn, const double* next, double* values, const Play& play, int n_threads,
                      const Poll& poll) const {
    const Layer& layer = layers_[turn];
    const int* const n = layer.n_joint;
    const std::size_t size = static_cast<std::size_t>(n[0]) * n[1];
    struct Room {
        MatrixGame game;
        std::vector<double> matrix, rows, cols;
        double gap = 0;
    };
    std::vector<Room> rooms(n_threads);
    for_each_state(0, layer.codes.size(), n_threads, poll, [&](std::size_t state, int thread) {
        Room& room = rooms[thread];
        room.matrix.resize(size);
        room.rows.resize(n[0]);
        room.cols.resize(n[1]);
        const std::int32_t* const successors = &layer.successors[state * size];
        for (std::size_t i = 0; i < size; ++i) room.matrix[i] = next[successors[i]];
        int n_rows = n[0];
        int n_cols = n[1];
        if (play.given[0]) mix_rows(play.given[0] + state * n[0], n_rows, n_cols, room.matrix);
        if (play.given[1]) mix_cols(play.given[1] + state * n[1], n_rows, n_cols, room.matrix);
        const GameValue solved =
            room.game.solve(room.matrix.data(), n_rows, n_cols, room.rows.data(), room.cols.data());
        values[state] = solved.value;
        room.gap = std::max(room.gap, solved.gap);
        if (play.chosen[0]) std::copy_n(room.rows.begin(), n_rows, play.chosen[0] + state * n[0]);
        if (play.chosen[1]) std::copy_n(room.cols.begin(), n_cols, play.chosen[1] + state * n[1]);
    });
    double gap = 0;
    for (const Room& room : rooms) gap = std::max(gap, room.gap);
    return gap;
}

}  // namespace matrixworld
