// Where the highlighted instances are: one value a pass.
layout(location = 0) out float out_mask;
uniform float value;
void main() { out_mask = value; }
