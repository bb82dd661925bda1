// Which parts of the model are compiled in: all, unless a build option leaves one out. A scene does without
// one by the rules of variants/scene_features.hpp; what is left out has no arrays and no kernel arguments.
#ifndef WARPGRAIN_FEATURES_H
#define WARPGRAIN_FEATURES_H

#ifndef HAS_ROTATION  // angular velocities and torques
#define HAS_ROTATION 1
#endif
#ifndef HAS_FRICTION  // tangential forces; of eq. (1) its shear
#define HAS_FRICTION 1
#endif
#ifndef HAS_DAMPING
#define HAS_DAMPING 1
#endif
#ifndef HAS_GRAVITY
#define HAS_GRAVITY 1
#endif
#ifndef HAS_RADII  // several; else StepParameters has the one of all particles
#define HAS_RADII 1
#endif
#ifndef HAS_MASSES  // several
#define HAS_MASSES 1
#endif
#ifndef HAS_MATERIALS  // the unit's contacts have several rows of parameters
#define HAS_MATERIALS 1
#endif
#ifndef STORES_MATERIALS  // some unit's have
#define STORES_MATERIALS 1
#endif
#ifndef HAS_PLANES
#define HAS_PLANES 1
#endif
#ifndef HAS_RECTANGLES
#define HAS_RECTANGLES 1
#endif
#ifndef N_WALLS  // a number where it is compiled in
#define N_WALLS p.n_walls
#endif

#define HAS_WALLS (HAS_PLANES || HAS_RECTANGLES)
// Of kernels that evaluate forces: velocities for eq. (6), masses for eq. (10) and for weights.
#define READS_MOTION (HAS_DAMPING || HAS_FRICTION || (HAS_GRAVITY && HAS_MASSES))

// What rank_material holds.
#if STORES_MATERIALS
typedef uint2 Identity;
#define rank_in(identity) ((identity).x)
#define material_in(identity) ((identity).y)
#else
typedef uint Identity;
#define rank_in(identity) (identity)
#define material_in(identity) 0
#endif

#endif
