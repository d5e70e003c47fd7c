// Counter-based random numbers: Philox4x64-10 (Salmon et al. 2011, "Parallel random numbers: as
// easy as 1, 2, 3"), the generator that NumPy offers as numpy.random.Philox. A number depends on
// its key and counter alone, so neither threads nor the order of work can change it, and nothing
// has to be saved to draw it again.
//
//   key      (seed, episode)
//   counter  (block, step, purpose, 0)
//
//     const EpisodeKey key{seed, episode};
//     const Block four = key.block(Purpose::Decide, index, step);  // four words by their place
//     Stream stream(key, Purpose::Reset);                          // or one word after the other
//     const int cell = below(stream.next(), n_cells);
#pragma once

#include <array>
#include <cstdint>

#include "grid/compiler.hpp"

namespace matrixworld {

constexpr int kDrawsPerBlock = 4;
using Block = std::array<std::uint64_t, kDrawsPerBlock>;

// What numbers are drawn for. Each purpose has its own counters, so that a change in how many
// numbers one of them takes leaves the others as they are.
enum class Purpose : std::uint64_t { Reset = 1, Decide = 2, Walk = 3, DecideTogether = 4 };

// Four random 64-bit words. The constants and the ten rounds are those of the paper.
inline Block philox(Block counter, std::uint64_t key0, std::uint64_t key1) {
    constexpr std::uint64_t kMultiplier0 = 0xD2E7470EE14C6C93ULL;
    constexpr std::uint64_t kMultiplier1 = 0xCA5A826395121157ULL;
    constexpr std::uint64_t kWeyl0 = 0x9E3779B97F4A7C15ULL;
    constexpr std::uint64_t kWeyl1 = 0xBB67AE8584CAA73BULL;
    for (int round = 0; round < 10; ++round) {
        const Bits128 product0 = product(kMultiplier0, counter[0]);
        const Bits128 product1 = product(kMultiplier1, counter[2]);
        counter = {upper(product1) ^ counter[1] ^ key0, lower(product1),
                   upper(product0) ^ counter[3] ^ key1, lower(product0)};
        key0 += kWeyl0;
        key1 += kWeyl1;
    }
    return counter;
}

// Names an episode and keys all its random numbers: episode `episode` of seed `seed`.
struct EpisodeKey {
    std::uint64_t seed = 0;
    std::uint64_t episode = 0;

    Block block(Purpose purpose, std::uint64_t index, std::uint64_t step) const {
        return philox({index, step, static_cast<std::uint64_t>(purpose), 0}, seed, episode);
    }
};

// An integer in [0, n) from 32 or 64 random bits: the upper half of the product bits * n (Lemire
// 2019, "Fast random integer generation in an interval"). Without Lemire's rejection step every
// call takes the same number of bits; the bias is below n / 2^32 or n / 2^64.
inline int below(std::uint32_t bits, int n) {
    return static_cast<int>((static_cast<std::uint64_t>(bits) * static_cast<unsigned>(n)) >> 32);
}
inline int below(std::uint64_t bits, int n) {
    return static_cast<int>(upper(product(bits, static_cast<unsigned>(n))));
}

// A float in [0, 1) from the upper 24 of 32 random bits, as many as a float holds exactly.
inline float unit(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

// Random words one after the other. A reset draws from it: how many cells it must try is not known
// beforehand.
class Stream {
  public:
    Stream(EpisodeKey key, Purpose purpose) : key_(key), purpose_(purpose) {}

    std::uint64_t next() {
        if (drawn_ % kDrawsPerBlock == 0) {
            block_ = key_.block(purpose_, drawn_ / kDrawsPerBlock, 0);
        }
        return block_[drawn_++ % kDrawsPerBlock];
    }

  private:
    EpisodeKey key_;
    Purpose purpose_;
    Block block_{};
    std::uint64_t drawn_ = 0;
};

}  // namespace matrixworld
