// What cells and objects have in common where they touch: src/core/contact.hpp.
const float kContactStiffness = 0.12;
const float kPartingTime = 0.01;  // s
// And nodes and barriers where they do not come apart by a hit: src/core/overlap.hpp.
const float kPushShare = 0.4;  // of the speed of parting
