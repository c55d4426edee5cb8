package enlightenment.transport.state;

import enlightenment.bsdf.DielectricFresnel;
import enlightenment.bsdf.Scattering;
import enlightenment.colorimetry.BandSensitivities;
import enlightenment.colorimetry.CauchyFormula;
import enlightenment.sampling.Sampler;
import enlightenment.world.material.SurfaceMaterial;

/**
 * The wavelength of a path through glass that disperses. It is drawn when the path begins, and all indices of refraction are those that it
 * sees. But the path stays one of all wavelengths, in three bands, until it does what they do not do alike: until it is refracted at
 * a border whose index depends on the wavelength, or reflected there by that part of the reflectance that not all of them share. From
 * then on each band counts as the wavelength belongs to it, over the probability of the wavelength. See docs/notes/dispersion.md.
 */
public final class PathWavelength {
    private static final BandSensitivities BANDS = BandSensitivities.DAYLIGHT;
    private static final double FIRST = CauchyFormula.place(BandSensitivities.SHORTEST);
    private static final double LAST = CauchyFormula.place(BandSensitivities.LONGEST);

    /** The sensitivity of the bands to the wavelength, over its probability: each is 1 in the mean, and may be negative. */
    public double red;

    public double green;
    public double blue;

    /** Whether the path is one of this wavelength alone. */
    boolean isAlone;

    /** Whether it has become that, and nobody took note yet. */
    private boolean isNew;

    /** Where the wavelength is ({@link CauchyFormula#place}). */
    private double place = FIRST;

    /** The index of refraction before the border, at both ends of the range of wavelengths. */
    private double fromFirst;

    private double fromLast;

    /** The relative index at the border, at both ends. */
    double etaFirst;

    double etaLast;

    private final double[] pair = new double[2];

    /** Draws the wavelength of a path that begins. */
    public void begin(Sampler sampler) {
        sampler.pair(0, Sampler.Purpose.WAVELENGTH, pair);
        begin(pair[0]);
    }

    /** The same by a number in [0, 1). */
    public void begin(double number) {
        double wavelength = BANDS.draw(number);
        place = CauchyFormula.place(wavelength);
        red = BANDS.weight(wavelength, 0);
        green = BANDS.weight(wavelength, 1);
        blue = BANDS.weight(wavelength, 2);
        isAlone = false;
        isNew = false;
    }

    /** Takes the wavelength of another path. */
    public void set(PathWavelength o) {
        place = o.place;
    }

    /** The index of refraction of a material. */
    public double index(SurfaceMaterial material) {
        return CauchyFormula.index(material.indexOfRefraction, material.dispersion, place);
    }

    /** Tells the medium before a border; null is empty space. */
    public void leave(SurfaceMaterial medium) {
        fromFirst = index(medium, FIRST);
        fromLast = index(medium, LAST);
    }

    /** Tells the medium behind it. */
    public void enter(SurfaceMaterial medium) {
        etaFirst = fromFirst / index(medium, FIRST);
        etaLast = fromLast / index(medium, LAST);
    }

    private static double index(SurfaceMaterial medium, double where) {
        return medium == null ? 1 : CauchyFormula.index(medium.indexOfRefraction, medium.dispersion, where);
    }

    /**
     * Tells that the path was scattered at the border.
     *
     * @param s how
     * @param number uniform in [0, 1), independent of that
     */
    public void scattered(Scattering s, double number) {
        if (!isAlone && number >= common(s)) {
            isAlone = true;
            isNew = true;
        }
    }

    /** Whether the path is alone since this was asked last: then what it is worth has to be multiplied by the weights of the bands. */
    public boolean takesEffect() {
        boolean was = isNew;
        isNew = false;
        return was;
    }

    /**
     * Of the light that was scattered at the border, the share that is so at all wavelengths alike: of light that a smooth one reflects a
     * reflectance that no wavelength falls below, over that of this wavelength.
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
     * Whether light that is scattered towards the path where it is has the wavelength's colour.
     *
     * @param isRough whether that is at a rough border
     */
    public boolean colors(boolean isRough) {
        return isAlone || isRough && disperses();
    }

    /** Multiplies the value of light at the rough border that the path is at by its colour, if the path has not taken that itself. */
    public void color(Scattering s) {
        if (!isAlone && disperses()) {
            s.valueR *= red;
            s.valueG *= green;
            s.valueB *= blue;
        }
    }
}
