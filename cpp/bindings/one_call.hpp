// One call at a time: while a thread uses an object, calls by other threads are refused. Python's
// lock does not see to it, because steps and resets release it, and free-threaded Python has none.
#pragma once

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>

#include "play/threads.hpp"

namespace matrixworld {

// Whether a call of an object is in progress. A member of that object.
class InUse {
  public:
    // A call: from its construction to its end other calls throw std::runtime_error (in Python
    // RuntimeError). `name` is the object's type in messages.
    class Call {
      public:
        Call(InUse& in_use, const char* name) : depth_(in_use.depth_) {
            int found = kFree;
            if (!depth_.compare_exchange_strong(found, fork_depth())) refuse(name, found);
        }
        ~Call() { depth_ = kFree; }
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;

      private:
        std::atomic<int>& depth_;
    };

  private:
    static constexpr int kFree = -1;

    [[noreturn]] static void refuse(const std::string& name, int depth) {
        if (depth != fork_depth()) {
            // The thread that called does not exist here, so the call never ends.
            throw std::runtime_error(name +
                                     ": expected no call in progress when the process was forked, "
                                     "got one of another thread: make a new one in the child");
        }
        throw std::runtime_error(name +
                                 ": expected one call at a time, got a second one by another "
                                 "thread: give each thread its own, or hold a lock in each call");
    }

    std::atomic<int> depth_{kFree};  // `fork_depth` of the process in which a call is in progress
};

// A method as a function of its object and its arguments that is refused while another thread uses
// the object. The class has a member `in_use` and a constant `kName`.
template <typename Object, typename Result, typename... Args>
auto one_call(Result (Object::*method)(Args...)) {
    return [method](Object& object, Args... args) -> Result {
        const InUse::Call call(object.in_use, Object::kName);
        return (object.*method)(std::forward<Args>(args)...);
    };
}

template <typename Object, typename Result, typename... Args>
auto one_call(Result (Object::*method)(Args...) const) {
    return [method](Object& object, Args... args) -> Result {
        const InUse::Call call(object.in_use, Object::kName);
        return (object.*method)(std::forward<Args>(args)...);
    };
}

}  // namespace matrixworld
