// Layers of the array of surface textures; compiles as C++ and as GLSL.
#define SUNDER_LAYER_WOOD 0         // grain along the second coordinate
#define SUNDER_LAYER_WOOD_END 1     // growth rings
#define SUNDER_LAYER_WOOD_SPLIT 2   // fresh, fibrous
#define SUNDER_LAYER_BRICK 3
#define SUNDER_LAYER_BRICK_SPLIT 4
#define SUNDER_LAYER_MORTAR 5
#define SUNDER_LAYER_CONCRETE 6
#define SUNDER_LAYER_CONCRETE_SPLIT 7  // aggregate
#define SUNDER_LAYER_RUBBER 8
#define SUNDER_LAYER_CLOUDS 9  // for the sky, and for slow variation
#define SUNDER_SURFACE_LAYERS 10
