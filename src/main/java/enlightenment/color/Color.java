package enlightenment.color;

import enlightenment.colorimetry.TransferCurve;

/**
 * A colour as a scene states it: as a screen shows it ({@link DisplayRgb}), or as light ({@link Rgb}). Either can be asked for
 * both: classic shading works on what a screen shows, physical shading on light.
 */
public sealed interface Color permits DisplayRgb, Rgb {
    /**
     * The colour as a screen shows it: light is encoded by {@link TransferCurve#encode}, each component on its own, after what is
     * above 1 was cut to 1.
     */
    DisplayRgb display();

    /** The colour as light: what a screen shows is decoded by {@link TransferCurve#decode}, 0..1 then. */
    Rgb linear();

    /** What the numbers of a picture mean. */
    enum Encoding {
        /** Display-referred: sRGB-encoded components, 0 (none) to 1 (as bright as the screen gets). Classic shading makes these. */
        DISPLAY,

        /** Linear: proportional to radiance in the bands red, green and blue (primaries of Rec. 709, white D65), from 0 without a limit. */
        LINEAR
    }
}
