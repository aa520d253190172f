// Constants of the physics, of which C++ and GLSL each have a version. Compiles as either: in C++ it is included inside namespace
// sunder::core (src/core/constants.hpp), which says what reals and whole numbers are there.
#ifndef SUNDER_REAL
#define SUNDER_REAL(name, value) const float name = value
#define SUNDER_WHOLE(name, value) const int name = value
#endif

// Elasticity (src/core/elasticity.hpp). Stiffness-proportional damping b: stress is taken from G = F + b·h·Ḟ; and of strongly
// deformed elements.
SUNDER_REAL(kDamping, 0.1);
SUNDER_REAL(kHotDamping, 0.5);
// |b·h·Ḟ|² up to which a cell turns as one, a tenth of a radian; and |F|², which is 3 at rest.
SUNDER_REAL(kMostTurn2, 0.02);
SUNDER_REAL(kMostStretch2, 4.5);

// Fracture (docs/fracture.md). s, in which the slow part of a stress follows it; strengths, from which on a blow breaks at once
// (src/core/element_law.hpp).
SUNDER_REAL(kSlowTime, 0.1);
SUNDER_REAL(kSuddenStress, 5.0);

// Contact between cells (src/core/contact.hpp).
SUNDER_REAL(kContactStiffness, 0.12);
SUNDER_REAL(kFrictionRate, 0.3);
SUNDER_REAL(kConstraintShare, 0.95);   // γ
SUNDER_REAL(kInelasticDamping, 0.6);   // α₀
SUNDER_REAL(kPartingTime, 0.01);       // s
SUNDER_REAL(kCrowdGap, 0.1);           // radii, the smaller one's
SUNDER_REAL(kSweptWay, 0.1);           // sums of radii
// Things in one another as the world begins (src/core/overlap.hpp), of the speed of parting.
SUNDER_REAL(kPushShare, 0.4);
// Cell edges/s, below which bodies in contact may fall asleep (src/core/sleep.hpp).
SUNDER_REAL(kCreepSpeed, 0.5);
// What a search on the GPU finds for a sphere; how it packs what it leaves out (glsl/contact/left_out.glsl).
SUNDER_WHOLE(kMostPartners, 28);
SUNDER_WHOLE(kHasteUnit, 1024);

// Objects (src/core/object_contact.hpp).
SUNDER_REAL(kBounceSpeed, 0.3);        // m/s
SUNDER_WHOLE(kProjections, 6);
SUNDER_WHOLE(kAdvances, 8);
SUNDER_REAL(kCellRoundness, 0.1);      // radius of a cell's box in shortest edges
SUNDER_REAL(kLoadTime, 0.05);          // s
SUNDER_REAL(kUnloadTime, 0.01);        // s
SUNDER_REAL(kGrowthTime, 1.5e-3);      // s, in which a load grows e times
SUNDER_REAL(kPressingSpeed, 1.0);      // m/s
SUNDER_REAL(kLoadedDepth, 0.2);        // with it a tower of ten boxes is overdamped
// An object answers as if it weighed so much more than it carries: its mass is shared out among a dozen touches and more.
SUNDER_REAL(kLoadMargin, 4.0);

// Who pushed hardest (glsl/incidents/rank.glsl): the largest number of 24 bits, from which objects are counted down.
SUNDER_WHOLE(kNobody, 16777215);
