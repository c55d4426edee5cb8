package enlightenment.compiled;

import enlightenment.bsdf.HenyeyGreenstein;
import enlightenment.color.Rgb;
import enlightenment.frame.SceneFrame;
import enlightenment.material.Medium;
import enlightenment.numeric.Scale;

/** What fills a solid that scatters light inside, or the whole scene: the same everywhere, per unit of length of the frame. Immutable. */
public final class HomogeneousMedium {
    /** How much is scattered, by band. */
    public final double scatteringR;

    public final double scatteringG;
    public final double scatteringB;

    /** How much is scattered or absorbed, by band. */
    public final double extinctionR;

    public final double extinctionG;
    public final double extinctionB;

    /** Whether that is the same in all bands. */
    public final boolean isGrey;

    /** How it scatters. */
    public final HenyeyGreenstein phase;

    private HomogeneousMedium(Rgb scattering, Rgb extinction, double anisotropy) {
        scatteringR = scattering.r();
        scatteringG = scattering.g();
        scatteringB = scattering.b();
        extinctionR = extinction.r();
        extinctionG = extinction.g();
        extinctionB = extinction.b();
        isGrey = extinctionR == extinctionG && extinctionG == extinctionB;
        phase = new HenyeyGreenstein(anisotropy);
    }

    static HomogeneousMedium of(Medium medium, SceneFrame frame) {
        if (medium instanceof Medium.Coefficients c) {
            Rgb s = c.scattering();
            Rgb a = c.absorption();
            return of(s, new Rgb(s.r() + a.r(), s.g() + a.g(), s.b() + a.b()), c.anisotropy(), frame);
        }
        Medium.Colored c = (Medium.Colored) medium;
        Rgb color = c.color().linear();
        Rgb path = c.meanFreePath();
        Rgb extinction = new Rgb(1 / path.r(), 1 / path.g(), 1 / path.b());
        double g = c.anisotropy();
        Rgb scattering = new Rgb(
                extinction.r() * albedo(color.r(), g),
                extinction.g() * albedo(color.g(), g),
                extinction.b() * albedo(color.b(), g));
        return of(scattering, extinction, g, frame);
    }

    private static HomogeneousMedium of(Rgb scattering, Rgb extinction, double anisotropy, SceneFrame frame) {
        return new HomogeneousMedium(
                scaled(scattering, frame.exponent()), scaled(extinction, frame.exponent()), anisotropy);
    }

    /** The albedo of single scattering, by similarity from that of an isotropic medium which gives back the same share (H. van de Hulst). */
    private static double albedo(double givenBack, double g) {
        double isotropic = AlbedoInversion.singleScattering(givenBack);
        return isotropic / (isotropic + (1 - g) * (1 - isotropic));
    }

    private static Rgb scaled(Rgb c, int exponent) {
        return new Rgb(Scale.scalb(c.r(), exponent), Scale.scalb(c.g(), exponent), Scale.scalb(c.b(), exponent));
    }

    /** How much is lost on a straight way, by band: scattered or absorbed. */
    Rgb extinction() {
        return new Rgb(extinctionR, extinctionG, extinctionB);
    }

    /** All numbers as a text. */
    String look(double anisotropy) {
        return scatteringR + "," + scatteringG + "," + scatteringB + " " + extinctionR + "," + extinctionG + ","
                + extinctionB + " " + anisotropy;
    }
}
