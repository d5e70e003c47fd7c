// Counter-based random numbers: Philox4x64-10 (Salmon et al. 2011, "Parallel random numbers: as
// easy as 1, 2, 3"), the generator that NumPy offers as numpy.random.Philox. A number depends on
// its key and counter alone, so neither threads nor the order of work can change it.
//
//   key      (seed, episode)
//   counter  (block, step, purpose, 0)
#pragma once

#include <array>
#include <cstdint>

namespace matrixworld {

constexpr int kDrawsPerBlock = 4;
using Block = std::array<std::uint64_t, kDrawsPerBlock>;

enum class Purpose : std::uint64_t { Reset = 1, Decide = 2, Walk = 3 };

inline Block philox(Block counter, std::uint64_t key0, std::uint64_t key1) {
    constexpr std::uint64_t kMultiplier0 = 0xD2E7470EE14C6C93ULL;
    constexpr std::uint64_t kMultiplier1 = 0xCA5A826395121157ULL;
    constexpr std::uint64_t kWeyl0 = 0x9E3779B97F4A7C15ULL;
    constexpr std::uint64_t kWeyl1 = 0xBB67AE8584CAA73BULL;
    for (int round = 0; round < 10; ++round) {
        const unsigned __int128 product0 =
            static_cast<unsigned __int128>(kMultiplier0) * counter[0];
        const unsigned __int128 product1 =
            static_cast<unsigned __int128>(kMultiplier1) * counter[2];
        counter = {static_cast<std::uint64_t>(product1 >> 64) ^ counter[1] ^ key0,
                   static_cast<std::uint64_t>(product1),
                   static_cast<std::uint64_t>(product0 >> 64) ^ counter[3] ^ key1,
                   static_cast<std::uint64_t>(product0)};
        key0 += kWeyl0;
        key1 += kWeyl1;
    }
    return counter;
}

// Which episode is played: episode `episode` of seed `seed`.
struct EpisodeKey {
    std::uint64_t seed = 0;
    std::uint64_t episode = 0;

    Block block(Purpose purpose, std::uint64_t index, std::uint64_t step) const {
        return philox({index, step, static_cast<std::uint64_t>(purpose), 0}, seed, episode);
    }
};

// An integer in [0, n) from 32 or 64 random bits; its bias is below n / 2^32 or n / 2^64.
inline int below(std::uint32_t bits, int n) {
    return static_cast<int>((static_cast<std::uint64_t>(bits) * static_cast<unsigned>(n)) >> 32);
}
inline int below(std::uint64_t bits, int n) {
    return static_cast<int>((static_cast<unsigned __int128>(bits) * static_cast<unsigned>(n)) >>
                            64);
}

// A float in [0, 1) from the upper 24 of 32 random bits.
inline float unit(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

// Numbers one after the other, for a reset.
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
