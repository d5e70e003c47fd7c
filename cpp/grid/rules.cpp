#include "grid/rules.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace matrixworld {

void require_range(const char* name, int value, int low, int high) {
    if (value >= low && value <= high) return;
    throw std::invalid_argument(std::string(name) + ": expected " + std::to_string(low) + " to " +
                                std::to_string(high) + ", got " + std::to_string(value));
}

int Config::n_random_obstacles() const {
    return static_cast<int>(std::lround(density * rows * cols));
}

void Config::validate() const {
    require_range("rows", rows, 1, kMaxSide);
    require_range("cols", cols, 1, kMaxSide);
    const int area = rows * cols;
    require_range("n_pursuers", n_pursuers, 1, std::min(area, kMaxTeam));
    require_range("n_evaders", n_evaders, 1, std::min(area, kMaxTeam));
    require_range("fov", fov, 1, kMaxFieldOfView);
    if (fov % 2 == 0) {
        throw std::invalid_argument("fov: expected an odd number, got " + std::to_string(fov));
    }
    require_range("max_steps", max_steps, 1, 1 << 30);
    // Written so that NaN is refused, too.
    if (!(density >= 0.0 && density < 1.0)) {
        throw std::invalid_argument("obstacle density: expected a number in [0, 1), got " +
                                    std::to_string(density));
    }
    if (map.size() != 0 && map.size() != area) {
        throw std::invalid_argument("obstacle map: expected " + std::to_string(area) +
                                    " cells, got " + std::to_string(map.size()));
    }
    const int blocked = map.size() ? static_cast<int>((map != 0).count()) : n_random_obstacles();
    const int agents = n_pursuers + n_evaders;
    if (agents > area - blocked) {
        throw std::invalid_argument("more agents than free cells: expected at most " +
                                    std::to_string(area - blocked) + " agents, got " +
                                    std::to_string(agents));
    }
}

}  // namespace matrixworld
