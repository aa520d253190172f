// What cells and objects have in common where they touch: src/core/contact.hpp.
const float kContactStiffness = 0.12;
const float kPartingTime = 0.01;  // s
