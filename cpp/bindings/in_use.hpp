// Whether a call of a batch is in progress. Its methods release the GIL, and with it the lock of the
// Python object, so they refuse a second caller.
//
//     InUse in_use;                        // beside the batch
//     const InUse::Call call(in_use);      // in each of its methods
#pragma once

#include <atomic>
#include <stdexcept>

#include "play/threads.hpp"

namespace matrixworld {

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
