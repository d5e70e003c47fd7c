// Included before everything else in a build with sanitizers: what Eigen asserts is thrown, so that
// a wrong shape or index anywhere in the engine ends the run with a message.
#pragma once

#include <stdexcept>

#if defined(NDEBUG) || defined(EIGEN_NO_DEBUG)
#error "expected a build with assertions: neither NDEBUG nor EIGEN_NO_DEBUG"
#endif

#define MATRIXWORLD_QUOTE(text) #text
#define MATRIXWORLD_TEXT(macro) MATRIXWORLD_QUOTE(macro)

#define eigen_assert(condition)                                                              \
    do {                                                                                     \
        if (!(condition)) {                                                                  \
            throw std::logic_error(__FILE__ ":" MATRIXWORLD_TEXT(__LINE__) ": " #condition); \
        }                                                                                    \
    } while (false)
