// h, s: the time that a substep takes.
uniform float stepSize;
