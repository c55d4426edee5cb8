package enlightenment.transport.state;

import enlightenment.bsdf.Reradiation;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.surface.SurfaceInteraction;
import java.util.Arrays;

/**
 * The radiance L that a path from the eye has gathered, its throughput β for what is to come, and the deterministic part of L. Mutable, one
 * per thread.
 */
public final class PathValue {
    /** Russian roulette may end a path from this event on, {@linkplain PathState#eventsForRoulette of those that count}. */
    public static final int ROULETTE_FROM = 5;

    /** Russian roulette may end a path before {@link #ROULETTE_FROM} if its throughput is less than this. */
    public static final double FAINT = 0.05;

    /** The upper bound of the probability of surviving Russian roulette: paths in a closed white room must end, too. */
    public static final double LARGEST_SURVIVAL = 0.99;

    /** The wavelength of the path; null if no glass of the scene disperses. */
    public PathWavelength wavelength;

    /** The radiance gathered so far, red, green and blue. */
    double red;

    double green;
    double blue;

    /** Whether only the indirect part of that is wanted ({@link PathPart#INDIRECT}). */
    public boolean isIndirect;

    /** Whether all light added from now on is indirect; and the indirect light that was added before. */
    private boolean onlyIndirect;

    private double indirectR;
    private double indirectG;
    private double indirectB;

    /** (n₀/n)²: radiance at the eye over radiance here, where n₀ and n are the indices of refraction there and here. */
    private double compression;

    private final double[] transmittance = new double[3];

    /** The index of refraction of the medium that the eye is in. */
    private double firstIndex;

    /** True until the first random decision of the path. */
    public boolean certain;

    /** Radiance gathered before the first random decision. */
    private double certainRed;

    private double certainGreen;
    private double certainBlue;

    /** The hash of the path at its first random decision. */
    private long certainKey;

    /** The throughput of the path up to its current vertex. */
    public final Throughput throughput = new Throughput();

    /** The matrix of bands of a path scattered by fluorescent surfaces; null if the scene has none. */
    private final BandMixing mixing;

    /** Whether a fluorescent surface has scattered the path. */
    private boolean mixes;

    private final double[] mixed = new double[3];

    /** Makes the value of paths in a scene without fluorescent surfaces. */
    public PathValue() {
        this(null);
    }

    /**
     * @param mixing owned by this path; null if there are no fluorescent surfaces
     */
    public PathValue(BandMixing mixing) {
        this.mixing = mixing;
    }

    /**
     * Begins a path at the eye.
     *
     * @param index of refraction of the medium that the eye is in
     */
    public void begin(double index) {
        beginPart();
        onlyIndirect = false;
        indirectR = 0;
        indirectG = 0;
        indirectB = 0;
        compression = 1;
        firstIndex = index;
        certain = true;
        certainRed = 0;
        certainGreen = 0;
        certainBlue = 0;
    }

    /** Sets what was gathered to 0 and the throughput to 1: from here on the value is relative to the current vertex. */
    public void beginPart() {
        mixes = false;
        red = 0;
        green = 0;
        blue = 0;
        throughput.begin(1, 1, 1, 1);
    }

    /** Adds radiance in the visible bands that leaves the current vertex towards the previous one. */
    public void add(double r, double g, double b) {
        add(r, g, b, 0);
    }

    /** Adds radiance, with ultraviolet, that leaves the current vertex towards the previous one. */
    public void add(double r, double g, double b, double ultraviolet) {
        if (mixes) {
            mix(r, g, b, ultraviolet);
            red += mixed[0];
            green += mixed[1];
            blue += mixed[2];
            return;
        }
        red = Math.fma(throughput.red * compression, r, red);
        green = Math.fma(throughput.green * compression, g, green);
        blue = Math.fma(throughput.blue * compression, b, blue);
    }

    /**
     * Adds emission of a surface, times its MIS weight. It counts as deterministic whatever the weight is, unless a texture varies it:
     * pixel corners that see the same surface then see different emission.
     *
     * @param key hash of the path up to here
     */
    public void addEmission(SurfaceInteraction at, double weight, long key) {
        at.findEmission();
        add(weight * at.emittedR, weight * at.emittedG, weight * at.emittedB, weight * at.emittedUltraviolet);
        if (at.material.radianceMap == null) {
            addCertain(at.emittedR, at.emittedG, at.emittedB, at.emittedUltraviolet);
        } else {
            leaveToChance(key);
        }
    }

    /** Writes the emission of a surface times throughput and compression: what {@link #addEmission} would add with weight 1. */
    public void getEmission(SurfaceInteraction at, double[] out) {
        at.findEmission();
        out[0] = throughput.red * compression * at.emittedR;
        out[1] = throughput.green * compression * at.emittedG;
        out[2] = throughput.blue * compression * at.emittedB;
    }

    /** Adds direct lighting at the current vertex: radiance towards the previous one. */
    public void add(GatheredLight light) {
        add(light.red, light.green, light.blue, light.ultraviolet);
    }

    /** Adds the reflection, at a Lambertian surface of this colour, of the direct lighting of a white one. */
    public void addReflected(GatheredLight light, double[] color) {
        add(color[0] * light.red, color[1] * light.green, color[2] * light.blue, color[2] * light.ultraviolet);
        if (certain) {
            addCertain(
                    color[0] * light.certainRed,
                    color[1] * light.certainGreen,
                    color[2] * light.certainBlue,
                    color[2] * light.certainUltraviolet);
        }
    }

    /** Transforms radiance of the current vertex to displayed bands at the eye, if a fluorescent surface has scattered the path. */
    private void mix(double r, double g, double b, double ultraviolet) {
        double x = throughput.red * compression * r;
        double y = throughput.green * compression * g;
        double z = throughput.blue * compression * b;
        double u = throughput.ultraviolet * compression * ultraviolet;
        for (int band = 0; band < mixed.length; band++) {
            mixed[band] = mixing.of(band, x, y, z, u);
        }
    }

    /** Adds radiance that counts as indirect although the path itself is still direct. */
    public void addIndirect(double r, double g, double b, double ultraviolet) {
        add(r, g, b, ultraviolet);
        if (!isIndirect || onlyIndirect) {
            return;
        }
        if (mixes) {
            indirectR += mixed[0];
            indirectG += mixed[1];
            indirectB += mixed[2];
            return;
        }
        indirectR = Math.fma(throughput.red * compression, r, indirectR);
        indirectG = Math.fma(throughput.green * compression, g, indirectG);
        indirectB = Math.fma(throughput.blue * compression, b, indirectB);
    }

    /**
     * Adds the radiance of the surroundings for a path that has left the scene.
     *
     * @param isEven whether the surroundings are constant: only then is it deterministic
     * @param key hash of the path up to here
     */
    public void addEscaped(GatheredLight light, boolean isEven, long key) {
        add(light.red, light.green, light.blue);
        if (isEven) {
            addCertain(light.red, light.green, light.blue, 0);
        } else {
            leaveToChance(key);
        }
    }

    /** Declares all light from here on to be indirect. */
    public void beginIndirect() {
        if (isIndirect && !onlyIndirect) {
            dropDirect();
            onlyIndirect = true;
        }
    }

    private void dropDirect() {
        red = indirectR;
        green = indirectG;
        blue = indirectB;
    }

    /** Adds to the deterministic part, if the path has made no random decision yet. */
    void addCertain(double r, double g, double b, double ultraviolet) {
        if (certain && mixes) {
            // Nothing has turned the path: light is what it is at the eye.
            mix(r, g, b, ultraviolet);
            certainRed += mixed[0];
            certainGreen += mixed[1];
            certainBlue += mixed[2];
        } else if (certain) {
            certainRed = Math.fma(throughput.red, r, certainRed);
            certainGreen = Math.fma(throughput.green, g, certainGreen);
            certainBlue = Math.fma(throughput.blue, b, certainBlue);
        }
    }

    /**
     * Marks the path's first random decision: the deterministic part is complete.
     *
     * @param key hash of the path up to here
     */
    public void leaveToChance(long key) {
        if (certain) {
            certain = false;
            certainKey = Hash.mix(key);
        }
    }

    /**
     * Writes the deterministic part of the radiance.
     *
     * @param key hash of the path up to here
     * @return the hash at the first random decision; the key if there was none
     */
    public long certain(double[] out, long key) {
        out[0] = certainRed;
        out[1] = certainGreen;
        out[2] = certainBlue;
        return certain ? key : certainKey;
    }

    /** Writes the gathered radiance, or its indirect part if only that is wanted. */
    public void get(double[] out) {
        if (isIndirect && !onlyIndirect) {
            dropDirect();
        }
        out[0] = red;
        out[1] = green;
        out[2] = blue;
    }

    /** Ends the path with a reflectance in place of radiance: throughput times this. Returns false, as the path does not go on. */
    public boolean endsWith(double[] rgb) {
        red = throughput.red * rgb[0];
        green = throughput.green * rgb[1];
        blue = throughput.blue * rgb[2];
        return false;
    }

    /**
     * Scatters the path at a fluorescent surface; its throughput goes on as at a grey one.
     *
     * @param surface its colour; receives the grey reflectance
     * @return whether the path goes on
     */
    public boolean scatter(Reradiation by, double[] surface) {
        beginMixing();
        // What roulette asks for stays what it was, but for the colour.
        double most = Math.max(throughput.red, Math.max(throughput.green, throughput.blue));
        if (!(most > 0)) {
            return false;
        }
        mixing.filter(throughput.red / most, throughput.green / most, throughput.blue / most);
        throughput.begin(most, most, most, most);
        Arrays.fill(surface, mixing.scatterAsGrey(by, surface));
        return surface[0] > 0;
    }

    /**
     * Scatters the path at a fluorescent surface; its throughput goes on as at a white one, and the matrix of bands takes the colour. See
     * {@link #scatter}, which goes on as at a grey one.
     */
    public void reradiate(Reradiation by, double[] color) {
        beginMixing();
        mixing.filter(throughput.red, throughput.green, throughput.blue);
        mixing.scatter(by, color);
        throughput.begin(1, 1, 1, 1);
    }

    private void beginMixing() {
        if (!mixes) {
            mixing.clear();
            mixes = true;
        }
    }

    /** Enters a medium with this index of refraction. */
    public void enter(double index) {
        compression = firstIndex * firstIndex / (index * index);
    }

    /** (n₀/n)²: radiance at the eye over radiance here, where n₀ and n are the indices of refraction there and here. */
    public double compression() {
        return compression;
    }

    /** Multiplies the throughput by the weight of an event. */
    public void filter(double r, double g, double b) {
        throughput.filter(r, g, b);
    }

    /** Multiplies the throughput by the weights of the path's wavelength, once it has become the only one. */
    public void disperse() {
        if (wavelength != null && wavelength.takesEffect()) {
            filter(wavelength.red, wavelength.green, wavelength.blue);
        }
    }

    /** Multiplies the throughput by the transmittance of a medium along a length, by the law of Beer and Lambert. */
    public void absorb(SurfaceMaterial medium, double length) {
        Arrays.fill(transmittance, 1);
        medium.absorb(length, transmittance);
        filter(transmittance[0], transmittance[1], transmittance[2]);
    }

    /** Whether the path continues after its last event without Russian roulette. */
    public boolean isSafe(PathState state) {
        return state.eventsForRoulette() < ROULETTE_FROM && throughput.most() >= FAINT;
    }

    /**
     * Plays Russian roulette by the weight of the last event, with which the throughput was filtered. The weight is the event's own albedo;
     * the whole throughput says little about the light to come.
     */
    public boolean survives(double r, double g, double b, Sampler sampler, PathState state) {
        return throughput.most() > 0 && survives(survival(r, g, b), sampler, state);
    }

    /** Plays Russian roulette after the last event, with this probability of survival, and divides the throughput by it. */
    public boolean survives(double survival, Sampler sampler, PathState state) {
        if (!(sampler.unit(state.events - 1, Sampler.Purpose.ROULETTE) < survival)) {
            return false;
        }
        throughput.scale(1 / survival);
        return true;
    }

    /** The probability of surviving Russian roulette after an event of this weight: its largest band, at most {@link #LARGEST_SURVIVAL}. */
    public static double survival(double r, double g, double b) {
        return Math.min(Math.max(r, Math.max(g, b)), LARGEST_SURVIVAL);
    }
}
