package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.ChanceLights;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.HomogeneousMedium;
import enlightenment.compiled.PhysicalLight;
import enlightenment.compiled.RayCounters;
import enlightenment.compiled.SurfaceMaterial;
import enlightenment.primitive.Hit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Light that mirrors and smooth glass send into media behind borders that refract, where paths from the eye find it by chance only: as
 * beams, by some paths of light (W. Jarosz and others, "A comprehensive theory of volumetric radiance estimation using photon points and
 * beams", 2011). Each spreads its power over a disk of the border's tangent plane that is about as large as the beams there are apart,
 * and is dimmed on its way: so what is told does not depend on how thin a layer the light comes to. Good enough to tell how much of a
 * picture is left to chance, not for the picture.
 */
final class MediumBeams extends LightWalker {
    /** These paths are no part of any picture, and the same for all of a scene. */
    private static final long SEED = 0x6265616d73L;

    private static final int PATHS = 1 << 12;

    /** Fewer paths are enough where each is reflected to and fro in a clear medium. */
    private static final int MOST = 1 << 14;

    /** Of light that is found by chance: its lamps by the share of a hemisphere that they are seen under, in classes of this factor. */
    private static final double CLASS = 8;

    /** Lamps larger than this share of a hemisphere are found by enough paths; smaller ones by the 64th, the 512th, .. part of that. */
    private static final double LARGE = 1.0 / 64;

    /** The groups: light of points, the sun's, and that of lamps, the smallest first. */
    static final int POINTS = 0;

    static final int SUN = 1;
    private static final int LAMPS = 2;
    private static final int CLASSES = 5;
    static final int GROUPS = LAMPS + CLASSES;

    private final List<MediumBeam> found = new ArrayList<>();
    private final double[] start = new double[3];
    private final BeamTree tree;

    /** By group: light of the places looked at by band, times throughput; and how many paths find it. */
    final double[][] light = new double[GROUPS][3];

    final double[] chance = new double[GROUPS];

    /** The same of what paths from both ends leave apart: they meet nowhere between these places and the eye. */
    final double[][] lightApart = new double[GROUPS][3];

    final double[] chanceApart = new double[GROUPS];

    private MediumBeams(CompiledScene scene, BooleanSupplier cancelled) {
        super(
                scene,
                new CausticSource(scene.physical.caustics),
                true,
                SEED,
                1,
                1,
                new RayCounters(scene.kindNames.size()));
        stopWhen(cancelled);
        int paths = 0;
        while (paths < PATHS && found.size() < MOST) {
            follow(paths++);
        }
        tree = found.isEmpty() ? null : new BeamTree(found, paths);
    }

    /**
     * Those of a scene with a pass of caustics; null if there are none.
     *
     * @param cancelled asked now and then
     * @throws java.util.concurrent.CancellationException soon after that has become true
     */
    static MediumBeams of(CompiledScene scene, BooleanSupplier cancelled) {
        MediumBeams all = new MediumBeams(scene, cancelled);
        return all.tree == null ? null : all;
    }

    /** Forgets what was found. */
    void forget() {
        for (int group = 0; group < GROUPS; group++) {
            Arrays.fill(light[group], 0);
            Arrays.fill(lightApart[group], 0);
        }
        Arrays.fill(chance, 0);
        Arrays.fill(chanceApart, 0);
    }

    /** What a group is of. */
    static ChanceLights.Kind kind(int group) {
        return group == POINTS
                ? ChanceLights.Kind.POINTS_IN_MEDIA
                : group == SUN ? ChanceLights.Kind.SUN_IN_MEDIA : ChanceLights.Kind.LAMPS_IN_MEDIA;
    }

    @Override
    boolean arrive(Bsdf bsdf, Scattering s) {
        return false;
    }

    /** Of what narrow lobes send into media, samples tell. */
    @Override
    boolean takesNarrow() {
        return false;
    }

    @Override
    boolean isScatteredIn(SurfaceMaterial in) {
        return false;
    }

    @Override
    PathFollower.Event pass(SurfaceMaterial in) {
        if (in == null || in.medium == null || in.indexOfRefraction == 1 || !caustic.counts()) {
            return path.next(ray);
        }
        Hit at = path.hit;
        start[0] = at.px;
        start[1] = at.py;
        start[2] = at.pz;
        int group = group();
        MediumBeam beam = group < 0 ? null : beam(in.medium, group);
        PathFollower.Event event = path.next(ray);
        if (beam != null && event != PathFollower.Event.NOTHING) {
            beam.length = path.distance(ray);
            found.add(beam);
        }
        return event;
    }

    private MediumBeam beam(HomogeneousMedium medium, int group) {
        double scale = 1 / Math.sqrt(ray.dd);
        Hit at = path.hit;
        MediumBeam beam = new MediumBeam(medium, group, start, ray.dx * scale, ray.dy * scale, ray.dz * scale);
        beam.leaves(at.nx, at.ny, at.nz);
        beam.carries(
                carried.red, carried.green, carried.blue, physical.caustics.radiance(source.light), path.bounces());
        return beam.isUsable(Math.max(source.red, Math.max(source.green, source.blue))) ? beam : null;
    }

    /** The group of the light that the path began at, as it is seen from here. */
    private int group() {
        PhysicalLight[] lights = physical.caustics.lights;
        if (source.light == lights.length) {
            return SUN;
        }
        return group(lights[source.light], start[0], start[1], start[2]);
    }

    /** The group of a light as it is seen from a point; -1 if so many paths find it that pictures tell. */
    static int group(PhysicalLight l, double px, double py, double pz) {
        if (l.isPoint) {
            return POINTS;
        }
        double x = px - l.ballX;
        double y = py - l.ballY;
        double z = pz - l.ballZ;
        double share = l.ballRadius * l.ballRadius / (2 * (x * x + y * y + z * z));
        if (!(share < LARGE)) {
            return -1;
        }
        int group = GROUPS - 1;
        for (double least = LARGE / CLASS; share < least && group > LAMPS; least /= CLASS) {
            group--;
        }
        return group;
    }

    /**
     * Finds what a path from the eye leaves to chance where a medium scatters it.
     *
     * @param weight how many such places this one stands for
     * @param bounces how many events the path had before
     * @param isApart whether paths from both ends could not have met there or before
     */
    void look(
            HomogeneousMedium medium,
            Scattering s,
            Hit at,
            PathValue value,
            double weight,
            int bounces,
            boolean isApart) {
        tree.at(at.px, at.py, at.pz, beam -> {
            double deep = beam.depth(at.px, at.py, at.pz);
            if (deep >= 0 && beam.medium == medium && beam.bounces + bounces < physical.maxBounces) {
                add(beam, deep, s, value, weight, isApart);
            }
        });
    }

    private void add(MediumBeam beam, double deep, Scattering s, PathValue value, double weight, boolean isApart) {
        s.ix = -beam.dx;
        s.iy = -beam.dy;
        s.iz = -beam.dz;
        double scale = beam.medium.phase.pdf(s) * beam.spread() * value.compression() * weight;
        double r = value.throughputR * beam.red * scale * StrictMath.exp(-beam.medium.extinctionR * deep);
        double g = value.throughputG * beam.green * scale * StrictMath.exp(-beam.medium.extinctionG * deep);
        double b = value.throughputB * beam.blue * scale * StrictMath.exp(-beam.medium.extinctionB * deep);
        double most = Math.max(r, Math.max(g, b));
        if (!(most > 0 && most < Double.POSITIVE_INFINITY)) {
            return;
        }
        double each = Math.max(value.throughputR, Math.max(value.throughputG, value.throughputB)) * beam.radiance;
        double found = each > 0 ? most / each : 0;
        add(light[beam.group], r, g, b);
        chance[beam.group] += found;
        if (isApart) {
            add(lightApart[beam.group], r, g, b);
            chanceApart[beam.group] += found;
        }
    }

    private static void add(double[] sum, double r, double g, double b) {
        sum[0] += r;
        sum[1] += g;
        sum[2] += b;
    }
}
