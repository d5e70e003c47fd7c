#include "world.hpp"

#include <algorithm>
#include <bitset>
#include <stdexcept>
#include <string>

namespace matrixworld {

namespace {

// Deals the cells of the world in random order, one by one, and restores the pack at the end.
class Dealer {
  public:
    Dealer(Scratch& scratch, Stream& stream)
        : order_(scratch.order), swaps_(scratch.swaps), stream_(stream) {}
    ~Dealer() {
        for (int i = static_cast<int>(swaps_.size()) - 1; i >= 0; --i) {
            std::swap(order_[i], order_[swaps_[i]]);
        }
        swaps_.clear();
    }
    Dealer(const Dealer&) = delete;
    Dealer& operator=(const Dealer&) = delete;

    int next() {
        const int dealt = static_cast<int>(swaps_.size());
        const int pick = dealt + below(stream_.next(), static_cast<int>(order_.size()) - dealt);
        swaps_.push_back(pick);
        std::swap(order_[dealt], order_[pick]);
        return order_[dealt];
    }

  private:
    IntArray& order_;
    std::vector<int>& swaps_;
    Stream& stream_;
};

void require_count(const char* team, std::size_t flat, int n) {
    if (flat == 0 || flat == 2 * static_cast<std::size_t>(n)) return;
    throw std::invalid_argument(std::string(team) + " positions: expected " + std::to_string(n) +
                                " (row, col) pairs, got " + std::to_string(flat / 2));
}

}  // namespace

// ---- What worlds share ------------------------------------------------------------------------

Ground::Ground(const Grid& grid, int margin)
    : kind(ByteArray::Constant(grid.n_cells(), kBorder)), walls(grid, margin) {
    clear_obstacles(grid);
}

void Ground::set_obstacle(const Grid& grid, int cell) {
    kind[cell] = kObstacle;
    walls.set(grid.row(cell), grid.col(cell));
    has_obstacles = true;
}

void Ground::clear_obstacles(const Grid& grid) {
    for (int row = 0; row < grid.rows(); ++row) {
        kind.segment(grid.cell(row, 0), grid.cols()).setConstant(kFree);
    }
    walls.clear_all();
    has_obstacles = false;
}

namespace {

void set_map(Ground& ground, const Grid& grid, const ByteArray& map) {
    for (int i = 0; i < map.size(); ++i) {
        if (map[i]) ground.set_obstacle(grid, grid.cell(i / grid.cols(), i % grid.cols()));
    }
}

}  // namespace

Setup::Setup(Config given) : config(std::move(given)), grid(config.rows, config.cols) {
    config.validate();
    auto base = std::make_shared<Ground>(grid, config.fov / 2);
    set_map(*base, grid, config.map);
    ground = std::move(base);
}

Scratch::Scratch(const Setup& setup)
    : occupancy(setup.grid, setup.config.n_pursuers, setup.config.n_agents(), setup.config.fov / 2),
      resolver(setup.grid, setup.config.rules, setup.config.n_pursuers, setup.config.n_agents()),
      order(setup.config.rows * setup.config.cols),
      move(ByteArray::Zero(setup.config.n_agents())) {
    for (int i = 0; i < order.size(); ++i) {
        order[i] = setup.grid.cell(i / setup.config.cols, i % setup.config.cols);
    }
    cast.reserve(setup.config.n_agents());
    last_cast.reserve(setup.config.n_agents());
}

// ---- Reset --------------------------------------------------------------------------------------

World::World(std::shared_ptr<const Setup> setup)
    : setup_(std::move(setup)),
      ground_(setup_->ground),
      cell_(IntArray::Constant(config().n_agents(), kGone)),
      captured_(ByteArray::Zero(config().n_evaders)),
      ever_captured_(ByteArray::Zero(config().n_evaders)),
      capture_paid_(ByteArray::Zero(config().n_evaders)),
      captors_(IntArray::Zero(config().n_evaders)),
      is_judged_(ByteArray::Zero(config().n_evaders)),
      rewards_(FloatArray::Zero(config().n_agents())),
      report_(decltype(report_)::Zero(config().n_agents())) {
    living_.reserve(config().n_agents());
    judged_.reserve(config().n_evaders);
}

void World::check(const Placement& placement) const {
    require_count("pursuer", placement.pursuers.size(), config().n_pursuers);
    require_count("evader", placement.evaders.size(), config().n_evaders);
    const ByteArray& map = placement.map.size() ? placement.map : config().map;
    const int area = config().rows * config().cols;
    if (map.size() != 0 && map.size() != area) {
        throw std::invalid_argument("obstacle map: expected " + std::to_string(area) +
                                    " cells, got " + std::to_string(map.size()));
    }
    const int blocked =
        map.size() ? static_cast<int>(map.cast<int>().sum()) : config().n_random_obstacles();
    if (config().n_agents() > area - blocked) {
        throw std::invalid_argument("obstacle map: expected at least " +
                                    std::to_string(config().n_agents()) + " free cells, got " +
                                    std::to_string(area - blocked));
    }
    std::vector<int> taken;
    for (const auto* positions : {&placement.pursuers, &placement.evaders}) {
        for (std::size_t i = 0; i < positions->size(); i += 2) {
            const int row = (*positions)[i];
            const int col = (*positions)[i + 1];
            const std::string where = "(" + std::to_string(row) + ", " + std::to_string(col) + ")";
            if (row < 0 || row >= config().rows || col < 0 || col >= config().cols) {
                throw std::invalid_argument("position " + where + ": expected a cell of the " +
                                            std::to_string(config().rows) + " x " +
                                            std::to_string(config().cols) + " grid");
            }
            const int index = row * config().cols + col;
            if (map.size() && map[index]) {
                throw std::invalid_argument("position " + where +
                                            ": expected a free cell, got an obstacle");
            }
            taken.push_back(index);
        }
    }
    std::sort(taken.begin(), taken.end());
    const auto twice = std::adjacent_find(taken.begin(), taken.end());
    if (twice != taken.end()) {
        throw std::invalid_argument("positions: expected distinct cells, got two agents on (" +
                                    std::to_string(*twice / config().cols) + ", " +
                                    std::to_string(*twice % config().cols) + ")");
    }
}

void World::reset(EpisodeKey key, Scratch& scratch, const Placement& placement) {
    check(placement);
    begin_episode(key);
    lay_ground(placement);

    const auto place_given = [&](const std::vector<int>& positions, int first) {
        for (std::size_t i = 0; i < positions.size(); i += 2) {
            place(first + static_cast<int>(i / 2), grid().cell(positions[i], positions[i + 1]),
                  scratch);
        }
    };
    place_given(placement.pursuers, 0);
    place_given(placement.evaders, config().n_pursuers);

    Stream stream(key, Purpose::Reset);
    Dealer dealer(scratch, stream);
    const auto free_cell = [&] {
        int cell = dealer.next();
        while (ground_->kind[cell] != kFree || !scratch.occupancy.empty(cell)) cell = dealer.next();
        return cell;
    };
    const bool own_map = placement.map.size() != 0 || config().map.size() != 0;
    if (!own_map && config().n_random_obstacles() > 0) {
        auto ground = std::make_shared<Ground>(*setup_->ground);
        for (int i = 0; i < config().n_random_obstacles(); ++i) {
            ground->set_obstacle(grid(), free_cell());
        }
        ground_ = std::move(ground);
    }
    if (placement.evaders.empty()) {
        for (int e = 0; e < config().n_evaders; ++e) place(evader_agent(e), free_cell(), scratch);
    }
    if (placement.pursuers.empty()) {
        for (int p = 0; p < config().n_pursuers; ++p) place(p, free_cell(), scratch);
    }
}

void World::begin_episode(EpisodeKey key) {
    key_ = key;
    living_.resize(config().n_agents());
    for (int a = 0; a < config().n_agents(); ++a) living_[a] = a;
    n_living_[static_cast<int>(Team::Pursuer)] = config().n_pursuers;
    n_living_[static_cast<int>(Team::Evader)] = config().n_evaders;
    n_captured_ = 0;
    n_at_large_ = config().n_evaders;
    captured_.setZero();
    ever_captured_.setZero();
    capture_paid_.setZero();
    captors_.setZero();
    rewards_.setZero();
    report_.setZero();
    steps_ = 0;
    terminated_ = false;
    truncated_ = false;
}

void World::lay_ground(const Placement& placement) {
    ground_ = setup_->ground;
    if (placement.map.size() == 0) return;
    auto ground = std::make_shared<Ground>(grid(), config().fov / 2);
    set_map(*ground, grid(), placement.map);
    ground_ = std::move(ground);
}

void World::place(int agent, int cell, Scratch& scratch) {
    cell_[agent] = cell;
    scratch.occupancy.add(agent, cell);
}

void World::enter(Scratch& scratch) const {
    for (int a : living_) scratch.occupancy.add(a, cell_[a]);
}

void World::leave(Scratch& scratch) const {
    for (int a : living_) scratch.occupancy.remove(a, cell_[a]);
}

// ---- A round ------------------------------------------------------------------------------------

void World::step(const std::uint8_t* actions, Scratch& scratch, std::vector<Conflict>* log) {
    begin_round();
    for (int turn = 0; turn < n_turns(); ++turn) play_turn(turn, actions, scratch, log);
    end_round();
}

int World::n_turns() const {
    switch (config().rules.interaction) {
        case Interaction::Simultaneous:
            return 1;
        case Interaction::SwarmTurns:
            return kTeams;
        case Interaction::AgentTurns:
            break;
    }
    return config().n_agents();
}

void World::actors(int turn, int& first, int& last) const {
    switch (config().rules.interaction) {
        case Interaction::Simultaneous:
            first = 0;
            last = config().n_agents();
            return;
        case Interaction::SwarmTurns:
            first = turn == 0 ? 0 : config().n_pursuers;
            last = turn == 0 ? config().n_pursuers : config().n_agents();
            return;
        case Interaction::AgentTurns:
            first = turn;
            last = turn + 1;
            return;
    }
}

void World::begin_round() {
    rewards_.setZero();
    report_.setZero();
    captors_.setZero();
    if (config().rewards.capture_repeats) capture_paid_.setZero();
    fresh_round_ = true;
}

void World::play_turn(int number, const std::uint8_t* actions, Scratch& scratch,
                      std::vector<Conflict>* log) {
    int first = 0;
    int last = 0;
    actors(number, first, last);
    const bool nobody = last - first == 1 ? !alive(first) : n_living(team(first)) == 0;
    if (terminated_ || nobody) return;

    choose_cast(first, last, actions, scratch);
    const Turn turn{scratch.cast, cell_, scratch.move, ground_->kind, first, last, number};
    scratch.resolver.resolve(turn, log);
    settle(scratch);
    judge_captures(turn, scratch);
    pay_captures();
    remove_captured(scratch);
    pay_actors(turn, scratch);
    report_and_fine(scratch);
    drop_gone();
    judge_end();
    fresh_round_ = false;
}

void World::end_round() {
    ++steps_;
    truncated_ = steps_ >= config().max_steps;
}

// Everybody; where a single agent acts, it and those on the cell it leaves or heads for: nobody
// else can meet it.
void World::choose_cast(int first, int last, const std::uint8_t* actions, Scratch& scratch) const {
    std::swap(scratch.cast, scratch.last_cast);
    if (last - first > 1) {
        scratch.cast = living_;
    } else {
        scratch.cast.clear();
        scratch.here = cell_[first];
        scratch.there = scratch.here + grid().delta(actions[first]);
        const auto call = [&](int cell) {
            const Occupancy& occupancy = scratch.occupancy;
            for (int a = occupancy.first(cell); a >= 0; a = occupancy.next(a)) {
                scratch.cast.push_back(a);
            }
        };
        call(scratch.here);
        if (scratch.there != scratch.here) call(scratch.there);
    }
    for (int a : scratch.cast) {
        scratch.move[a] = a >= first && a < last ? actions[a] : std::uint8_t{0};
    }
}

void World::settle(Scratch& scratch) {
    for (int a : scratch.cast) {
        const Flags flags = scratch.resolver.flags(a);
        if (flags & (kCrashed | kDoomed)) {
            if (team(a) == Team::Evader) release(evader_number(a));  // until judged
            remove(a, scratch);
        } else if (!(flags & kHeld) && scratch.resolver.target(a) != cell_[a]) {
            scratch.occupancy.remove(a, cell_[a]);
            place(a, scratch.resolver.target(a), scratch);
        }
    }
}

void World::remove(int agent, Scratch& scratch) {
    scratch.occupancy.remove(agent, cell_[agent]);
    cell_[agent] = kGone;
    --n_living_[static_cast<int>(team(agent))];
    if (team(agent) == Team::Evader && !counts_as_captured(evader_number(agent))) --n_at_large_;
}

void World::drop_gone() {
    if (n_living_[0] + n_living_[1] == static_cast<int>(living_.size())) return;
    living_.erase(std::remove_if(living_.begin(), living_.end(), [&](int a) { return !alive(a); }),
                  living_.end());
}

// ---- Captures -------------------------------------------------------------------------------------

bool World::counts_as_captured(int evader) const {
    return config().rules.capture == Capture::Occupation ? ever_captured_[evader]
                                                         : captured_[evader];
}

void World::set_captured(int evader, bool captured) {
    const bool counted = counts_as_captured(evader);
    captured_[evader] = captured;
    ever_captured_[evader] |= captured;
    const int change = static_cast<int>(counts_as_captured(evader)) - static_cast<int>(counted);
    n_captured_ += change;
    if (alive(evader_agent(evader))) n_at_large_ -= change;
}

void World::release(int evader) {
    captors_[evader] = 0;
    if (captured_[evader]) set_captured(evader, false);
}

void World::add_captor(int evader, int pursuer) {
    if (!captured_[evader]) set_captured(evader, true);
    ++captors_[evader];
    if (!capture_paid_[evader]) unpaid_.emplace_back(evader, pursuer);
}

// A turn in which one agent acted can change the capture of those it met, of those met in the
// turn before (a contact is over), and of those beside the cells it left and entered. The first
// turn of a round judges every evader.
void World::choose_judged(const Turn& turn, const Scratch& scratch) {
    judged_.clear();
    const bool captured_live_on =
        config().rules.capture == Capture::Surround || config().rules.evader == Outcome::Reach;
    if (!captured_live_on) return;  // no living evader is captured
    if (fresh_round_ || turn.last_actor - turn.first_actor > 1) {
        for (int a : living_) choose_evader(a);
        return;
    }
    for (int a : scratch.cast) choose_evader(a);
    for (int a : scratch.last_cast) choose_evader(a);
    if (config().rules.capture == Capture::Surround) {
        choose_near(scratch.here, scratch);
        choose_near(scratch.there, scratch);
    }
}

void World::choose_near(int cell, const Scratch& scratch) {
    if (ground_->kind[cell] == kBorder) return;
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        for (int a = scratch.occupancy.first(beside); a >= 0; a = scratch.occupancy.next(a)) {
            choose_evader(a);
        }
    }
}

void World::choose_evader(int agent) {
    if (team(agent) != Team::Evader || !alive(agent)) return;
    const int evader = evader_number(agent);
    if (is_judged_[evader]) return;
    is_judged_[evader] = 1;
    judged_.push_back(evader);
}

void World::judge_captures(const Turn& turn, Scratch& scratch) {
    unpaid_.clear();
    choose_judged(turn, scratch);
    for (int e : judged_) {
        is_judged_[e] = 0;
        release(e);
    }
    if (config().rules.capture == Capture::Occupation) {
        judge_contacts(turn, scratch);
    } else {
        for (int e : judged_) judge_surround(e, scratch);
    }
}

void World::judge_contacts(const Turn& turn, const Scratch& scratch) {
    for (const auto& [agent, pursuer] : scratch.resolver.captures()) {
        add_captor(evader_number(agent), pursuer);
    }
    if (config().rules.evader == Outcome::Reach && config().rules.contact_captures()) {
        for (int e : judged_) add_companions(e, turn, scratch);
    }
}

// Pursuers that share the evader's cell without having been in conflict with it in this turn.
void World::add_companions(int evader, const Turn& turn, const Scratch& scratch) {
    const int agent = evader_agent(evader);
    if (turn.acts(agent)) return;
    const Occupancy& occupancy = scratch.occupancy;
    for (int p = occupancy.first(cell_[agent]); p >= 0; p = occupancy.next(p)) {
        if (team(p) == Team::Pursuer && !turn.acts(p)) add_captor(evader, p);
    }
}

void World::judge_surround(int evader, const Scratch& scratch) {
    const Occupancy& occupancy = scratch.occupancy;
    const int cell = cell_[evader_agent(evader)];
    bool pursued = false;
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        const bool held = occupancy.count(beside, Team::Pursuer) > 0;
        if (!held && ground_->kind[beside] == kFree) return;
        pursued |= held;
    }
    if (!pursued) return;
    for (int move = 1; move < config().n_actions(); ++move) {
        const int beside = cell + grid().delta(move);
        for (int a = occupancy.first(beside); a >= 0; a = occupancy.next(a)) {
            if (team(a) == Team::Pursuer) add_captor(evader, a);
        }
    }
}

void World::remove_captured(Scratch& scratch) {
    const Rules& rules = config().rules;
    if (rules.capture != Capture::Surround || !rules.captured_disappear) return;
    for (int e : judged_) {
        if (captured_[e]) remove(evader_agent(e), scratch);
    }
}

// ---- Rewards and the end ------------------------------------------------------------------------

void World::pay_captures() {
    const auto& capture = config().rewards.capture;
    for (const auto& [evader, pursuer] : unpaid_) {
        rewards_[pursuer] += pay(capture, pursuer);
        if (capture_paid_[evader]) continue;
        capture_paid_[evader] = 1;
        rewards_[evader_agent(evader)] += pay(capture, evader_agent(evader));
    }
}

void World::pay_actors(const Turn& turn, const Scratch& scratch) {
    const Rewards& rewards = config().rewards;
    for (int a : scratch.cast) {
        if (!turn.acts(a)) continue;
        rewards_[a] += pay(rewards.step, a);
        if (alive(a) && has_neighbor(a, scratch)) rewards_[a] += pay(rewards.neighbor, a);
    }
}

bool World::has_neighbor(int agent, const Scratch& scratch) const {
    const Team adversary = team(agent) == Team::Pursuer ? Team::Evader : Team::Pursuer;
    for (int move = 1; move < kCompassMoves; ++move) {
        if (scratch.occupancy.count(cell_[agent] + grid().delta(move), adversary) > 0) return true;
    }
    return false;
}

void World::report_and_fine(const Scratch& scratch) {
    for (int a : scratch.cast) {
        const Flags news = scratch.resolver.flags(a) & kReportMask & ~report_[a];
        if (news == 0) continue;
        report_[a] |= news;
        const auto faults = std::bitset<kKinds>(news >> kKinds).count();
        rewards_[a] += static_cast<float>(faults) * pay(config().rewards.collide, a);
    }
}

void World::judge_end() {
    terminated_ = n_at_large_ == 0 || n_living_[0] == 0 || n_living_[1] == 0;
}

}  // namespace matrixworld
