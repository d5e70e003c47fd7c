// Everything that crosses between a page and the engine. The functions at the end of this file are
// all that JavaScript can call, and web/src/engine/ is the only caller. Values go in and come out as
// XX
//
// The engine itself (cpp/ without its bindings) is compiled together with these files, unchanged.
#include <emscripten/emscripten.h>

#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "named_arrays.hpp"
#include "play/rollout.hpp"
#include "played_world.hpp"
#include "settings.hpp"
#include "solve/matrix_game.hpp"
#include "solve/states.hpp"

namespace matrixworld {

namespace {

Outputs outputs;    // of the last call
std::string error;  // of the last call that failed

// Calls a function; an exception becomes `error`. Nothing is thrown into JavaScript.
template <typename Call>
bool succeeds(Call call) {
    outputs.clear();
    try {
        call();
        return true;
    } catch (const std::bad_alloc&) {
        error = "memory: expected room for this world, got none";
    } catch (const std::exception& exception) {
        error = exception.what();
    }
    return false;
}

// The numbers of a conflict in the order of Python's CONFLICT_COLUMNS.
std::array<int, 10> numbers_of(const Conflict& c, const Grid& grid) {
    return {c.turn,
            static_cast<int>(c.kind),
            static_cast<int>(c.form),
            c.first,
            c.second,
            grid.row(c.cell),
            grid.col(c.cell),
            int{c.at_fault},
            int{c.held},
            int{c.doomed}};
}

void append_conflicts(const PlayedWorld& played, int step, std::vector<int>& table) {
    for (const Conflict& conflict : played.conflicts()) {
        table.push_back(step);
        const auto numbers = numbers_of(conflict, played.world().grid());
        table.insert(table.end(), numbers.begin(), numbers.end());
    }
}

// ---- Snapshots ----------------------------------------------------------------------------------

// A field of a snapshot is a number, or a list of numbers.
template <typename Value>
void add_value(const char* name, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
        outputs.add(name, &value, 1);
    } else {
        outputs.add(name, value.data(), static_cast<std::size_t>(value.size()));
    }
}

template <typename Value>
void read_value(const Inputs& in, const char* name, Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
        value = in.number<Value>(name);
    } else {
        const auto given = in.list<typename Value::value_type>(name);
        value.resize(given.size());
        std::copy(given.begin(), given.end(), value.data());
    }
}

// ---- Matches ------------------------------------------------------------------------------------

// The fields of a recorded episode, as in Python's `Episode`.
constexpr std::array kOfMoments = {"positions", "last_positions", "alive", "captured",
                                   "ever_captured"};
constexpr std::array kOfSteps = {"rewards", "involved", "fault"};

// One output field, moment after moment.
class Column {
  public:
    Column(const char* name, std::size_t n_moments, const Config& config)
        : field_(*find_field(world_fields(), name)),
          size_(field_.n_items(config) * item_size(field_.dtype)),
          next_(outputs.add(name, field_.dtype, n_moments * field_.n_items(config))) {}

    void append(PlayedWorld& played) {
        played.write(field_, next_);
        next_ += size_;
    }

  private:
    const OutputField& field_;
    std::size_t size_;  // bytes of a moment
    std::uint8_t* next_;
};

// The actions of one episode, round by round, and its statistics.
EpisodeStatistics choose_actions(const std::shared_ptr<const Setup>& setup, const Player& pursuers,
                                 const Player& evaders, EpisodeKey key,
                                 std::vector<std::uint8_t>& actions) {
    const auto append = [&](const World&, const Occupancy&, const std::vector<std::uint8_t>* row) {
        if (row) actions.insert(actions.end(), row->begin(), row->end());
    };
    return play_episode(setup, pursuers.candidates, evaders.candidates, {0, 0, key.seed},
                        key.episode, append);
}

// Plays the actions again in a world, which gives everything else, as in Python's `record`.
void record(const std::shared_ptr<const Setup>& setup, EpisodeKey key,
            const std::vector<std::uint8_t>& actions) {
    const Config& config = setup->config;
    const std::size_t n_agents = static_cast<std::size_t>(config.n_agents());
    const std::size_t length = actions.size() / n_agents;
    PlayedWorld played(setup);
    played.reset(key, {});
    std::vector<Column> of_moments, of_steps;
    for (const char* name : kOfMoments) of_moments.emplace_back(name, length + 1, config);
    for (const char* name : kOfSteps) of_steps.emplace_back(name, length, config);
    outputs.add("actions", actions.data(), actions.size());
    std::uint8_t* map = outputs.add("map", DType::Bool, config.rows * config.cols);
    played.world().terrain().write_map(map);

    std::vector<int> table;  // of the conflicts: the step, then their numbers
    for (Column& column : of_moments) column.append(played);
    for (std::size_t t = 0; t < length; ++t) {
        const auto row = actions.begin() + t * n_agents;
        played.step({row, row + n_agents});
        for (Column& column : of_moments) column.append(played);
        for (Column& column : of_steps) column.append(played);
        append_conflicts(played, static_cast<int>(t) + 1, table);
    }
    outputs.add("conflict_table", table.data(), table.size());
}

void add_statistics(const std::vector<EpisodeStatistics>& episodes, const Config& config) {
    OutputSource source;  // without a world: statistics need none
    for (const StatisticField& statistic : statistic_fields()) {
        const OutputField& field = statistic.field;
        const std::size_t n_items = field.n_items(config);
        std::uint8_t* out =
            outputs.add("statistics." + field.name, field.dtype, episodes.size() * n_items);
        for (const EpisodeStatistics& episode : episodes) {
            source.statistics = &episode;
            field.write(source, out);
            out += n_items * item_size(field.dtype);
        }
    }
}

}  // namespace

}  // namespace matrixworld

// ---- What JavaScript calls ----------------------------------------------------------------------

using namespace matrixworld;

extern "C" {

// The results of the last call, and what went wrong in the last one that returned false (or null).
EMSCRIPTEN_KEEPALIVE const NamedArrays* last_outputs() { return outputs.arrays(); }
EMSCRIPTEN_KEEPALIVE const char* last_error() { return error.c_str(); }

// A world in its first episode of seed 0, or null.
EMSCRIPTEN_KEEPALIVE PlayedWorld* world_new(const NamedArrays* config) {
    PlayedWorld* played = nullptr;
    succeeds([&] { played = new PlayedWorld(to_setup(Inputs(config))); });
    return played;
}

EMSCRIPTEN_KEEPALIVE void world_free(PlayedWorld* played) { delete played; }

EMSCRIPTEN_KEEPALIVE bool world_reset(PlayedWorld* played, const NamedArrays* start) {
    return succeeds([&] { played->reset(to_key(Inputs(start)), to_placement(Inputs(start))); });
}

// Plays a round, or the next turn of one, with `actions` (A,).
EMSCRIPTEN_KEEPALIVE bool world_step(PlayedWorld* played, const NamedArrays* actions) {
    return succeeds([&] { played->step(Inputs(actions).list<int>("actions")); });
}

EMSCRIPTEN_KEEPALIVE bool world_play_turn(PlayedWorld* played, const NamedArrays* actions) {
    return succeeds([&] { played->play_turn(Inputs(actions).list<int>("actions")); });
}

// (turn, n_turns, first and last of the agents that act in it)
EMSCRIPTEN_KEEPALIVE bool world_turn(PlayedWorld* played) {
    return succeeds([&] {
        const auto [first, last] = played->actors();
        const std::array<int, 4> turn = {played->turn(), played->world().n_turns(), first, last};
        outputs.add("turn", turn.data(), turn.size());
    });
}

// One of the engine's output fields (cpp/play/output_fields.cpp), by name.
EMSCRIPTEN_KEEPALIVE bool world_read(PlayedWorld* played, const char* name) {
    return succeeds([&] {
        const OutputField* field = find_field(world_fields(), name);
        if (!field) throw std::invalid_argument("read: no array has the name " + std::string(name));
        const std::size_t n = field->n_items(played->config());
        played->write(*field, outputs.add(name, field->dtype, n));
    });
}

// (n, 11): the number of the step, then the numbers of each conflict of the last round.
EMSCRIPTEN_KEEPALIVE bool world_conflicts(PlayedWorld* played) {
    return succeeds([&] {
        std::vector<int> table;
        append_conflicts(*played, played->world().steps(), table);
        outputs.add("conflict_table", table.data(), table.size());
    });
}

// `actions` (A,), in which a policy has chosen those of the living agents [first, last).
EMSCRIPTEN_KEEPALIVE bool world_decide(PlayedWorld* played, const NamedArrays* policy, int first,
                                       int last, const NamedArrays* actions) {
    return succeeds([&] {
        const Player player(Inputs(policy), played->config());
        std::vector<int> chosen = Inputs(actions).list<int>("actions");
        chosen.resize(played->config().n_agents());
        played->decide(player.candidates, first, last, chosen);
        outputs.add("actions", chosen.data(), chosen.size());
    });
}

// The outputs of a network for a living agent, and what the agent remembers for it.
EMSCRIPTEN_KEEPALIVE bool world_logits(PlayedWorld* played, const NamedArrays* policy, int agent) {
    return succeeds([&] {
        const Player player(Inputs(policy), played->config());
        const std::vector<float> logits = played->logits(player, agent);
        outputs.add("logits", logits.data(), logits.size());
        const std::vector<float> memory = played->memory(player, agent);
        outputs.add("memory", memory.data(), memory.size());
    });
}

// By move of a living agent: `ratings`, and whether the mask of the policy refuses it.
EMSCRIPTEN_KEEPALIVE bool world_rate(PlayedWorld* played, const NamedArrays* policy, int agent) {
    return succeeds([&] {
        const Player player(Inputs(policy), played->config());
        const auto [ratings, refused] = played->rate(player, agent);
        outputs.add("ratings", ratings.data(), ratings.size());
        outputs.add("refused", refused.data(), refused.size());
    });
}

EMSCRIPTEN_KEEPALIVE bool world_snapshot(PlayedWorld* played) {
    return succeeds([&] {
        const Snapshot snapshot = played->snapshot();
        add_value("turn", played->turn());
        for_each_field(
            snapshot, played->config(),
            [](const SnapshotField& field, const auto& value) { add_value(field.name, value); });
    });
}

EMSCRIPTEN_KEEPALIVE bool world_restore(PlayedWorld* played, const NamedArrays* given) {
    return succeeds([&] {
        const Inputs in(given);
        Snapshot snapshot;
        for_each_field(snapshot, played->config(), [&](const SnapshotField& field, auto& value) {
            read_value(in, field.name, value);
        });
        played->restore(snapshot, in.number<int>("turn"));
    });
}

// A recorded episode: the arrays of Python's `Episode`, and its statistics.
EMSCRIPTEN_KEEPALIVE bool play_match(const NamedArrays* config, const NamedArrays* pursuers,
                                     const NamedArrays* evaders, const NamedArrays* episode) {
    return succeeds([&] {
        const auto setup = to_setup(Inputs(config));
        const Player left(Inputs(pursuers), setup->config);
        const Player right(Inputs(evaders), setup->config);
        const EpisodeKey key = to_key(Inputs(episode));
        std::vector<std::uint8_t> actions;
        add_statistics({choose_actions(setup, left, right, key, actions)}, setup->config);
        record(setup, key, actions);
    });
}

// The states of a small world (cpp/solve/states.hpp), or null. JavaScript asks for no large ones.
EMSCRIPTEN_KEEPALIVE States* states_new(const NamedArrays* config) {
    States* states = nullptr;
    succeeds([&] { states = new States(to_setup(Inputs(config)), 1); });
    return states;
}

EMSCRIPTEN_KEEPALIVE void states_free(States* states) { delete states; }

// `payoffs` (states of the first turn): the capture rate of an episode that is over there; and the
// `starts` among these states.
EMSCRIPTEN_KEEPALIVE bool states_payoffs(const States* states) {
    return succeeds([&] {
        const Config& config = states->setup().config;
        std::vector<int> cells(config.n_agents());
        std::vector<std::uint8_t> captured(config.n_evaders);
        std::vector<double> payoffs(states->n_states(0));
        for (std::size_t state = 0; state < payoffs.size(); ++state) {
            states->describe(0, static_cast<std::int64_t>(state), cells.data(), captured.data());
            const auto count = std::count(captured.begin(), captured.end(), 1);
            payoffs[state] = static_cast<double>(count) / config.n_evaders;
        }
        outputs.add("payoffs", payoffs.data(), payoffs.size());
        outputs.add("starts", states->starts().data(), states->starts().size());
    });
}

// `values` of a turn's states from those of the next turn's, `next`. A team whose `pursuers` or
// `evaders` are given, as `states_weigh` returns them, plays by these probabilities; others play
// their best.
EMSCRIPTEN_KEEPALIVE bool states_backup(const States* states, int turn, const NamedArrays* given) {
    return succeeds([&] {
        const Inputs in(given);
        const auto after = in.list<double>("next");
        const auto pursuers = in.list<double>("pursuers");
        const auto evaders = in.list<double>("evaders");
        States::Play play;
        if (!pursuers.empty()) play.given[static_cast<int>(Team::Pursuer)] = pursuers.data();
        if (!evaders.empty()) play.given[static_cast<int>(Team::Evader)] = evaders.data();
        std::vector<double> values(states->n_states(turn));
        states->backup(turn, after.data(), values.data(), play, 1);
        outputs.add("values", values.data(), values.size());
    });
}

// `play` (states of a turn, joint actions): the probabilities with which a policy plays for a team in
// a step.
EMSCRIPTEN_KEEPALIVE bool states_weigh(const States* states, int turn, bool evaders, int step,
                                       const NamedArrays* policy) {
    return succeeds([&] {
        const Team team = evaders ? Team::Evader : Team::Pursuer;
        const Player player(Inputs(policy), states->setup().config);
        std::vector<double> play(states->n_states(turn) * states->n_joint(turn, team));
        states->weigh(turn, team, player.candidates, {{}, step}, play.data(), 1);
        outputs.add("play", play.data(), play.size());
    });
}

// The game of a world's next turn: `matrix`, the values `next` of what joint actions lead to, with
// its `value`, the perfect play of both teams (`rows`, `cols`), and the `agents` in the order of
// the state. No agents: the world's moment is none of the states, or an end.
EMSCRIPTEN_KEEPALIVE bool states_game(const States* states, const PlayedWorld* played,
                                      const NamedArrays* next) {
    return succeeds([&] {
        std::vector<int> agents;
        const int turn = played->turn();
        const std::int64_t state = states->find(played->world(), turn, agents);
        if (state < states->n_ends()) agents.clear();
        outputs.add("agents", agents.data(), agents.size());
        if (agents.empty()) return;
        const auto after = Inputs(next).list<double>("next");
        std::vector<double> rows(states->n_joint(turn, Team::Pursuer));
        std::vector<double> cols(states->n_joint(turn, Team::Evader));
        std::vector<double> matrix(rows.size() * cols.size());
        const std::int32_t* const successors = &states->successors(turn)[state * matrix.size()];
        for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] = after[successors[i]];
        const GameValue solved =
            MatrixGame().solve(matrix.data(), static_cast<int>(rows.size()),
                               static_cast<int>(cols.size()), rows.data(), cols.data());
        outputs.add("value", &solved.value, 1);
        outputs.add("matrix", matrix.data(), matrix.size());
        outputs.add("rows", rows.data(), rows.size());
        outputs.add("cols", cols.data(), cols.size());
    });
}

// The statistics of episodes 0 to n - 1 of each match: a genome of the pursuers by its number, one of
// the evaders, and a seed.
EMSCRIPTEN_KEEPALIVE bool play_rollout(const NamedArrays* config, const NamedArrays* pursuers,
                                       const NamedArrays* evaders, const NamedArrays* matches) {
    return succeeds([&] {
        const auto setup = to_setup(Inputs(config));
        const Player left(Inputs(pursuers), setup->config, Player::Genomes::Several);
        const Player right(Inputs(evaders), setup->config, Player::Genomes::Several);
        const Inputs in(matches);
        add_statistics(play_matches(setup, left.candidates, right.candidates,
                                    to_matches(in, left.candidates.n, right.candidates.n),
                                    in.number<int>("n_episodes"), 1),
                       setup->config);
    });
}

}  // extern "C"
