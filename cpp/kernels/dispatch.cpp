// Selects the level of the kernels once, when they are first used.
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "grid/compiler.hpp"
#include "kernels/kernels.hpp"

namespace matrixworld {

// One function for each time that kernels.cpp is compiled; CMakeLists.txt names them.
const Kernels& kernels_base();
#ifdef MATRIXWORLD_X86_LEVELS
const Kernels& kernels_v3();
const Kernels& kernels_v4();
#endif

namespace {

struct Level {
    const char* name;
    bool runs;
    const Kernels& (*kernels)();
};

// Best first.
std::vector<Level> levels() {
    std::vector<Level> all;
#ifdef MATRIXWORLD_X86_LEVELS
    all.push_back({"x86-64-v4", runs_x86_64_v4(), kernels_v4});
    all.push_back({"x86-64-v3", runs_x86_64_v3(), kernels_v3});
#endif
    all.push_back({"base", true, kernels_base});
    return all;
}

const Kernels& select() {
    const char* wanted = std::getenv("MATRIXWORLD_KERNELS");
    for (const Level& level : levels()) {
        if (level.runs && (!wanted || level.name == std::string(wanted))) return level.kernels();
    }
    throw std::invalid_argument(
        "MATRIXWORLD_KERNELS: expected base, x86-64-v3 or x86-64-v4 as far as this processor runs "
        "it, got " +
        std::string(wanted));
}

}  // namespace

const Kernels& kernels() {
    // Selected once, at the first call; the language makes that safe among threads.
    static const Kernels& selected = select();
    return selected;
}

}  // namespace matrixworld
