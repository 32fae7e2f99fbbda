// Writes depth alone. MASKED variants leave out parts that the material cuts away.
#ifdef MASKED
#define READS_MATERIAL
#include "frame.glsl"
#include "mesh_inputs.glsl"
#include "surface.glsl"
void main() { surface_here(); }
#else
void main() {}
#endif
