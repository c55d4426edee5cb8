package enlightenment.transport.state;

import enlightenment.bsdf.DielectricFresnel;
import enlightenment.bsdf.Scattering;
import enlightenment.colorimetry.BandSensitivities;
import enlightenment.colorimetry.CauchyFormula;
import enlightenment.sampling.Sampler;
import enlightenment.world.material.SurfaceMaterial;

/**
 * The wavelength of a path through glass that disperses. It is sampled when the path begins and decides all indices of refraction. The path
 * still stands for all wavelengths, in three bands, until an event at which they differ: refraction at an interface whose index depends on
 * the wavelength, or the part of its reflectance that not all wavelengths share. From then on each band is weighted by its sensitivity to
 * the wavelength over the density of the wavelength. See docs/notes/dispersion.md.
 */
public final class PathWavelength {
    private static final BandSensitivities BANDS = BandSensitivities.DAYLIGHT;
    private static final double FIRST = CauchyFormula.place(BandSensitivities.SHORTEST);
    private static final double LAST = CauchyFormula.place(BandSensitivities.LONGEST);

    /**
     * Sensitivity of red, green and blue to the wavelength over the wavelength's density: the mean of each is 1, and it may be negative.
     */
    public double red;

    public double green;
    public double blue;

    /** Whether the path stands for its own wavelength alone. */
    boolean isAlone;

    /** Whether that has begun since the last call of {@link #takesEffect}. */
    private boolean isNew;

    /** The position of the wavelength as {@link CauchyFormula#place} measures it. */
    private double place = FIRST;

    /** The index of refraction before the interface, at both ends of the spectrum. */
    private double fromFirst;

    private double fromLast;

    /** The relative index of refraction at the interface, at both ends of the spectrum. */
    double etaFirst;

    double etaLast;

    private final double[] pair = new double[2];

    /** Samples the wavelength of a path that begins. */
    public void begin(Sampler sampler) {
        sampler.pair(0, Sampler.Purpose.WAVELENGTH, pair);
        begin(pair[0]);
    }

    /** Sets the wavelength by inverting its distribution at a number in [0, 1). */
    public void begin(double number) {
        double wavelength = BANDS.draw(number);
        place = CauchyFormula.place(wavelength);
        red = BANDS.weight(wavelength, 0);
        green = BANDS.weight(wavelength, 1);
        blue = BANDS.weight(wavelength, 2);
        isAlone = false;
        isNew = false;
    }

    /** Copies the wavelength of another path. */
    public void set(PathWavelength o) {
        place = o.place;
    }

    /** The index of refraction of a material at this wavelength. */
    public double index(SurfaceMaterial material) {
        return CauchyFormula.index(material.indexOfRefraction, material.dispersion, place);
    }

    /** Sets the medium before an interface; null is empty space. */
    public void leave(SurfaceMaterial medium) {
        fromFirst = index(medium, FIRST);
        fromLast = index(medium, LAST);
    }

    /** Sets the medium behind the interface whose other side {@link #leave} has set; null is empty space. */
    public void enter(SurfaceMaterial medium) {
        etaFirst = fromFirst / index(medium, FIRST);
        etaLast = fromLast / index(medium, LAST);
    }

    private static double index(SurfaceMaterial medium, double where) {
        return medium == null ? 1 : CauchyFormula.index(medium.indexOfRefraction, medium.dispersion, where);
    }

    /**
     * Reports a scattering event at the interface, after which the path may stand for its wavelength alone.
     *
     * @param s the sampled event
     * @param number uniform in [0, 1), independent of the event
     */
    public void scattered(Scattering s, double number) {
        if (!isAlone && number >= common(s)) {
            isAlone = true;
            isNew = true;
        }
    }

    /**
     * Whether the path has come to stand for its wavelength alone since the last call: its throughput must then be multiplied by the
     * weights {@link #red}, green and blue.
     */
    public boolean takesEffect() {
        boolean was = isNew;
        isNew = false;
        return was;
    }

    /**
     * The share of the event's light that all wavelengths have in common, 0..1: for reflection at a smooth interface the least reflectance
     * of any wavelength over that of this one.
     */
    double common(Scattering s) {
        if (!disperses()) {
            return 1;
        }
        if (s.transmitted || !s.delta) {
            return 0;
        }
        double c = Math.min(Math.max(s.ox * s.nx + s.oy * s.ny + s.oz * s.nz, 0), 1);
        double least = DielectricFresnel.leastReflectance(c, etaFirst, etaLast);
        double own = DielectricFresnel.reflectance(c, s.eta);
        return least < own ? least / own : 1;
    }

    private boolean disperses() {
        return etaFirst != etaLast;
    }

    /**
     * Whether light that is scattered at the current vertex towards the previous one has the colour of the wavelength.
     *
     * @param isRough whether the vertex is on a rough interface
     */
    public boolean colors(boolean isRough) {
        return isAlone || isRough && disperses();
    }

    /**
     * Multiplies the value of light that is scattered at a rough interface by the wavelength's colour, unless the path's throughput has
     * that already.
     */
    public void color(Scattering s) {
        if (!isAlone && disperses()) {
            s.valueR *= red;
            s.valueG *= green;
            s.valueB *= blue;
        }
    }
}
