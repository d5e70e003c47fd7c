// The C++ library of Debian's emscripten calls this, and that inside Pyodide is newer and lacks it.
#include <stdexcept>

[[noreturn]] void too_long(const void* vector) __asm__(
    "_ZNKSt3__220__vector_base_commonILb1EE20__throw_length_errorEv");

void too_long(const void*) { throw std::length_error("vector"); }
