// Plays random worlds and batches under every combination of the rules, for a build with sanitizers
// and with assertions that throw (MATRIXWORLD_SANITIZE). Checks the invariants of each; prints those
// that fail and exits with 1 if any does.
//
//     random_worlds [rounds]
#include <climits>

#include "invariants.hpp"
#include "play/batch.hpp"
#include "solve/table_policy.hpp"

namespace matrixworld::tests {
namespace {

std::vector<int> pairs(const World& world, int first, int last) {
    std::vector<int> flat;
    for (int a = first; a < last; ++a) {
        flat.push_back(world.grid().row(world.cell(a)));
        flat.push_back(world.grid().col(world.cell(a)));
    }
    return flat;
}

// A world whose placement is given equals the one that was drawn with the same placement. A wrong
// placement is refused and changes nothing.
void check_placement(const SharedSetup& setup, const World& world) {
    const Config& config = setup->config;
    Placement placement{pairs(world, 0, config.n_pursuers),
                        pairs(world, config.n_pursuers, config.n_agents()),
                        ByteArray::Zero(config.rows * config.cols)};
    world.terrain().write_map(placement.map.data());
    Scratch scratch(*setup);
    World copy(setup);
    copy.reset({1, 1}, scratch, placement);
    check_equal(world, copy);
    require((world.terrain().kind == copy.terrain().kind).all(), "the same terrain");

    Placement overlap = placement;
    std::copy_n(overlap.evaders.begin(), 2, overlap.pursuers.begin());
    Placement outside = placement;
    outside.evaders[0] = config.rows;
    Placement too_many = placement;
    too_many.pursuers.insert(too_many.pursuers.end(), {0, 0});
    Placement small_map = placement;
    small_map.map = ByteArray::Zero(1);
    for (const Placement& wrong : {overlap, outside, too_many, small_map}) {
        require(refused([&] { copy.reset({2, 0}, scratch, wrong); }), "a wrong placement");
        check_equal(world, copy);
    }
}

void play_world(const Rules& rules, Random& random) {
    const auto setup = std::make_shared<const Setup>(random_config(rules, random));
    Scratch scratch(*setup);
    World world(setup);
    world.reset({random.bits(), random.bits()}, scratch);
    check_moment(world, scratch, random);
    check_placement(setup, world);
    Scratch other(*setup);
    World twin = world;
    twin.enter(other);
    std::vector<Conflict> log;
    while (!world.over()) {
        const World before = world;
        const auto actions = random_actions(setup->config, setup->config.n_agents(), random);
        log.clear();
        world.step(actions.data(), scratch, &log);
        twin.step(actions.data(), other);
        check_equal(world, twin);
        check_moment(world, scratch, random);
        check_moves(before, world, actions);
        check_apart(before, world);
        for (const Conflict& conflict : log) check_conflict(before, world, conflict);
    }
    world.leave(scratch);
    check_occupancy(world, scratch.occupancy, false);
}

// A world restored from a snapshot between two turns goes on as the original does.
void play_snapshots(const Rules& rules, Random& random) {
    const auto setup = std::make_shared<const Setup>(random_config(rules, random));
    Scratch scratch(*setup);
    World world(setup);
    world.reset({random.bits(), random.bits()}, scratch);
    for (int round = 0; round < 4 && !world.over(); ++round) {
        const auto actions = random_actions(setup->config, setup->config.n_agents(), random);
        const int cut = random.below(world.n_turns());
        world.begin_round();
        for (int turn = 0; turn < cut; ++turn) world.play_turn(turn, actions.data(), scratch);
        Scratch other(*setup);
        World copy(setup);
        copy.restore(world.snapshot(scratch), other);
        require((world.terrain().kind == copy.terrain().kind).all(), "the same terrain");
        for (int turn = cut; turn < world.n_turns(); ++turn) {
            world.play_turn(turn, actions.data(), scratch);
            copy.play_turn(turn, actions.data(), other);
            check_equal(world, copy);
        }
        world.end_round();
        copy.end_round();
        check_equal(world, copy);
        check_occupancy(copy, other.occupancy, true);
    }
    Snapshot wrong = world.snapshot(scratch);
    wrong.cells[0] = setup->config.rows * setup->config.cols;
    World kept(setup);
    Scratch empty(*setup);
    require(refused([&] { kept.restore(wrong, empty); }), "a cell outside the grid in a snapshot");
}

// ---- Batches ---------------------------------------------------------------------------------

// The same worlds, one after the other.
class SingleWorlds {
  public:
    SingleWorlds(const SharedSetup& setup, int n_worlds, Autoreset autoreset)
        : autoreset_(autoreset),
          worlds_(static_cast<std::size_t>(n_worlds), World(setup)),
          statistics_(worlds_.size(), StatisticsAccumulator(setup->config)),
          scratch_(*setup),
          observer_(*setup) {
        source_.observer = &observer_;
    }

    void reset(const std::vector<std::uint64_t>& seeds, std::uint64_t episode, Memory& memory) {
        for (std::size_t w = 0; w < worlds_.size(); ++w) {
            begin(w, {seeds[w], episode});
            source_.acts = source_.ended = false;
            for (const Written when : {Written::StepStart, Written::Step, Written::Moment}) {
                write(when, w, memory.buffers);
            }
        }
    }

    void step(const std::vector<std::uint8_t>& actions, Memory& memory) {
        for (std::size_t w = 0; w < worlds_.size(); ++w) {
            World& world = worlds_[w];
            source_.acts = !world.over();
            source_.ended = false;
            write(Written::StepStart, w, memory.buffers);
            if (!world.over()) {
                play(w, actions, memory.buffers);
                if (world.over() && autoreset_ == Autoreset::SameStep) begin(w, next(w));
            } else if (autoreset_ == Autoreset::NextStep) {
                begin(w, next(w));
                write(Written::Step, w, memory.buffers);
            } else {
                world.begin_round();
                write(Written::Step, w, memory.buffers);
            }
            write(Written::Moment, w, memory.buffers);
        }
    }

  private:
    EpisodeKey next(std::size_t w) const {
        return {worlds_[w].key().seed, worlds_[w].key().episode + 1};
    }

    void begin(std::size_t w, EpisodeKey key) {
        worlds_[w].reset(key, scratch_);
        worlds_[w].leave(scratch_);
        statistics_[w] = StatisticsAccumulator(worlds_[w].config());
    }

    void play(std::size_t w, const std::vector<std::uint8_t>& actions, const Buffers& buffers) {
        World& world = worlds_[w];
        world.enter(scratch_);
        world.step(actions.data() + w * static_cast<std::size_t>(world.config().n_agents()),
                   scratch_);
        statistics_[w].add(world, scratch_.occupancy);
        world.leave(scratch_);
        source_.ended = world.over();
        write(Written::Step, w, buffers);
        if (!world.over()) return;
        const EpisodeStatistics statistics = statistics_[w].total(world);
        source_.statistics = &statistics;
        write(Written::EpisodeEnd, w, buffers);
    }

    void write(Written when, std::size_t w, const Buffers& buffers) {
        worlds_[w].enter(scratch_);
        source_.look_at(worlds_[w], scratch_.occupancy);
        buffers.write(when, source_, w);
        worlds_[w].leave(scratch_);
    }

    Autoreset autoreset_;
    std::vector<World> worlds_;
    std::vector<StatisticsAccumulator> statistics_;
    Scratch scratch_;
    Observer observer_;
    OutputSource source_;
};

void play_batch(const Rules& rules, Random& random) {
    const auto setup = std::make_shared<const Setup>(random_config(rules, random));
    const Config& config = setup->config;
    const int n_worlds = random.between(1, 40);
    const auto autoreset = static_cast<Autoreset>(random.below(3));
    Memory memory(config, n_worlds);
    Memory expected(config, n_worlds);
    Batch batch(setup, n_worlds, random.between(1, 4), autoreset);
    SingleWorlds singles(setup, n_worlds, autoreset);
    std::vector<std::uint64_t> seeds(static_cast<std::size_t>(n_worlds));
    for (auto& seed : seeds) seed = random.bits();

    batch.reset(seeds.data(), 3, nullptr, {}, memory.buffers);
    singles.reset(seeds, 3, expected);
    require(memory.bytes == expected.bytes, "a batch begins like single worlds");
    for (int step = 0; step < 6; ++step) {
        auto actions = random_actions(config, n_worlds * config.n_agents(), random);
        batch.step(actions.data(), memory.buffers);
        singles.step(actions, expected);
        require(memory.bytes == expected.bytes, "a batch plays like single worlds");
    }
}

// The policies of both teams decide in a batch as they do in the worlds one after the other, by any
// number of threads. A world may have a policy that decides nothing.
void play_decisions(const Rules& rules, Random& random) {
    const auto setup = std::make_shared<const Setup>(random_config(rules, random));
    const Config& config = setup->config;
    const int n_worlds = random.between(1, 40);
    std::vector<std::unique_ptr<Side>> sides;
    std::vector<Candidates> policies(1);
    for (int i = 0; i < 3; ++i) {
        sides.push_back(random_side(config, random));
        policies.push_back(sides.back()->candidates);
    }
    std::vector<std::int32_t> chosen(static_cast<std::size_t>(n_worlds));
    for (auto& number : chosen) number = random.below(static_cast<int>(policies.size()));
    const Buffers nowhere;
    Batch batch(setup, n_worlds, random.between(1, 4), Autoreset::Disabled);
    batch.reset(nullptr, 0, nullptr, {}, nowhere);
    const auto n_agents = static_cast<std::size_t>(config.n_agents());
    for (int step = 0; step < 4; ++step) {
        std::vector<std::int64_t> actions(chosen.size() * n_agents, 0);
        std::vector<std::int64_t> expected = actions;
        for (const auto& [first, last] :
             {std::pair{0, config.n_pursuers}, std::pair{config.n_pursuers, config.n_agents()}}) {
            batch.decide(policies, chosen, first, last, actions.data());
            for (std::size_t w = 0; w < chosen.size(); ++w) {
                Scratch scratch(*setup);
                World world(setup);
                world.restore(batch.snapshot(static_cast<int>(w)), scratch);
                if (world.over() || chosen[w] == 0) continue;
                LoadedPolicy(policies[chosen[w]], *setup)
                    .load(0)
                    .decide(world, scratch.occupancy, first, last, &expected[w * n_agents]);
            }
        }
        require(actions == expected, "policies decide in a batch as in single worlds");
        batch.step(actions.data(), nowhere);
    }
}

// ---- The build and the limits ----------------------------------------------------------------

void check_build() {
    bool thrown = false;
    try {
        const IntArray array = IntArray::Zero(3);
        thrown = array[static_cast<Eigen::Index>(n_passed < 0 ? 0 : 3)] != 0;
    } catch (const std::logic_error&) {
        thrown = true;
    }
    require(thrown, "Eigen's assertions throw");
}

void check_limits() {
    const auto refuses = [](auto change) {
        Config config;
        change(config);
        return refused([&] { Setup setup(config); });
    };
    require(!refuses([](Config&) {}), "the defaults");
    require(refuses([](Config& c) { c.rows = kMaxSide + 1; }), "too many rows");
    require(refuses([](Config& c) { c.cols = 0; }), "no columns");
    require(refuses([](Config& c) { c.n_pursuers = 0; }), "no pursuers");
    require(refuses([](Config& c) { c.n_evaders = 40 * 40; }), "more agents than cells");
    require(refuses([](Config& c) { c.fov = 4; }), "an even field of view");
    require(refuses([](Config& c) { c.fov = kMaxFieldOfView + 2; }), "too wide a view");
    require(refuses([](Config& c) { c.max_steps = 0; }), "no steps");
    require(refuses([](Config& c) { c.density = 1.0; }), "obstacles everywhere");
    require(refuses([](Config& c) { c.density = 0.999; }), "no room between obstacles");
    require(refuses([](Config& c) { c.map = ByteArray::Zero(3); }), "a map of another size");
    require(refuses([](Config& c) { c.rows = INT_MAX; }), "rows that overflow");
    require(refuses([](Config& c) { c.cols = INT_MAX; }), "columns that overflow");
    require(refused([] { Network(11, {0}, 5, Activation::Relu, true); }), "an empty layer");
    require(refused([] { Network(INT_MAX, {}, 5, Activation::Relu, true); }),
            "a view that overflows");
    require(refused([] { Network(11, {INT_MAX}, 5, Activation::Relu, true); }),
            "too large a layer");
}

// Sizes of a rollout beyond every memory: refused, or too large to allocate, but never computed wrong.
void check_large_rollout() {
    const auto setup = std::make_shared<const Setup>(Config());
    Candidates candidates;
    candidates.script = find_script("still");
    const std::vector<Match> none;
    for (const int n_worlds : {0, -1}) {
        require(refused([&] { play_matches(setup, candidates, candidates, none, n_worlds, 1); }),
                "no worlds");
    }
    require(play_matches(setup, candidates, candidates, none, INT_MAX, 1).empty(), "no matches");
}

// The largest grid and the widest views: where indices are largest.
void check_large(Random& random) {
    Config config;
    config.rows = kMaxSide;
    config.cols = kMaxSide;
    config.n_pursuers = 2000;
    config.n_evaders = 2000;
    config.fov = kMaxFieldOfView;
    const auto setup = std::make_shared<const Setup>(config);
    Scratch scratch(*setup);
    World world(setup);
    world.reset({7, 7}, scratch);
    for (int step = 0; step < 3; ++step) {
        const World before = world;
        const auto actions = random_actions(config, config.n_agents(), random);
        world.step(actions.data(), scratch);
        check_moves(before, world, actions);
    }
    check_positions(world);
    check_counters(world);
    check_view(world, scratch.occupancy, world.living().back());
}

// All states of a tiny world, three rounds back from the end, and an episode by the play that was
// found: values are shares, and the strategies guarantee what they say.
void solve_world(const Rules& rules, Random& random) {
    Config config;
    config.rules = rules;
    config.rows = config.cols = 2;
    config.n_pursuers = random.between(1, 2);
    config.n_evaders = 3 - config.n_pursuers;
    config.diagonal = random.below(2) == 1;
    config.max_steps = 3;
    const auto setup = std::make_shared<const Setup>(config);
    const auto states = std::make_shared<const States>(setup, random.between(1, 3));
    std::vector<double> values(states->n_states(0), 0.0);
    for (int k = 0; k < states->n_ends(); ++k) values[k] = k / (states->n_ends() - 1.0);
    Tables tables{states, Team::Pursuer, 1, config.max_steps, {}};
    tables.by_turn.resize(states->n_turns());
    for (int i = 3 * states->n_turns() - 1; i >= 0; --i) {
        const int turn = i % states->n_turns();
        const auto n = static_cast<std::size_t>(states->n_states(turn));
        std::vector<double> chosen(n * states->n_joint(turn, Team::Pursuer));
        std::vector<double> before(n);
        States::Play play;
        play.chosen[0] = chosen.data();
        const double gap = states->backup(turn, values.data(), before.data(), play, 2);
        require(gap < 1e-9, "strategies meet");
        values = before;
        tables.by_turn[turn].assign(chosen.begin(), chosen.end());
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    require(*low > -1e-9 && *high < 1 + 1e-9, "values are shares");
    const auto shared = std::make_shared<const Tables>(std::move(tables));
    Candidates pursuers, evaders;
    pursuers.make = [&] { return std::make_unique<TablePolicy>(shared); };
    evaders.script = find_script("random");
    const std::vector<Match> match = {{0, 0, random.below(1000) + 0u}};
    require(play_matches(setup, pursuers, evaders, match, 5, 2).size() == 5, "it plays");
}

}  // namespace
}  // namespace matrixworld::tests

int main(int argc, char** argv) {
    using namespace matrixworld::tests;
    Random random(20);
    run("build", check_build);
    run("limits", check_limits);
    run("large rollout", check_large_rollout);
    run("large world", [&] { check_large(random); });
    for (int world = 0; world < 2; ++world) {
        play_all("a world", play_world, argc, argv, random);
        play_all("snapshots", play_snapshots, argc, argv, random);
    }
    play_all("a batch", play_batch, argc, argv, random, 5);
    play_all("decisions", play_decisions, argc, argv, random, 5);
    play_all("a solution", solve_world, argc, argv, random);
    return finish("random worlds");
}
