// Signals, such as Ctrl-C, during calls that take long.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "play/threads.hpp"

namespace matrixworld {

// Runs Python's handlers of signals that have come; throws what they raise, which is
// KeyboardInterrupt after Ctrl-C. The caller holds the GIL.
inline void handle_signals() {
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

// The same for work that has released the GIL; empty on a thread that is not Python's main one.
// Only the main thread handles signals, and another one that asks for the GIL while Python shuts
// down would be ended in the middle of the work.
inline Workers::Poll signal_poll() {
    const auto threading = pybind11::module_::import("threading");
    if (!threading.attr("current_thread")().is(threading.attr("main_thread")())) return {};
    return [] {
        const pybind11::gil_scoped_acquire gil;
        handle_signals();
    };
}

// The same for work that knows its share done, which it tells `report` unless that is None. Only the
// main thread does.
inline std::function<void(double)> signal_poll(const pybind11::object& report) {
    const Workers::Poll poll = signal_poll();
    if (!poll) return {};
    return [poll, report](double share) {
        poll();
        const pybind11::gil_scoped_acquire gil;
        if (!report.is_none()) report(share);
    };
}

}  // namespace matrixworld
