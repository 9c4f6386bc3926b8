/// Cells of an emissive mesh: parts of equal area, from each of which a surface point takes one point.
#pragma once
#include <vector>

#include "kernels/lights/emission.h"

namespace brandung {

struct EmissiveCells {
    std::vector<EmissiveFace>
        faces;                ///< of the cells one after another, each with the part of it that is in the cell, and the cell's table of aliases
    std::vector<uint> first;  ///< by cell: its first face; and one more entry, their number
    double area = 0;          ///< of all
};

/// Cuts the mesh along a curve that goes through its faces, neighbours after neighbours, and within each through quarters of quarters (Morton 1966):
/// cells are compact, of one face or of many; 4^n cells of a parallelogram are those of a grid.
EmissiveCells make_emissive_cells(std::vector<EmissiveFace> faces, uint cells);

}  // namespace brandung
