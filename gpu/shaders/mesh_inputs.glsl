// What mesh.vert hands to fragment programs.
in vec3 at_scene;
in vec3 at_normal;
in vec4 at_color;
#ifdef TEXTURED
in vec4 at_tangent;
in vec4 at_uv; // both sets
#endif
