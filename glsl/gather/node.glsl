// A cell's eight nodes: two layers each. xyz: displacement, m; w: rest height, m, carried along for the ground. xyz: velocity, m/s;
// w: largest squared speed since bodies were last looked at for rest, m²/s².
uniform sampler2DArray nodes;

int displacementLayer(int corner) { return 2 * corner; }
int velocityLayer(int corner) { return 2 * corner + 1; }
