out vec4 pixel;
void main() { pixel = developed(backdrop(gl_FragCoord.xy)); }
