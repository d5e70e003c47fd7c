#include "bindings/numpy_buffers.hpp"

#include "observe/observe.hpp"

namespace matrixworld {

namespace {

class Holder {
  public:
    Holder(Shape lead, const py::dict& arrays) : lead_(std::move(lead)), arrays_(arrays) {}

    // Takes the array of this name, if there is one, with entries of this type.
    template <typename Entry, typename T>
    void take(const char* name, T*& pointer, const Shape& shape) {
        static_assert(sizeof(Entry) == sizeof(T));
        names_ += (names_.empty() ? "" : ", ") + std::string(name);
        if (!arrays_.contains(name)) return;
        ++known_;
        const py::array array = array_of(name);
        require_dtype<Entry>(name, array);
        Shape expected = lead_;
        expected.insert(expected.end(), shape.begin(), shape.end());
        require_shape(name, array, expected);
        if (!(array.flags() & py::array::c_style) || !array.writeable()) {
            throw py::value_error(std::string(name) + ": expected a writeable C-contiguous array");
        }
        pointer = static_cast<T*>(const_cast<void*>(array.data()));
    }

    // The same for views, as bytes or as floats.
    void take_views(const char* name, std::uint8_t*& bytes, float*& floats, const Shape& shape) {
        const bool has_floats = arrays_.contains(name) &&
                                py::isinstance<py::array>(arrays_[name]) &&
                                array_of(name).dtype().is(py::dtype::of<float>());
        if (has_floats) {
            take<float>(name, floats, shape);
        } else {
            take<std::uint8_t>(name, bytes, shape);
        }
    }

    void require_known() const {
        if (known_ == arrays_.size()) return;
        throw py::value_error("buffers: expected some of " + names_ + ", got " +
                              py::str(py::list(arrays_)).cast<std::string>());
    }

  private:
    py::array array_of(const char* name) const {
        const py::object object = arrays_[name];
        if (!py::isinstance<py::array>(object)) {
            throw py::type_error(std::string(name) + ": expected a NumPy array, got " +
                                 py::type::of(object).attr("__name__").cast<std::string>());
        }
        return py::reinterpret_borrow<py::array>(object);
    }

    Shape lead_;
    const py::dict& arrays_;
    std::size_t known_ = 0;
    std::string names_;
};

Shape view_shape(const Config& config) {
    return {config.n_agents(), kChannels, config.fov, config.fov};
}

void take_world(Holder& holder, const Config& config, Buffers& b) {
    const py::ssize_t agents = config.n_agents();
    const py::ssize_t evaders = config.n_evaders;
    holder.take<std::int32_t>("positions", b.positions, {agents, 2});
    holder.take<std::int32_t>("last_positions", b.last_positions, {agents, 2});
    holder.take<bool>("alive", b.alive, {agents});
    holder.take<std::int32_t>("steps", b.steps, {});
    holder.take<std::uint64_t>("seed", b.seed, {});
    holder.take<std::uint64_t>("episode", b.episode, {});
    holder.take_views("views", b.views, b.float_views, view_shape(config));
    holder.take<std::uint8_t>("state", b.state, {kChannels, config.rows, config.cols});
    holder.take<bool>("captured", b.captured, {evaders});
    holder.take<bool>("ever_captured", b.ever_captured, {evaders});
    holder.take<std::int32_t>("captors", b.captors, {evaders});
    holder.take<bool>("involved", b.involved, {agents, kKinds});
    holder.take<bool>("fault", b.fault, {agents, kKinds});
    holder.take<float>("cost", b.cost, {agents});
    holder.take<float>("rewards", b.rewards, {agents});
    holder.take<bool>("terminations", b.terminations, {agents});
    holder.take<bool>("truncations", b.truncations, {agents});
    holder.take<bool>("terminated", b.terminated, {});
    holder.take<bool>("truncated", b.truncated, {});
    holder.take<float>("capture_rate", b.capture_rate, {});
    holder.take<float>("ever_capture_rate", b.ever_capture_rate, {});
    holder.take<float>("survival_rate", b.survival_rate, {kTeams});
}

void take_episodes(Holder& holder, const Config& config, Buffers& b) {
    holder.take<bool>("acted", b.acted, {config.n_agents()});
    holder.take<bool>("ended", b.ended, {});
    holder.take_views("final_views", b.final_views, b.final_float_views, view_shape(config));
    holder.take<double>("episode_return", b.episode_return, {kTeams});
    holder.take<std::int32_t>("episode_length", b.episode_length, {});
    holder.take<float>("episode_capture_rate", b.episode_capture_rate, {});
    holder.take<float>("episode_ever_capture_rate", b.episode_ever_capture_rate, {});
    holder.take<std::int32_t>("episode_survivors", b.episode_survivors, {kTeams});
    holder.take<std::int32_t>("episode_collisions", b.episode_collisions, {kTeams, kKinds});
    holder.take<std::int32_t>("episode_faults", b.episode_faults, {kTeams, kKinds});
    holder.take<std::int64_t>("episode_agent_steps", b.episode_agent_steps, {kTeams});
}

}  // namespace

HeldBuffers hold_world(const Config& config, const py::dict& arrays) {
    HeldBuffers held{{}, arrays};
    Holder holder({}, arrays);
    take_world(holder, config, held.pointers);
    holder.require_known();
    return held;
}

HeldBuffers hold_batch(const Config& config, int n_worlds, const py::dict& arrays) {
    HeldBuffers held{{}, arrays.attr("copy")()};  // the caller may change its dict later
    Holder holder({n_worlds}, held.arrays);
    take_world(holder, config, held.pointers);
    take_episodes(holder, config, held.pointers);
    holder.require_known();
    return held;
}

}  // namespace matrixworld
