// How worlds are set up, and how an episode begins. A reset depends on its key and placement alone,
// never on what the world or the thread played before.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "game/world.hpp"

namespace matrixworld {

namespace {

// Samples cells without replacement: a Fisher-Yates shuffle of `order` that stops when no more
// cells are needed. The destructor undoes the swaps, so that the next reset begins with the same
// order, and a reset costs O(cells drawn), not O(cells of the grid).
class CellSampler {
  public:
    CellSampler(Scratch& scratch, Stream& stream)
        : order_(scratch.order), swaps_(scratch.swaps), stream_(stream) {}
    ~CellSampler() {
        for (int i = static_cast<int>(swaps_.size()) - 1; i >= 0; --i) {
            std::swap(order_[i], order_[swaps_[i]]);
        }
        swaps_.clear();
    }
    CellSampler(const CellSampler&) = delete;
    CellSampler& operator=(const CellSampler&) = delete;

    int next() {
        const int n_drawn = static_cast<int>(swaps_.size());
        const int pick = n_drawn + below(stream_.next(), static_cast<int>(order_.size()) - n_drawn);
        swaps_.push_back(pick);
        std::swap(order_[n_drawn], order_[pick]);
        return order_[n_drawn];
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

void require_room(const Config& config, const ByteArray& map) {
    const int area = config.rows * config.cols;
    if (map.size() != 0 && map.size() != area) {
        throw std::invalid_argument("obstacle map: expected " + std::to_string(area) +
                                    " cells, got " + std::to_string(map.size()));
    }
    const int blocked =
        map.size() ? static_cast<int>((map != 0).count()) : config.n_random_obstacles();
    if (config.n_agents() > area - blocked) {
        throw std::invalid_argument("obstacle map: expected at least " +
                                    std::to_string(config.n_agents()) + " free cells, got " +
                                    std::to_string(area - blocked));
    }
}

std::string text(int row, int col) {
    return "(" + std::to_string(row) + ", " + std::to_string(col) + ")";
}

// The index into the map of a given position. Throws where that is not a free cell.
int free_index(const Config& config, const ByteArray& map, int row, int col) {
    if (row < 0 || row >= config.rows || col < 0 || col >= config.cols) {
        throw std::invalid_argument("position " + text(row, col) + ": expected a cell of the " +
                                    std::to_string(config.rows) + " x " +
                                    std::to_string(config.cols) + " grid");
    }
    const int index = row * config.cols + col;
    if (map.size() && map[index]) {
        throw std::invalid_argument("position " + text(row, col) +
                                    ": expected a free cell, got an obstacle");
    }
    return index;
}

}  // namespace

// ---- What worlds share ------------------------------------------------------------------------

namespace {

// Before a grid is made of it: the sizes of a grid are computed with ints.
Config checked(Config config) {
    config.validate();
    return config;
}

}  // namespace

Setup::Setup(Config given) : config(checked(std::move(given))), grid(config.rows, config.cols) {
    terrain = std::make_shared<const Terrain>(grid, config.fov / 2, config.map);
    // A table of the eight sums replaces three branches for every agent that collides.
    for (int team = 0; team < kTeams; ++team) {
        for (int kinds = 0; kinds < 1 << kKinds; ++kinds) {
            penalties[team][kinds] = 0;
            for (int kind = 0; kind < kKinds; ++kind) {
                if (kinds >> kind & 1) penalties[team][kinds] += config.rewards.collide[team][kind];
            }
        }
    }
}

Scratch::Scratch(const Setup& setup, bool for_networks)
    : occupancy(setup.grid, setup.config.n_pursuers, setup.config.n_agents(), setup.config.fov,
                for_networks, setup.config.rules.interaction == Interaction::AgentTurns),
      resolver(setup.grid, setup.config.rules, setup.config.n_pursuers, setup.config.n_agents()),
      order(setup.config.rows * setup.config.cols) {
    for (int i = 0; i < order.size(); ++i) {
        order[i] = setup.grid.cell(i / setup.config.cols, i % setup.config.cols);
    }
    participants.reserve(setup.config.n_agents());
    last_participants.reserve(setup.config.n_agents());
}

// ---- Reset --------------------------------------------------------------------------------------

World::World(std::shared_ptr<const Setup> setup)
    : setup_(std::move(setup)),
      terrain_(setup_->terrain),
      cell_(IntArray::Constant(config().n_agents(), kGone)),
      last_cell_(IntArray::Constant(config().n_agents(), kGone)),
      captured_(ByteArray::Zero(config().n_evaders)),
      ever_captured_(ByteArray::Zero(config().n_evaders)),
      capture_paid_(ByteArray::Zero(config().n_evaders)),
      captors_(IntArray::Zero(config().n_evaders)),
      is_affected_(ByteArray::Zero(config().n_evaders)),
      rewards_(FloatArray::Zero(config().n_agents())),
      report_(decltype(report_)::Zero(config().n_agents())) {
    living_.reserve(config().n_agents());
    affected_.reserve(config().n_evaders);
    reported_.reserve(config().n_agents());
}

void World::check(const Placement& placement) const {
    require_count("pursuer", placement.pursuers.size(), config().n_pursuers);
    require_count("evader", placement.evaders.size(), config().n_evaders);
    const ByteArray& map = placement.map.size() ? placement.map : config().map;
    require_room(config(), map);
    // Two agents on one cell are found by sorting, in O(agents log agents).
    std::vector<int> indices;
    for (const auto* positions : {&placement.pursuers, &placement.evaders}) {
        for (std::size_t i = 0; i < positions->size(); i += 2) {
            indices.push_back(free_index(config(), map, (*positions)[i], (*positions)[i + 1]));
        }
    }
    std::sort(indices.begin(), indices.end());
    const auto twice = std::adjacent_find(indices.begin(), indices.end());
    if (twice == indices.end()) return;
    throw std::invalid_argument("positions: expected distinct cells, got two agents on " +
                                text(*twice / config().cols, *twice % config().cols));
}

void World::reset(EpisodeKey key, Scratch& scratch, const Placement& placement) {
    check(placement);
    begin_episode(key);
    set_terrain(placement.map);
    place_given(placement.pursuers, 0, scratch);
    place_given(placement.evaders, config().n_pursuers, scratch);
    place_at_random(placement, scratch);
    scratch.occupancy.occupy(living_, cell_);
}

void World::place_given(const std::vector<int>& positions, int first, Scratch& scratch) {
    for (std::size_t i = 0; i < positions.size(); i += 2) {
        const int agent = first + static_cast<int>(i / 2);
        place(agent, grid().cell(positions[i], positions[i + 1]), scratch);
    }
}

// Draws what a placement leaves open. The order (obstacles, evaders, pursuers) fixes which random
// number places what.
void World::place_at_random(const Placement& given, Scratch& scratch) {
    Stream stream(key_, Purpose::Reset);
    CellSampler cell_sampler(scratch, stream);
    const auto free_cell = [&] {
        int cell = cell_sampler.next();
        while (terrain_->kind[cell] != kFree || !scratch.occupancy.empty(cell)) {
            cell = cell_sampler.next();
        }
        return cell;
    };
    const bool has_map = given.map.size() != 0 || config().map.size() != 0;
    const int n_obstacles = has_map ? 0 : config().n_random_obstacles();
    if (n_obstacles > 0) {
        // The shared terrain stays as it is; this episode has a copy of its own.
        auto terrain = std::make_shared<Terrain>(*setup_->terrain);
        for (int i = 0; i < n_obstacles; ++i) terrain->set_obstacle(free_cell());
        terrain_ = std::move(terrain);
    }
    const int first_evader = config().n_pursuers;
    for (int a = first_evader; given.evaders.empty() && a < config().n_agents(); ++a) {
        place(a, free_cell(), scratch);
    }
    for (int a = 0; given.pursuers.empty() && a < first_evader; ++a) {
        place(a, free_cell(), scratch);
    }
}

void World::begin_episode(EpisodeKey key) {
    key_ = key;
    living_.resize(config().n_agents());
    for (int a = 0; a < config().n_agents(); ++a) living_[a] = a;
    n_living_[static_cast<int>(Team::Pursuer)] = config().n_pursuers;
    n_living_[static_cast<int>(Team::Evader)] = config().n_evaders;
    n_captured_ = 0;
    n_uncaptured_ = config().n_evaders;
    captured_.setZero();
    ever_captured_.setZero();
    capture_paid_.setZero();
    captors_.setZero();
    rewards_.setZero();
    report_.setZero();
    reported_.clear();
    steps_ = 0;
    terminated_ = false;
    truncated_ = false;
    memories_.clear();
    may_overlap_ = false;  // agents are placed on distinct cells
}

void World::set_terrain(const ByteArray& map) {
    terrain_ = setup_->terrain;
    if (map.size() == 0) return;
    terrain_ = std::make_shared<const Terrain>(grid(), config().fov / 2, map);
}

void World::place(int agent, int cell, Scratch& scratch) {
    cell_[agent] = cell;
    scratch.occupancy.add(agent, cell);
}

}  // namespace matrixworld
