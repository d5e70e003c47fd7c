// Methods of objects that several of Python's threads use at once: one call at a time.
#pragma once

#include <pybind11/critical_section.h>
#include <pybind11/pybind11.h>

#include <utility>

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

}  // namespace matrixworld
