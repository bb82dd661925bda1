// The data of a step on a device, declared once: valid OpenCL C (after prelude.h has named `real`) and C++
// (templates over `real`). No 3-vectors in arrays: they take 12 bytes in CUDA and 16 in OpenCL.
//
// Arrays. `particle` is the place of a particle in them, its `rank` its place in the scene; n = n_particles.
//   position_radius       Place [n]    x, y, z, radius: place.h
//   velocity_mass         real4 [n]    vx, vy, vz, mass
//   angular_velocity      real4 [n]    wx, wy, wz, unused
//   rank_material         uint2 [n]    rank, index of the material; uint [n] without STORES_MATERIALS
//   force, torque         real4 [n]    x, y, z, unused; gravity included
//   contact_counts        uint2 [n]    touching particles, touching walls; the sum is what slots were needed
//   history_partners      uint [n * CONTACT_SLOTS]       rank, or WALL_PARTNER_BIT | index of the wall
//   history_displacements StoredReal [n * CONTACT_SLOTS * 3]   tangential displacement (eq. 7)
//   cell_keys             ulong [n_keys]   CM (eq. 11), once sorted SCM: cell in the high 32 bits, rank below
//                                  where searches find particles through it: places in the arrays for ranks
//   memory_keys           ulong [n]        keys of the SCM in the order of the arrays to come: contact_count
//   particle_of_rank      uint [n]         where the particle of a rank stands
//   cell_ranges           uint2 [n_cells]  SCCM (eq. 12): a cell's first entry in the SCM, one past its last
//   scan_sums             uint [n_cells / SCAN_BLOCK, rounded up]  particles in the blocks of cells before
//   near                  uint [LIST_SLOTS * n]   a search's lists: entry k of particle i at k * n + i
//   near_counts           uint [n]         how many entries
//   near_groups           uint [GROUP_SLOTS * groups]   search `cluster`: its lists of groups
//   listed_positions      Place [n]        where particles were when lists with a skin were made
//   lists_outdated        uint [1]         whether such lists may miss a contact
//   fixed_sums            long [SUM_REALS * n]   force, torque in quanta, where they are added up by atomics
//   contact_parameters    real4 [n_materials * n_materials]   C_kn, C_kt, alpha, mu
//   walls                 WallLayout [n_walls]; FixedWallLayout where places are fixed-point
//   status                uint [STATUS_SIZE]
// Arrays of what a scene does without (features.h) are not there.
#ifndef WARPGRAIN_LAYOUT_H
#define WARPGRAIN_LAYOUT_H

// Of a host: CUDA C++ is a device's.
#if defined(__cplusplus) && !defined(__CUDACC__)
#define LAYOUT_OF_HOST
#endif

#ifdef LAYOUT_OF_HOST
#include <cstdint>
#define LAYOUT_STRUCT(name) \
  template <class real>     \
  struct name
#define LAYOUT_STRUCT_WITH_PLACES(name)   \
  template <class real, class coordinate> \
  struct name
#define LAYOUT_TRIPLE Triple<real>
#define LAYOUT_PLACE Triple<coordinate>
#define LAYOUT_COORDINATE coordinate
#define LAYOUT_CONSTANTS ContactConstants<real>
#define LAYOUT_UINT std::uint32_t
#define LAYOUT_LONG std::int64_t
namespace warpgrain::layout {
#else
#define LAYOUT_STRUCT(name) \
  typedef struct name name; \
  struct name
#define LAYOUT_STRUCT_WITH_PLACES(name) LAYOUT_STRUCT(name)
#define LAYOUT_TRIPLE Triple
#define LAYOUT_PLACE PlaceTriple
#define LAYOUT_COORDINATE coordinate
#define LAYOUT_CONSTANTS ContactConstants
#define LAYOUT_UINT uint
#define LAYOUT_LONG long
#endif

LAYOUT_STRUCT(Triple) { real x, y, z; };
#ifndef LAYOUT_OF_HOST
typedef struct {
  coordinate x, y, z;
} PlaceTriple;
#endif

// What all contacts with other particles, or all with walls, have in common, where they do.
LAYOUT_STRUCT(ContactConstants) {
  real normal_parameter, tangential_parameter, damping_parameter, friction_coefficient;
  real effective_radius, effective_mass;
  real radius_ratio, mass_ratio;  // as in contact_law.h
};

// What every kernel of a step may need, passed by value.
LAYOUT_STRUCT_WITH_PLACES(StepParameters) {
  LAYOUT_PLACE lower, upper;  // of the domain, which is the grid's box
  real time_step;
  LAYOUT_TRIPLE gravity;
  real inverse_cell_size;
  real quanta_per_force, quanta_per_torque;  // of fixed_sums
  real skin;                                 // of neighbour lists
  real k_spring, k_damping, k_shear;         // eq. (1)
  LAYOUT_UINT n_particles;
  LAYOUT_UINT n_keys;  // n_particles, padded as the sort needs it
  LAYOUT_UINT n_materials;
  LAYOUT_UINT n_walls;
  LAYOUT_UINT cells_x, cells_y, cells_z;
  LAYOUT_UINT n_cells;  // numbers of cells; some may be of none
  // Where all particles are alike.
  LAYOUT_COORDINATE radius;
  real mass;
  real step_per_mass, step_per_inertia;  // the time step over the mass, over the moment of inertia
  LAYOUT_CONSTANTS of_pairs, of_walls;
};

LAYOUT_STRUCT(WallLayout) {
  LAYOUT_TRIPLE point;   // a point of the plane, or the rectangle's corner
  LAYOUT_TRIPLE normal;  // unit
  // Of a plane: how far along the normal it stands from `point` as rounded; float places at 0.1 m lie 7 nm
  // apart.
  real point_rest;
  // Of a rectangle: each edge divided by its squared length, so that a dot product gives a fraction of it ...
  LAYOUT_TRIPLE fraction_u, fraction_v;
  LAYOUT_TRIPLE edge_u, edge_v;  // ... and the edge itself
  LAYOUT_UINT is_rectangle;
  LAYOUT_UINT material;
};

// The same in the fixed point of precision `mixed`: lengths in its units, unit vectors in 2^-62.
LAYOUT_STRUCT(FixedWallLayout) {
  LAYOUT_LONG point[3];
  LAYOUT_LONG axes[3][3];                  // the normal; of a rectangle also the directions of its edges
  LAYOUT_LONG length_u, length_v;          // of a rectangle's edges
  LAYOUT_TRIPLE normal, along_u, along_v;  // the axes, rounded
  LAYOUT_UINT is_rectangle;
  LAYOUT_UINT material;
};

#ifdef LAYOUT_OF_HOST
}  // namespace warpgrain::layout
#endif

#define WALL_PARTNER_BIT 0x80000000u

// Work-items of a work-group: of the bitonic sort, which orders blocks of twice as many keys in local memory;
// of the scan, which takes SCAN_CELLS cells a work-item; of order_by_contacts, which orders windows of twice
// as many particles; of the rest.
#define SORT_WORK_GROUP 512
#define SCAN_WORK_GROUP 256
#define ORDER_WORK_GROUP 256
#define CELL_WORK_GROUP 32
#define SCAN_CELLS 8
#define SCAN_BLOCK (SCAN_WORK_GROUP * SCAN_CELLS)
// Cells of a work-group of the search `warp_per_cell`: as large as a particle, they hold 27 particles of a
// dense bed, nearly a warp of them; particles of a group of the search `cluster`.
#define BLOCK_X 4
#define BLOCK_Y 3
#define BLOCK_Z 2
#define GROUP_SIZE 8u
#ifndef PARTICLE_WORK_GROUP  // the axis work_group_size
#define PARTICLE_WORK_GROUP 128
#endif

// status[]: the steps done; whether an earlier step failed, which freezes what follows; then, for each kind
// of error, the smallest rank it befell (NO_PARTICLE: none).
#define STATUS_STEPS 0
#define STATUS_STOPPED 1
#define STATUS_OUT_OF_DOMAIN 2
#define STATUS_NOT_FINITE 3
#define STATUS_SLOTS_FULL 4
#define STATUS_LIST_FULL 5
#define STATUS_FORCE_TOO_LARGE 6
#define STATUS_DISPLACEMENT_TOO_LARGE 7
#define STATUS_SIZE 8
#define NO_PARTICLE 0xFFFFFFFFu

// Values of the model's options, as -D SLIP_HISTORY=... and -D NORMAL_FORCE=... name them.
#define SLIP_HISTORY_CLIP 0
#define SLIP_HISTORY_PAPER 1
#define SLIP_HISTORY_LAMMPS 2
#define SLIP_HISTORY_LIGGGHTS 3
#define NORMAL_FORCE_SIGNED 0
#define NORMAL_FORCE_REPULSIVE 1

#endif
