package enlightenment.world.material;

import enlightenment.bsdf.HenyeyGreenstein;
import enlightenment.color.Rgb;
import enlightenment.frame.SceneFrame;
import enlightenment.material.Medium;
import enlightenment.numeric.Scale;

/** A scattering medium that fills a solid or the whole scene, homogeneous; coefficients are per unit of length of the frame. Immutable. */
public final class HomogeneousMedium {
    /**
     * The largest extinction coefficient in the frame, in which the scene has a size of about 1: with shorter mean free paths, rounded
     * positions could not resolve a path's steps, and light does not get visibly far.
     */
    private static final double DENSEST = 0x1p36;

    /** The scattering coefficient σs by band, per unit of length of the frame, at least 0. */
    public final double scatteringR;

    public final double scatteringG;
    public final double scatteringB;

    /** The extinction coefficient σt = σs + σa by band, per unit of length of the frame: the inverse of the mean free path. */
    public final double extinctionR;

    public final double extinctionG;
    public final double extinctionB;

    /** Whether extinction is the same in all bands. */
    public final boolean isGrey;

    /** The phase function. */
    public final HenyeyGreenstein phase;

    private final String look;

    private HomogeneousMedium(Rgb scattering, Rgb extinction, double anisotropy) {
        scatteringR = scattering.r();
        scatteringG = scattering.g();
        scatteringB = scattering.b();
        extinctionR = extinction.r();
        extinctionG = extinction.g();
        extinctionB = extinction.b();
        isGrey = extinctionR == extinctionG && extinctionG == extinctionB;
        phase = new HenyeyGreenstein(anisotropy);
        look = scatteringR + "," + scatteringG + "," + scatteringB + " " + extinctionR + "," + extinctionG + ","
                + extinctionB + " " + anisotropy;
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
        double r = clamped(extinction.r(), frame);
        double g = clamped(extinction.g(), frame);
        double b = clamped(extinction.b(), frame);
        return new HomogeneousMedium(
                new Rgb(
                        share(scattering.r(), extinction.r(), r),
                        share(scattering.g(), extinction.g(), g),
                        share(scattering.b(), extinction.b(), b)),
                new Rgb(r, g, b),
                anisotropy);
    }

    private static double clamped(double extinction, SceneFrame frame) {
        return Math.min(Scale.scalb(extinction, frame.exponent()), DENSEST);
    }

    private static double share(double scattering, double extinction, double inFrame) {
        return scattering == extinction ? inFrame : scattering / extinction * inFrame;
    }

    /** The single-scattering albedo, by similarity from that of an isotropic medium with the same reflectance (H. van de Hulst). */
    private static double albedo(double givenBack, double g) {
        double isotropic = AlbedoInversion.singleScattering(givenBack);
        return isotropic / (isotropic + (1 - g) * (1 - isotropic));
    }

    /** Whether it scatters any light; if it only absorbs, transmittance describes it. */
    boolean scatters() {
        return scatteringR > 0 || scatteringG > 0 || scatteringB > 0;
    }

    /** The extinction coefficient, by band. */
    Rgb extinction() {
        return new Rgb(extinctionR, extinctionG, extinctionB);
    }

    /** A text that is equal for media that look the same. */
    String look() {
        return look;
    }
}
