package enlightenment.physical;

import enlightenment.color.Color;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.material.Texture;

/** Colours as three numbers of light; what a screen shows is decoded by the formula of IEC 61966-2-1. */
final class NaiveColors {
    private NaiveColors() {}

    static double[] of(Rgb c) {
        return new double[] {c.r(), c.g(), c.b()};
    }

    static double[] of(Color color) {
        if (color instanceof DisplayRgb d) {
            return new double[] {decoded(d.r()), decoded(d.g()), decoded(d.b())};
        }
        return of((Rgb) color);
    }

    static double[] of(Texture texture, NaiveShape shape, enlightenment.math.Vec3 p) {
        if (texture instanceof Texture.Solid s) {
            return of(s.color());
        }
        if (texture instanceof Texture.Checker c) {
            double[] uv = shape.texture(p);
            long squares = (long) Math.floor(uv[0] * c.scale()) + (long) Math.floor(uv[1] * c.scale());
            return of(c.colors().get((int) Math.floorMod(squares, 2L)));
        }
        throw new UnsupportedOperationException("no naive form of " + texture);
    }

    static double[] product(double[] a, double[] b) {
        return new double[] {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
    }

    private static double decoded(double v) {
        return v <= 0.04045 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4);
    }
}
