// Counts the set bits of 32: OpenGL below 4.0 has no function for it.
int bits_set(uint v)
{
#if __VERSION__ >= 400
    return bitCount(v);
#else
    v -= v >> 1 & 0x55555555u;
    v = (v & 0x33333333u) + (v >> 2 & 0x33333333u);
    return int((v + (v >> 4) & 0x0f0f0f0fu) * 0x01010101u >> 24);
#endif
}
