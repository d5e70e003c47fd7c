// What the engine uses beyond standard C++: vectors, integers of 128 bits, the bits of a word. GCC and
// Clang have extensions for these, and only this file knows them. With other compilers, as Visual
// C++, and with MATRIXWORLD_PLAIN, it takes a plain way that gives the same bits.
//
//     using Vec = Lanes<float, 4>;
//     const Vec least = where(a < b, a, b);    // a comparison is -1 in lanes where it holds, or 0
//
// Plain code only in an unnamed namespace: kernels.cpp includes this file and is compiled for several
// instruction sets, so no function here may be the same for two files.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#if !defined(__GNUC__) && !defined(MATRIXWORLD_PLAIN)
#define MATRIXWORLD_PLAIN
#endif
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "expected a little-endian processor: bits of maps and of doubles are read in this order"
#endif

namespace matrixworld {

namespace {

// ---- Vectors ------------------------------------------------------------------------------------

#if !defined(MATRIXWORLD_PLAIN)
template <typename T, int n>
struct Vector {
    typedef T type __attribute__((vector_size(n * sizeof(T))));
};
template <typename T, int n>
using Lanes = typename Vector<T, n>::type;

template <typename V>
using Mask = decltype(V{} < V{});

template <typename V>
inline V splat(float value) {
    return value - V{};
}
template <typename V>
inline V where(Mask<V> mask, V a, V b) {
    return mask ? a : b;
}
template <typename V, typename From>
inline V converted(From x) {
    return __builtin_convertvector(x, V);
}
inline float fused(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
#else
template <typename T, int n>
struct Lanes {
    T& operator[](int i) { return lanes[i]; }
    const T& operator[](int i) const { return lanes[i]; }

    T lanes[n];
};

template <typename R, typename T, int n, typename Operation>
inline Lanes<R, n> each(const Lanes<T, n>& a, const Lanes<T, n>& b, Operation operation) {
    Lanes<R, n> result{};
    for (int i = 0; i < n; ++i) result[i] = static_cast<R>(operation(a[i], b[i]));
    return result;
}
template <typename V, typename T>
inline V splat(T value) {
    V result{};
    for (unsigned i = 0; i < sizeof(V) / sizeof(T); ++i) result[i] = value;
    return result;
}
template <typename T>
using Same = std::common_type_t<T>;  // of what converts to the type of lanes
template <typename T>
using Truth = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;

#define MATRIXWORLD_ARITHMETIC(op)                                               \
    template <typename T, int n>                                                 \
    inline Lanes<T, n> operator op(const Lanes<T, n>& a, const Lanes<T, n>& b) { \
        return each<T>(a, b, [](T x, T y) { return x op y; });                   \
    }                                                                            \
    template <typename T, int n>                                                 \
    inline Lanes<T, n> operator op(const Lanes<T, n>& a, Same<T> b) {            \
        return a op splat<Lanes<T, n>, T>(b);                                    \
    }                                                                            \
    template <typename T, int n, typename Other>                                 \
    inline Lanes<T, n>& operator op## = (Lanes<T, n> & a, const Other& b) {      \
        return a = a op b;                                                       \
    }
#define MATRIXWORLD_COMPARISON(op)                                                      \
    template <typename T, int n>                                                        \
    inline Lanes<Truth<T>, n> operator op(const Lanes<T, n>& a, const Lanes<T, n>& b) { \
        return each<Truth<T>>(a, b, [](T x, T y) { return x op y ? -1 : 0; });          \
    }
MATRIXWORLD_ARITHMETIC(+)
MATRIXWORLD_ARITHMETIC(-)
MATRIXWORLD_ARITHMETIC(*)
MATRIXWORLD_ARITHMETIC(/)
MATRIXWORLD_ARITHMETIC(&)
MATRIXWORLD_ARITHMETIC(|)
MATRIXWORLD_ARITHMETIC(^)
MATRIXWORLD_ARITHMETIC(<<)
MATRIXWORLD_COMPARISON(<)
MATRIXWORLD_COMPARISON(<=)
MATRIXWORLD_COMPARISON(>)
#undef MATRIXWORLD_ARITHMETIC
#undef MATRIXWORLD_COMPARISON

template <typename V>
using Mask = decltype(V{} < V{});

template <typename V>
inline V where(Mask<V> mask, V a, V b) {
    for (unsigned i = 0; i < sizeof(V) / sizeof(a[0]); ++i) a[i] = mask[i] ? a[i] : b[i];
    return a;
}
template <typename V, typename From>
inline V converted(const From& x) {
    V result{};
    for (unsigned i = 0; i < sizeof(V) / sizeof(result[0]); ++i) {
        result[i] = static_cast<std::decay_t<decltype(result[0])>>(x[i]);
    }
    return result;
}
#endif

// The same bits as another type. A memcpy of this size is no call.
template <typename V, typename From>
inline V as(From x) {
    static_assert(sizeof(V) == sizeof(From), "the same size");
    V result;
    std::memcpy(&result, &x, sizeof(V));
    return result;
}

// ---- Words of 128 bits --------------------------------------------------------------------------

#if defined(__SIZEOF_INT128__) && !defined(MATRIXWORLD_PLAIN)
__extension__ typedef unsigned __int128 Bits128;

inline Bits128 product(std::uint64_t a, std::uint64_t b) { return Bits128{a} * b; }
#else
// What is used of an unsigned integer of 128 bits. Precondition of shifts: 0 to 127.
struct Bits128 {
    constexpr Bits128(std::uint64_t low = 0) : low(low) {}
    constexpr Bits128(std::uint64_t high, std::uint64_t low) : low(low), high(high) {}
    constexpr explicit operator std::uint64_t() const { return low; }
    constexpr explicit operator bool() const { return low || high; }

    constexpr Bits128 operator&(Bits128 b) const { return {high & b.high, low & b.low}; }
    constexpr Bits128 operator|(Bits128 b) const { return {high | b.high, low | b.low}; }
    constexpr bool operator==(Bits128 b) const { return high == b.high && low == b.low; }
    constexpr Bits128 operator~() const { return {~high, ~low}; }
    constexpr Bits128 operator-(Bits128 b) const {
        return {high - b.high - (low < b.low), low - b.low};
    }
    constexpr Bits128 operator<<(int n) const {
        if (n == 0) return *this;
        return n < 64 ? Bits128{high << n | low >> (64 - n), low << n}
                      : Bits128{low << (n - 64), 0};
    }
    constexpr Bits128 operator>>(int n) const {
        if (n == 0) return *this;
        return n < 64 ? Bits128{high >> n, low >> n | high << (64 - n)}
                      : Bits128{0, high >> (n - 64)};
    }
    constexpr Bits128& operator&=(Bits128 b) { return *this = *this & b; }
    constexpr Bits128& operator|=(Bits128 b) { return *this = *this | b; }
    constexpr Bits128& operator>>=(int n) { return *this = *this >> n; }

    std::uint64_t low;
    std::uint64_t high = 0;
};

// By the products of halves, none of which overflows.
inline Bits128 product(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t half = 0xFFFFFFFF;
    const std::uint64_t low = (a & half) * (b & half);
    const std::uint64_t first = (a >> 32) * (b & half) + (low >> 32);
    const std::uint64_t second = (a & half) * (b >> 32) + (first & half);
    return {(a >> 32) * (b >> 32) + (first >> 32) + (second >> 32), second << 32 | (low & half)};
}
#endif

inline std::uint64_t upper(Bits128 x) { return static_cast<std::uint64_t>(x >> 64); }
inline std::uint64_t lower(Bits128 x) { return static_cast<std::uint64_t>(x); }

// ---- Bits of a word -----------------------------------------------------------------------------

#if !defined(MATRIXWORLD_PLAIN)
inline int count_bits(std::uint64_t x) { return __builtin_popcountll(x); }
inline int lowest_bit(std::uint64_t x) { return __builtin_ctzll(x); }
// The same value, of which the compiler knows nothing, so that it makes no branch of it.
template <typename T>
inline T opaque(T value) {
    __asm__("" : "+r"(value));
    return value;
}
inline void prefetch(const void* at) { __builtin_prefetch(at); }
#else
// Sums of 2, 4 and 8 neighbours; the product adds all bytes in the highest.
inline int count_bits(std::uint64_t x) {
    x -= x >> 1 & 0x5555555555555555;
    x = (x & 0x3333333333333333) + (x >> 2 & 0x3333333333333333);
    x = (x + (x >> 4)) & 0x0F0F0F0F0F0F0F0F;
    return static_cast<int>(x * 0x0101010101010101 >> 56);
}
inline int lowest_bit(std::uint64_t x) { return count_bits(~x & (x - 1)); }
template <typename T>
inline T opaque(T value) {
    return value;
}
inline void prefetch(const void*) {}
#endif

// ---- Processors ---------------------------------------------------------------------------------

// Each level needs every feature that the compiler may use for it.
#if defined(__x86_64__) && !defined(MATRIXWORLD_PLAIN)
inline bool runs_x86_64_v3() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
inline bool runs_x86_64_v4() {
    return runs_x86_64_v3() && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd");
}
#else
inline bool runs_x86_64_v3() { return false; }
inline bool runs_x86_64_v4() { return false; }
#endif

}  // namespace

}  // namespace matrixworld
