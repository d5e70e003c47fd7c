// The kernels of one instruction set. This file is compiled several times, each time with other
// compiler options and with MATRIXWORLD_LEVEL naming the function that returns the kernels.
//
// It includes no header with inline functions that other files include, too. The linker keeps one
// copy of an inline function; it could be the one compiled here for a newer processor, and the
// program would crash on an older one. For the same reason the headers below, which only this
// file includes, define everything in an unnamed namespace.
#include "kernels/kernels.hpp"

#include "kernels/actions.hpp"
#include "kernels/memory.hpp"
#include "kernels/moves.hpp"
#include "kernels/views.hpp"

namespace matrixworld {

#define MATRIXWORLD_STRING(name) #name
#define MATRIXWORLD_NAME(name) MATRIXWORLD_STRING(name)

const Kernels& MATRIXWORLD_LEVEL() {
    static constexpr Kernels level{MATRIXWORLD_NAME(MATRIXWORLD_LEVEL),
                                   write<std::uint8_t>,
                                   write<float>,
                                   look_at_moves,
                                   rate_moves,
                                   sum_seen,
                                   sum_rows,
                                   sum_bits,
                                   dense,
                                   remember,
                                   choose,
                                   finish};
    return level;
}

}  // namespace matrixworld
