// An end of an edge of a face, a little nearer to the eye than the face itself.
#include "frame.glsl"
#include "place.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 scene_to_clip;
out vec3 end_normal; // view

void main()
{
    const float PULL = 4e-5;
    vec3 p = position, n = normal;
#ifdef TILES
    TileVertex bent = tile_vertex(position, normal, vec3(0.0));
    p = bent.position;
    n = bent.normal;
#endif
    gl_Position = scene_to_clip * (scene_from_mesh() * vec4(p, 1.0));
    gl_Position.z -= PULL * gl_Position.w;
    end_normal = mat3(frame.view) * (scene_from_normals() * n);
}
