#include "game/terrain.hpp"

#include <algorithm>

namespace matrixworld {

Terrain::Terrain(const Grid& grid, int margin, const ByteArray& map)
    : grid(grid),
      kind(ByteArray::Constant(grid.n_cells(), kBorder)),
      obstacles(grid, margin),
      blocked(grid, margin, 1) {
    // Everything begins as border, the margin of `blocked` included; the cells of the grid are
    // opened row by row, in which they are contiguous.
    for (int row = 0; row < grid.rows(); ++row) {
        kind.segment(grid.cell(row, 0), grid.cols()).setConstant(kFree);
        std::fill_n(&blocked.at(row, 0), grid.cols(), std::uint8_t{0});
    }
    for (int i = 0; i < map.size(); ++i) {
        if (map[i]) set_obstacle(grid.cell(i / grid.cols(), i % grid.cols()));
    }
}

void Terrain::set_obstacle(int cell) {
    kind[cell] = kObstacle;
    obstacles.set(grid.row(cell), grid.col(cell));
    blocked.at(grid.row(cell), grid.col(cell)) = 1;
    has_obstacles = true;
}

void Terrain::write_map(std::uint8_t* out) const {
    // Within the grid only obstacles are blocked, so the rows of the plane are the map's.
    for (int row = 0; row < grid.rows(); ++row) {
        out = std::copy_n(blocked.window(row, 0), grid.cols(), out);
    }
}

}  // namespace matrixworld
