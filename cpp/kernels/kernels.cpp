// One level of the kernels: this file is compiled several times, with MATRIXWORLD_LEVEL naming the
// function that returns them. It includes nothing with inline code that others include: such code,
// compiled here for a newer processor, could be linked into the rest of the program.
#include "kernels/kernels.hpp"

#include "kernels/networks.hpp"
#include "kernels/views.hpp"

namespace matrixworld {

#define MATRIXWORLD_STRING(name) #name
#define MATRIXWORLD_NAME(name) MATRIXWORLD_STRING(name)

const Kernels& MATRIXWORLD_LEVEL() {
    static constexpr Kernels level{MATRIXWORLD_NAME(MATRIXWORLD_LEVEL),
                                   draw<std::uint8_t>,
                                   draw<float>,
                                   sum_seen,
                                   sum_rows,
                                   dense,
                                   sample};
    return level;
}

}  // namespace matrixworld
