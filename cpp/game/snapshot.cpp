#include "game/snapshot.hpp"

#include <stdexcept>
#include <string>
#include <type_traits>

#include "game/world.hpp"

namespace matrixworld {

namespace {

void refuse(const SnapshotField& field, const std::string& expected, std::int64_t given) {
    throw std::invalid_argument("snapshot, " + std::string(field.name) + ": expected " + expected +
                                ", got " + std::to_string(given));
}

void require_limits(const SnapshotField& field, int value) {
    const Limits limits = *field.limits;
    if (value >= limits.low && value <= limits.high) return;
    refuse(field, std::to_string(limits.low) + " to " + std::to_string(limits.high), value);
}

template <typename Value>
void check_field(const SnapshotField& field, const Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) {
        if (field.limits) require_limits(field, static_cast<int>(value));
    } else {
        const auto size = static_cast<std::int64_t>(value.size());
        if (field.size != kAnySize && size != field.size) {
            refuse(field, std::to_string(field.size) + " entries", size);
        }
        if (!field.limits) return;
        for (const auto entry : value) require_limits(field, static_cast<int>(entry));
    }
}

}  // namespace

// The members of a world that a snapshot holds unchanged, each beside its field.
template <typename AnyWorld, typename AnySnapshot, typename Copy>
void World::copy_members(AnyWorld& world, AnySnapshot& s, Copy copy) {
    copy(world.captured_, s.captured);
    copy(world.ever_captured_, s.ever_captured);
    copy(world.capture_paid_, s.capture_paid);
    copy(world.captors_, s.captors);
    copy(world.rewards_, s.rewards);
    copy(world.steps_, s.steps);
    copy(world.first_turn_, s.first_turn);
    copy(world.terminated_, s.terminated);
    copy(world.truncated_, s.truncated);
}

Snapshot World::snapshot(const Scratch& scratch) const {
    Snapshot s;
    copy_members(*this, s, [](const auto& own, auto& saved) { saved = own; });
    s.key = key_;
    s.map.resize(config().rows * config().cols);
    terrain_->write_map(s.map.data());
    // Cells are written without the border's ring, so that a reader needs rows and cols alone.
    const auto index = [&](int cell) {
        return cell == kGone ? kGone : grid().row(cell) * config().cols + grid().col(cell);
    };
    s.cells = cell_.unaryExpr(index);
    s.last_cells = last_cell_.unaryExpr(index);
    s.report = report_.cast<int>();
    s.participants = scratch.participants;
    s.memory_steps = IntArray::Constant(config().n_agents(), -1);
    s.memory_sizes = IntArray::Zero(config().n_agents());
    memories_.write(s.memory_steps, s.memory_sizes, s.memories);
    return s;
}

void World::check(const Snapshot& s) const {
    for_each_field(s, config(), [](const SnapshotField& field, const auto& value) {
        check_field(field, value);
    });
    const std::int64_t n = 2 * s.memory_sizes.cast<std::int64_t>().sum();
    const auto size = static_cast<std::int64_t>(s.memories.size());
    if (size != n) refuse({"memories", n}, std::to_string(n) + " entries", size);
}

void World::restore(const Snapshot& s, Scratch& scratch) {
    check(s);
    begin_episode(s.key);
    set_terrain(s.map);
    copy_members(*this, s, [](auto& own, const auto& saved) { own = saved; });
    report_ = s.report.cast<Flags>();
    for (int a = 0; a < config().n_agents(); ++a) {
        if (report_[a] != 0) reported_.push_back(a);
    }
    const auto cell = [&](int index) {
        return index == kGone ? kGone : grid().cell(index / config().cols, index % config().cols);
    };
    last_cell_ = s.last_cells.unaryExpr(cell);
    place_living(s.cells.unaryExpr(cell), scratch);
    may_overlap_ = true;
    count_captures();
    scratch.participants = s.participants;
    memories_.read(s.memory_steps, s.memory_sizes, s.memories);
}

void World::put(const IntArray& cells, const ByteArray& captured, EpisodeKey key, int steps,
                Scratch& scratch) {
    key_ = key;
    steps_ = steps;
    captured_ = captured;
    ever_captured_ = captured;
    terminated_ = truncated_ = false;
    first_turn_ = true;  // so that its captures are judged anew, for all evaders
    may_overlap_ = true;
    place_living(cells, scratch);
    count_captures();
}

void World::place_living(const IntArray& cells, Scratch& scratch) {
    living_.clear();
    n_living_[0] = n_living_[1] = 0;
    cell_.setConstant(kGone);
    for (int a = 0; a < config().n_agents(); ++a) {
        if (cells[a] == kGone) continue;
        living_.push_back(a);
        ++n_living_[static_cast<int>(team(a))];
        place(a, cells[a], scratch);
    }
    scratch.occupancy.occupy(living_, cell_);
}

void World::count_captures() {
    n_captured_ = n_uncaptured_ = 0;
    for (int e = 0; e < config().n_evaders; ++e) {
        n_captured_ += counts_as_captured(e);
        n_uncaptured_ += alive(evader_agent(e)) && !counts_as_captured(e);
    }
}

}  // namespace matrixworld
