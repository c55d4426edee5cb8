package enlightenment.surroundings;

import enlightenment.codec.RasterFiles;
import enlightenment.color.Rgb;
import enlightenment.math.Vec3;
import enlightenment.numeric.Angles;
import enlightenment.numeric.Scale;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Light that comes from infinity, from each direction another: a picture of all directions, a sky with its sun, or one radiance, and the
 * disks of distant lights. The vertical is the y axis; a turn of 0 around it is the direction of the z axis, a quarter that of the x axis. Immutable.
 */
public final class Surroundings {
    /** The size of the picture that a sky becomes: bilinear interpolation is off by less than a thousandth of the radiance. */
    private static final int SKY_WIDTH = 512;

    private static final int SKY_HEIGHT = 256;

    /** The six directions along the axes. */
    private static final int AXES = 6;

    private static final int POINTS = 4096;

    /** The disks of the sun and of distant lights. They are no part of {@link #radiance}; where they overlap their radiances add up. */
    public final List<Sun> suns;

    private final double powerOfSuns;

    private final DirectionMap map;
    private final DirectionTable table;

    /** In turns: what the picture's middle is turned by. */
    private final double rotation;

    /** About how much light falls on surfaces that face along an axis: x, y, z, each up and down. */
    private final double[] irradiance;

    /**
     * How the texels of a picture become radiance.
     *
     * @param areLight whether whole numbers are proportional to light, rather than display-referred; floats always are
     * @param areNearest whether a direction has the radiance of the texel that it falls into, rather than what is bilinear between the
     *     centres of four
     */
    public record Texels(boolean areLight, boolean areNearest) {}

    private Surroundings(DirectionMap map, double degrees, Sun sun) throws IOException {
        this.map = map;
        suns = sun == null ? List.of() : List.of(sun);
        powerOfSuns = power(suns);
        rotation = degrees / 360 - Math.floor(degrees / 360);
        table = new DirectionTable(map);
        irradiance = new double[AXES];
        estimateIrradiance();
    }

    private Surroundings(Surroundings other, List<Sun> suns) {
        map = other.map;
        this.suns = List.copyOf(suns);
        powerOfSuns = power(suns);
        rotation = other.rotation;
        table = other.table;
        irradiance = other.irradiance;
    }

    private static double power(List<Sun> suns) {
        double sum = 0;
        for (Sun sun : suns) {
            sum += sun.power();
        }
        return sum;
    }

    /**
     * A picture of all directions, longitude by latitude: its upper edge is the direction of the y axis, its middle that of the z axis,
     * and to the right of it is that of the x axis.
     *
     * @param file the bytes of a picture file of any kind that can be read
     * @param scale by which its light is multiplied, by band
     * @param degrees by which it is turned around the y axis: the picture's middle is seen in this direction then, counted from the z
     *     axis to the x axis
     * @param texels what its numbers mean
     * @throws IOException with the reason, if it cannot be read or one of its numbers is no radiance
     * @throws enlightenment.math.InvalidValueException (key {@code radiance}) if what it is multiplied by is too much
     */
    public static Surroundings of(byte[] file, Rgb scale, double degrees, Texels texels) throws IOException {
        return new Surroundings(DirectionMap.of(RasterFiles.decode(file), scale, texels), degrees, null);
    }

    /**
     * As {@link #of}, of a file on the disk.
     *
     * @throws IOException with a message that names the file and the reason
     */
    public static Surroundings read(Path file, Rgb scale, double degrees, Texels texels) throws IOException {
        return RasterFiles.read(file, bytes -> of(bytes, scale, degrees, texels));
    }

    /**
     * A clear sky ({@link Daylight}). Below the horizon the ground of a plain is seen, matte and lit by sky and sun.
     *
     * @param elevation of the sun above the horizon, in degrees: 0..90
     * @param azimuth of the sun, in degrees, from the z axis to the x axis
     * @param turbidity how hazy the air is, as for {@link Daylight}
     * @param ground what the ground reflects
     * @param hasSun whether the sun's disk shines
     * @param scale by which all light is multiplied, by band
     * @throws enlightenment.math.InvalidValueException (key {@code radiance}) if that is too much
     */
    public static Surroundings sky(
            double elevation, double azimuth, double turbidity, Rgb ground, boolean hasSun, Rgb scale) {
        Daylight daylight = new Daylight(elevation, turbidity);
        double height = StrictMath.toRadians(elevation);
        double turn = StrictMath.toRadians(azimuth);
        double level = StrictMath.cos(height);
        Vec3 direction = new Vec3(level * StrictMath.sin(turn), StrictMath.sin(height), level * StrictMath.cos(turn));
        Sun sun =
                hasSun ? new Sun(direction, Daylight.SUN_RADIUS, daylight.sun().times(scale)) : null;
        return of(() -> skyMap(daylight, height, ground, sun, scale), azimuth, sun);
    }

    /** Constant radiance in all directions, up to the rounding to floats. */
    public static Surroundings constant(Rgb radiance) {
        double unit = radiance.max() == 0 ? 1 : Math.scalb(1.0, Scale.exponent(radiance.max()));
        float[] rgb = {(float) (radiance.r() / unit), (float) (radiance.g() / unit), (float) (radiance.b() / unit)};
        return of(() -> new DirectionMap(1, 1, false, true, rgb, unit, Rgb.BLACK), 0, null);
    }

    /** These with more disks, after those there are. */
    public Surroundings with(List<Sun> more) {
        List<Sun> all = new ArrayList<>(suns);
        all.addAll(more);
        return new Surroundings(this, all);
    }

    /** A map that is computed, not read. */
    @FunctionalInterface
    private interface ComputedMap {
        DirectionMap get() throws IOException;
    }

    private static Surroundings of(ComputedMap map, double degrees, Sun sun) {
        try {
            return new Surroundings(map.get(), degrees, sun);
        } catch (IOException e) {
            // Its numbers are right, so that it is memory that it lacks.
            throw new OutOfMemoryError(e.getMessage());
        }
    }

    private static DirectionMap skyMap(Daylight daylight, double height, Rgb ground, Sun sun, Rgb scale) {
        float[] rgb = new float[3 * SKY_WIDTH * SKY_HEIGHT];
        double unit = DirectionMap.unit(scale);
        double[] factor = {scale.r() / unit, scale.g() / unit, scale.b() / unit};
        double[] falls = new double[3];
        double[] color = new double[3];
        double step = Math.PI / 2 / SKY_HEIGHT;
        for (int row = 0; row < SKY_HEIGHT; row++) {
            double angle = (row + 0.5) * step;
            double sine = StrictMath.sin(angle);
            double cosine = StrictMath.cos(angle);
            // The integral of the cosine over the texel's solid angle.
            double weight = (StrictMath.cos(2 * row * step) - StrictMath.cos(2 * (row + 1) * step))
                    / 4
                    * (2 * Math.PI / SKY_WIDTH);
            for (int x = 0; x < SKY_WIDTH / 2; x++) {
                double turn = (x + 0.5) / SKY_WIDTH * 2 * Math.PI - Math.PI;
                double cosineGamma =
                        cosine * StrictMath.sin(height) + sine * StrictMath.cos(height) * StrictMath.cos(turn);
                daylight.sky(cosine, cosineGamma, color);
                for (int c = 0; c < 3; c++) {
                    float value = DirectionMap.radiance(color[c], factor[c], "sky");
                    rgb[3 * (row * SKY_WIDTH + x) + c] = value;
                    rgb[3 * (row * SKY_WIDTH + SKY_WIDTH - 1 - x) + c] = value;
                    falls[c] += 2 * weight * unit * value;
                }
            }
        }
        double direct = sun == null ? 0 : Math.max(sun.irradiance(sun.y), 0);
        Rgb below = new Rgb(
                ground.r() / Math.PI * (falls[0] + (sun == null ? 0 : direct * sun.r)),
                ground.g() / Math.PI * (falls[1] + (sun == null ? 0 : direct * sun.g)),
                ground.b() / Math.PI * (falls[2] + (sun == null ? 0 : direct * sun.b)));
        return new DirectionMap(SKY_WIDTH, SKY_HEIGHT, true, false, rgb, unit, below);
    }

    /** Sums over directions that are chosen as paths choose them, by Hammersley's points. */
    private void estimateIrradiance() {
        double[] direction = new double[3];
        double[] rgb = new double[3];
        for (int i = 0; i < POINTS && !isBlack(); i++) {
            double u = Math.scalb((double) (Integer.reverse(i) & 0xffffffffL), -Integer.SIZE);
            double density = sample(u, (i + 0.5) / POINTS, direction);
            radiance(direction[0], direction[1], direction[2], rgb);
            double weight = (rgb[0] + rgb[1] + rgb[2]) / (density * POINTS);
            for (int axis = 0; axis < AXES; axis++) {
                double cosine = (axis & 1) == 0 ? direction[axis / 2] : -direction[axis / 2];
                irradiance[axis] += weight * Math.max(cosine, 0);
            }
        }
    }

    /**
     * These surroundings with their radiance multiplied by a share.
     *
     * @param share the factor, by band
     */
    public Surroundings filtered(Rgb share) {
        return of(() -> map.filtered(share), 360 * rotation, null)
                .with(suns.stream().map(sun -> sun.filtered(share)).toList());
    }

    /** Whether nothing comes from anywhere, but for the suns. */
    public boolean isBlack() {
        return table.isBlack();
    }

    /** The integral of radiance over all directions, in W/m² (relative), sum of the bands, the suns included. */
    public double power() {
        return table.total + powerOfSuns;
    }

    /** The share of {@link #power} that comes from one of the {@link #suns}. */
    public double share(Sun sun) {
        return power() > 0 ? sun.power() / power() : 0;
    }

    /**
     * Looks up the radiance that comes from where a unit vector leads to, without the suns.
     *
     * @param rgb receives it, by band
     */
    public void radiance(double dx, double dy, double dz, double[] rgb) {
        map.radiance(turn(dx, dz), angle(dx, dy, dz), dy < 0, rgb);
    }

    /** As {@link #radiance}, with the suns. */
    public void all(double dx, double dy, double dz, double[] rgb) {
        radiance(dx, dy, dz, rgb);
        for (Sun sun : suns) {
            if (sun.contains(dx, dy, dz)) {
                rgb[0] += sun.r;
                rgb[1] += sun.g;
                rgb[2] += sun.b;
            }
        }
    }

    /** The density per solid angle with which {@link #sample} chooses a unit vector: greater than 0 wherever the radiance is. */
    public double density(double dx, double dy, double dz) {
        return table.density(turn(dx, dz), angle(dx, dy, dz), dy < 0);
    }

    /**
     * Samples a direction approximately proportionally to radiance (sum of the bands), without the suns. Not if {@link #isBlack}.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1), independent of u
     * @param out receives the unit vector towards where the light comes from
     * @return the density per solid angle, greater than 0
     */
    public double sample(double u, double v, double[] out) {
        double density = table.sample(u, v, out);
        double y = out[1];
        double angle = 2 * Math.PI * (out[0] - 0.5 + rotation);
        double level = Math.sqrt(Math.max((1 - y) * (1 + y), 0));
        out[0] = level * StrictMath.sin(angle);
        out[2] = level * StrictMath.cos(angle);
        return density;
    }

    private static double angle(double dx, double dy, double dz) {
        return Angles.atan2(Math.sqrt(dx * dx + dz * dz), dy);
    }

    private double turn(double dx, double dz) {
        double turn = Angles.atan2(dx, dz) / (2 * Math.PI) + 0.5 - rotation;
        return Math.min(turn - Math.floor(turn), Math.nextDown(1.0));
    }

    /**
     * About how much light falls on a surface if nothing hides any, without the suns: the sum of all bands. Greater than 0 wherever any may
     * fall.
     *
     * @param nx its unit normal; (0, 0, 0) for a surface that takes light from both sides
     */
    public double irradiance(double nx, double ny, double nz) {
        double along = nx * nx * irradiance[nx > 0 ? 0 : 1]
                + ny * ny * irradiance[ny > 0 ? 2 : 3]
                + nz * nz * irradiance[nz > 0 ? 4 : 5];
        return along + table.total / 16;
    }
}
