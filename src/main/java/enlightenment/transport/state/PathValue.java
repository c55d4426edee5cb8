package enlightenment.transport.state;

import enlightenment.bsdf.Reradiation;
import enlightenment.sampling.Hash;
import enlightenment.sampling.Sampler;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.surface.SurfaceInteraction;
import java.util.Arrays;

/**
 * What a path from the eye has gathered, and how much of what is still to come counts: its throughput. Of both, the part that is not left
 * to chance is told apart. Mutable, one per thread.
 */
public final class PathValue {
    /** From this scattering event on roulette may end a path. */
    public static final int ROULETTE_FROM = 5;

    /** Sooner, if less than this is left of a path's throughput. */
    public static final double FAINT = 0.05;

    /** Paths of a closed white room must end, too. */
    public static final double LARGEST_SURVIVAL = 0.99;

    /** The wavelength of the path; null if none matters. */
    public PathWavelength wavelength;

    /** What was gathered. */
    double red;

    double green;
    double blue;

    /** Whether only the indirect part of that is wanted ({@link PathPart#INDIRECT}). */
    public boolean isIndirect;

    /** Whether all that is added now is part of it; and what was before. */
    private boolean onlyIndirect;

    private double indirectR;
    private double indirectG;
    private double indirectB;

    /** Radiance at the eye per radiance here, where the index of refraction is another one. */
    private double compression;

    private final double[] transmittance = new double[3];

    /** The index of refraction of the medium that the eye is in. */
    private double firstIndex;

    /** True until the first random decision of the path. */
    public boolean certain;

    /** What was gathered until then. */
    private double certainRed;

    private double certainGreen;
    private double certainBlue;

    /** What the path came to until then. */
    private long certainKey;

    /** How much of what is still to come counts. */
    public final Throughput throughput = new Throughput();

    /** What fluorescent surfaces do with light; null if there are none. */
    private final BandMixing mixing;

    /** Whether the path has been scattered by one. */
    private boolean mixes;

    private final double[] mixed = new double[3];

    /** Of a path that meets no fluorescent surfaces. */
    public PathValue() {
        this(null);
    }

    /** @param mixing of this path alone; null if there are no fluorescent surfaces */
    public PathValue(BandMixing mixing) {
        this.mixing = mixing;
    }

    /** @param index of refraction of the medium that the eye is in */
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

    /** Forgets what was gathered, for what comes from here on to be worth what it is here. */
    public void beginPart() {
        mixes = false;
        red = 0;
        green = 0;
        blue = 0;
        throughput.begin(1, 1, 1, 1);
    }

    /** Adds visible radiance that leaves what the path is at towards where it came from. */
    public void add(double r, double g, double b) {
        add(r, g, b, 0);
    }

    /** Adds radiance, that of ultraviolet as well, that leaves what the path is at towards where it came from. */
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
     * Adds what a surface emits. All of it is certain, whatever the weight is, but for what a texture makes of it: between corners that
     * see the same surface that is not what they see.
     *
     * @param key what the path has come to, as a hash
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

    /** Writes what a surface's emission is worth, in place of {@link #addEmission}. */
    public void getEmission(SurfaceInteraction at, double[] out) {
        at.findEmission();
        out[0] = throughput.red * compression * at.emittedR;
        out[1] = throughput.green * compression * at.emittedG;
        out[2] = throughput.blue * compression * at.emittedB;
    }

    /** Adds the light that was gathered where the path is. */
    public void add(GatheredLight light) {
        add(light.red, light.green, light.blue, light.ultraviolet);
    }

    /** Adds what a Lambertian surface of this colour reflects of the light that was gathered there. */
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

    /** Finds what light brings to the eye, if fluorescent surfaces have scattered the path. */
    private void mix(double r, double g, double b, double ultraviolet) {
        double x = throughput.red * compression * r;
        double y = throughput.green * compression * g;
        double z = throughput.blue * compression * b;
        double u = throughput.ultraviolet * compression * ultraviolet;
        for (int band = 0; band < mixed.length; band++) {
            mixed[band] = mixing.of(band, x, y, z, u);
        }
    }

    /** Adds radiance that is indirect although the path is not yet. */
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
     * Adds what comes from where the path has left the scene.
     *
     * @param isEven whether it is the same everywhere: else it is left to chance
     */
    public void addEscaped(GatheredLight light, boolean isEven, long key) {
        add(light.red, light.green, light.blue);
        if (isEven) {
            addCertain(light.red, light.green, light.blue, 0);
        } else {
            leaveToChance(key);
        }
    }

    /** From here on the path is indirect. */
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

    /** Notes the part of what is added that no random number has a part in. */
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
     * From here on random numbers have a part in the path.
     *
     * @param key what it came to until now, as a hash
     */
    public void leaveToChance(long key) {
        if (certain) {
            certain = false;
            certainKey = Hash.mix(key);
        }
    }

    /**
     * Writes the part that is not left to chance.
     *
     * @param key what the path has come to now, as a hash
     * @return what it had come to when chance began; the key if all is certain
     */
    public long certain(double[] out, long key) {
        out[0] = certainRed;
        out[1] = certainGreen;
        out[2] = certainBlue;
        return certain ? key : certainKey;
    }

    /** Writes what was gathered. */
    public void get(double[] out) {
        if (isIndirect && !onlyIndirect) {
            dropDirect();
        }
        out[0] = red;
        out[1] = green;
        out[2] = blue;
    }

    /** Makes the path worth the share of light that its last surface reflects, in place of light; returns that it does not go on. */
    public boolean endsWith(double[] rgb) {
        red = throughput.red * rgb[0];
        green = throughput.green * rgb[1];
        blue = throughput.blue * rgb[2];
        return false;
    }

    /**
     * The path is scattered by a fluorescent surface, and goes on as from a grey one.
     *
     * @param surface its colour; receives the reflectance of that
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

    /** The same, but that the path goes on as from a white surface, with this colour in what mixes bands. */
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

    /** The path is in a medium with this index of refraction now. */
    public void enter(double index) {
        compression = firstIndex * firstIndex / (index * index);
    }

    /** Radiance at the eye per radiance here, where the index of refraction is another one. */
    public double compression() {
        return compression;
    }

    /** Multiplies the throughput. */
    public void filter(double r, double g, double b) {
        throughput.filter(r, g, b);
    }

    /** Takes note of it where the path's wavelength has become the only one. */
    public void disperse() {
        if (wavelength != null && wavelength.takesEffect()) {
            filter(wavelength.red, wavelength.green, wavelength.blue);
        }
    }

    /** The same by Beer and Lambert's law, on the way to what the path has come to. */
    public void absorb(SurfaceMaterial medium, double length) {
        Arrays.fill(transmittance, 1);
        medium.absorb(length, transmittance);
        filter(transmittance[0], transmittance[1], transmittance[2]);
    }

    /** Whether the path goes on from its last event without roulette. */
    public boolean isSafe(PathState state) {
        return state.events < ROULETTE_FROM && throughput.most() >= FAINT;
    }

    /**
     * Plays roulette by the weight of the last event, which was filtered by: by the event's own albedo, since what is left of the path's
     * throughput says little of what is to come.
     */
    public boolean survives(double r, double g, double b, Sampler sampler, PathState state) {
        return throughput.most() > 0 && survives(survival(r, g, b), sampler, state);
    }

    /** Plays roulette after the last event with a probability of survival. */
    public boolean survives(double survival, Sampler sampler, PathState state) {
        if (!(sampler.unit(state.events - 1, Sampler.Purpose.ROULETTE) < survival)) {
            return false;
        }
        throughput.scale(1 / survival);
        return true;
    }

    /** The probability of surviving an event of this weight. */
    public static double survival(double r, double g, double b) {
        return Math.min(Math.max(r, Math.max(g, b)), LARGEST_SURVIVAL);
    }
}
