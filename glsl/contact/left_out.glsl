// What a search for contacts leaves out, as one number: how many it had no room for, up to 1023, and how many times as fast as it
// can follow things met, in quarter octaves: 0, as fast at most.
float leftOut(float dropped, float haste) { return min(dropped, 1023.0) + 1024.0 * haste; }
float droppedOf(float number) { return mod(number, 1024.0); }
float hasteOf(float number) { return floor(number / 1024.0); }
