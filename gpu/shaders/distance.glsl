// The distance of this fragment along the view direction.
float distance_here()
{
    if (frame.eye.w > 0.5) return 1.0 / gl_FragCoord.w;
    return (frame.clip[3].z - (gl_FragCoord.z * 2.0 - 1.0)) / frame.clip[2].z;
}
