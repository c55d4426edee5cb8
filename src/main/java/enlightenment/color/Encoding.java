package enlightenment.color;

/** What the numbers of a picture mean. */
public enum Encoding {
    /** Display-referred: sRGB-encoded components, 0 (none) to 1 (as bright as the screen gets). Classic shading makes these. */
    DISPLAY,

    /** Linear: proportional to radiance in the bands red, green and blue (primaries of Rec. 709, white D65), from 0 without a limit. */
    LINEAR
}
