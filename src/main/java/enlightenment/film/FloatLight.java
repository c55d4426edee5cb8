package enlightenment.film;

import enlightenment.color.Color;
import enlightenment.color.DisplayCurve;

/** Finished pictures are floats. */
public final class FloatLight {
    private FloatLight() {}

    /** The float for a number of a picture: light that is less than any float is the least one, which tells it from none. */
    public static float of(double value, DisplayCurve curve) {
        float nearest = (float) value;
        return nearest == 0 && value > 0 && curve.encoding() == Color.Encoding.LINEAR ? Float.MIN_VALUE : nearest;
    }
}
