// A cell's stress record, one vec4 in each layer. Where bonds break by traction (BONDS_BREAK):
//   0..3  (T_xx, T_yy, T_zz, T_xy) of corner tetrahedra 0..3, Pa
//   4, 5  (T_yz, T_zx) of tetrahedra 0 and 1, of 2 and 3
// and where whole cells do (CELLS_BREAK), in the last layer:
//   x     largest principal Cauchy stress of the cell, Pa, scaled by S; yzw unused
const int kPrincipalLayer = 6 * BONDS_BREAK;
const int kStressLayers = kPrincipalLayer + CELLS_BREAK;
