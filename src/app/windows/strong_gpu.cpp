// On a laptop with two GPUs, drivers give a program the weak one unless they find these symbols in
// it.
extern "C" {
/// NVIDIA, "Optimus Rendering Policies".
__declspec(dllexport) unsigned long NvOptimusEnablement = 1;
/// AMD, "PowerXpress".
__declspec(dllexport) int AmdPowerXpressRequestHighPerformance = 1;
}
