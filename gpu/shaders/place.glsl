// Places the drawn item: the instance, or one of its copies.
#ifdef TILES // are COPIES, too, but bent before the matrix of all of them takes them to the scene
#include "tile.glsl"
uniform mat4 to_scene;
uniform mat3 normal_to_scene;
const uint id_of_copy = 0u;
mat4 scene_from_mesh() { return to_scene; }
mat3 scene_from_normals() { return normal_to_scene; }
#elif defined(COPIES)
layout(location = 8) in vec4 copy_x; // rows of its matrix
layout(location = 9) in vec4 copy_y;
layout(location = 10) in vec4 copy_z;
layout(location = 11) in vec3 copy_normal_x; // and of that of normals
layout(location = 12) in vec3 copy_normal_y;
layout(location = 13) in vec3 copy_normal_z;
layout(location = 14) in uint id_of_copy;
mat4 scene_from_mesh() { return transpose(mat4(copy_x, copy_y, copy_z, vec4(0.0, 0.0, 0.0, 1.0))); }
mat3 scene_from_normals() { return transpose(mat3(copy_normal_x, copy_normal_y, copy_normal_z)); }
#else
uniform mat4 to_scene;
uniform mat3 normal_to_scene;
mat4 scene_from_mesh() { return to_scene; }
mat3 scene_from_normals() { return normal_to_scene; }
#endif
