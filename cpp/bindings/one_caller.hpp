// Objects that several of Python's threads use at once: each lets one caller in at a time.
#pragma once

#include <pybind11/critical_section.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <stdexcept>
#include <utility>

#include "play/threads.hpp"

namespace matrixworld {

// A method of which several calls of one object follow each other. The GIL sees to it where there
// is one; otherwise the lock of the Python object does, which costs nothing beside a GIL.
template <typename Object, typename Result, typename... Args>
auto locked(Result (Object::*method)(Args...)) {
    return [method](const pybind11::handle& self, Args... args) -> Result {
        const pybind11::scoped_critical_section lock(self);
        return (self.cast<Object&>().*method)(std::forward<Args>(args)...);
    };
}

template <typename Object, typename Result, typename... Args>
auto locked(Result (Object::*method)(Args...) const) {
    return [method](const pybind11::handle& self, Args... args) -> Result {
        const pybind11::scoped_critical_section lock(self);
        return (self.cast<const Object&>().*method)(std::forward<Args>(args)...);
    };
}

// Whether a call of a batch is in progress. Its methods release the GIL, and with it such a lock,
// so they refuse a second caller.
class InUse {
  public:
    // A call, from its construction to its end. Throws std::runtime_error (in Python RuntimeError)
    // if there is one already.
    class Call {
      public:
        explicit Call(InUse& in_use) : caller_(in_use.caller_) {
            int found = kNone;
            if (!caller_.compare_exchange_strong(found, fork_depth())) refuse(found);
        }
        ~Call() { caller_ = kNone; }
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;

      private:
        std::atomic<int>& caller_;
    };

  private:
    static constexpr int kNone = -1;

    [[noreturn]] static void refuse(int caller) {
        if (caller == fork_depth()) {
            throw std::runtime_error(
                "Batch or VectorEnv: expected one call at a time, got a second one by another "
                "thread: give each thread its own, or hold a lock in each call");
        }
        // The calling thread does not exist in this process, so its call never ends.
        throw std::runtime_error(
            "Batch or VectorEnv: expected no call in progress when the process was forked, got one "
            "by another thread: make a new one in the child");
    }

    std::atomic<int> caller_{kNone};  // `fork_depth` of the process in which a call is in progress
};

}  // namespace matrixworld
