package enlightenment.shading;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.MirrorBalls;
import enlightenment.compiled.RayCounters;
import enlightenment.numeric.MedianCut;
import enlightenment.primitive.Hit;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Where some paths of light come to the first surface over mirrors and smooth glass, in groups by place: a k-d tree (J. L. Bentley 1975).
 * The power of a group over its area tells about how bright caustics are there (H. W. Jensen, "Global illumination using photon maps",
 * 1996): good enough to tell how much of a picture is left to chance, not for the picture.
 */
final class CausticArrivals extends LightWalker {
    /** These paths are no part of any picture, and the same for all of a scene. */
    private static final long SEED = 0x6172726976616c73L;

    private static final int PATHS = 1 << 14;

    /** A group has at most so many arrivals, and more than half as many. */
    private static final int GROUP = 16;

    /**
     * Coordinates of the place, direction towards where the light came from, its power by band, and the radiance of what paths from the eye
     * find it by.
     */
    private static final int NUMBERS = 10;

    /** After them, 1 if a narrow lobe was the first to scatter the light, else 0. */
    private static final int NARROW = NUMBERS;

    /** So many tell how bright it is at a place, the last of them how large the place is. */
    private static final int NEAREST = 9;

    private final List<double[]> found = new ArrayList<>();
    private double[][] arrivals;
    private int levels;

    /** By inner node, the root first and its halves at 2 i + 1 and 2 i + 2: the axis across which it is cut, and where. */
    private int[] axes;

    private double[] cuts;

    /** By group: its first arrival. */
    private int[] first;

    /** Those nearest to the last place, with the squares of their distances, in order. */
    private final double[][] near = new double[NEAREST][];

    private final double[] distance = new double[NEAREST];
    private int count;

    /** What the last place has of such light: radiance by band that is reflected, times throughput; and how many directions find it. */
    final double[] light = new double[3];

    double chance;

    private boolean onlyNarrow;

    private CausticArrivals(CompiledScene scene) {
        super(
                scene,
                new CausticSource(scene.physical.caustics),
                true,
                SEED,
                1,
                1,
                new RayCounters(scene.kindNames.size()));
        balls = scene.mirrorBalls;
    }

    private final MirrorBalls balls;

    /**
     * Those of a scene with a pass of caustics; null if no light comes to surfaces so, but what is found by other ways.
     *
     * @param cancelled asked now and then
     * @throws java.util.concurrent.CancellationException soon after that has become true
     */
    static CausticArrivals of(CompiledScene scene, BooleanSupplier cancelled) {
        CausticArrivals all = new CausticArrivals(scene);
        all.stopWhen(cancelled);
        for (int k = 0; k < PATHS; k++) {
            all.follow(k);
        }
        if (all.found.isEmpty()) {
            return null;
        }
        all.build();
        return all;
    }

    @Override
    boolean arrive(Bsdf bsdf, Scattering s) {
        double radiance = caustic.radianceFound();
        if (radiance > 0 && !isSought()) {
            Hit at = path.hit;
            found.add(new double[] {
                at.px,
                at.py,
                at.pz,
                s.ox,
                s.oy,
                s.oz,
                carried.red,
                carried.green,
                carried.blue,
                radiance,
                caustic.isNarrow() ? 1 : 0
            });
        }
        return false;
    }

    /** Whether {@link MirrorCaustics} finds the light. */
    private boolean isSought() {
        if (balls == null || path.surfaces != 2) {
            return false;
        }
        for (int k = 0; k < balls.pairs(); k++) {
            if (balls.mirror[k] == ray.start && balls.light[k] == source.light) {
                return true;
            }
        }
        return false;
    }

    private void build() {
        arrivals = found.toArray(new double[0][]);
        while (arrivals.length > (long) GROUP << levels) {
            levels++;
        }
        axes = new int[(1 << levels) - 1];
        cuts = new double[axes.length];
        first = new int[(1 << levels) + 1];
        first[1 << levels] = arrivals.length;
        cut(0, 0, arrivals.length);
    }

    /** Cuts a node across its longest side in two halves with as many arrivals each. */
    private void cut(int node, int from, int to) {
        if (node >= axes.length) {
            first[node - axes.length] = from;
            return;
        }
        int axis = MedianCut.longestSide(from, to, (k, side) -> arrivals[k][side]);
        Arrays.sort(arrivals, from, to, (a, b) -> Double.compare(a[axis], b[axis]));
        int middle = from + (to - from) / 2;
        axes[node] = axis;
        cuts[node] = arrivals[middle][axis];
        cut(2 * node + 1, from, middle);
        cut(2 * node + 2, middle, to);
    }

    /**
     * Finds what a path from the eye that is at a surface leaves to chance there.
     *
     * @param s the surface, with its colour
     * @param narrowOnly whether only light counts that a narrow lobe was the first to scatter
     */
    void look(Bsdf bsdf, Scattering s, Hit at, PathValue value, boolean narrowOnly) {
        onlyNarrow = narrowOnly;
        Arrays.fill(light, 0);
        chance = 0;
        count = 0;
        search(0, at, s);
        if (count < NEAREST) {
            return;
        }
        // The farthest only tells how far the others may be.
        double scale = 1 / (PATHS * Math.PI * distance[NEAREST - 1]);
        for (int k = 0; k < NEAREST - 1 && scale < Double.POSITIVE_INFINITY; k++) {
            add(bsdf, s, near[k], value, scale);
        }
    }

    /** Finds the nearest arrivals that came to this side of the surface: on the near side of each cut first. */
    private void search(int node, Hit at, Scattering s) {
        if (node >= axes.length) {
            int group = node - axes.length;
            for (int k = first[group]; k < first[group + 1]; k++) {
                insert(arrivals[k], at, s);
            }
            return;
        }
        double place = axes[node] == 0 ? at.px : axes[node] == 1 ? at.py : at.pz;
        double beyond = place - cuts[node];
        int side = beyond < 0 ? 1 : 2;
        search(2 * node + side, at, s);
        if (count < NEAREST || beyond * beyond < distance[count - 1]) {
            search(2 * node + 3 - side, at, s);
        }
    }

    private void insert(double[] arrival, Hit at, Scattering s) {
        double x = arrival[0] - at.px;
        double y = arrival[1] - at.py;
        double z = arrival[2] - at.pz;
        double far = x * x + y * y + z * z;
        boolean isBehind = !(arrival[3] * s.nx + arrival[4] * s.ny + arrival[5] * s.nz > 0);
        boolean isOther = onlyNarrow && arrival[NARROW] == 0;
        if (isOther || isBehind || count == NEAREST && far >= distance[count - 1]) {
            return;
        }
        int place = count < NEAREST ? count++ : count - 1;
        while (place > 0 && distance[place - 1] > far) {
            distance[place] = distance[place - 1];
            near[place] = near[place - 1];
            place--;
        }
        distance[place] = far;
        near[place] = arrival;
    }

    private void add(Bsdf bsdf, Scattering s, double[] arrival, PathValue value, double scale) {
        s.ix = arrival[3];
        s.iy = arrival[4];
        s.iz = arrival[5];
        double cosine = s.ix * s.nx + s.iy * s.ny + s.iz * s.nz;
        bsdf.evaluate(s);
        if (!(cosine > 0 && s.pdf > 0)) {
            return;
        }
        double r = value.throughputR * s.valueR;
        double g = value.throughputG * s.valueG;
        double b = value.throughputB * s.valueB;
        double most = Math.max(r * arrival[6], Math.max(g * arrival[7], b * arrival[8])) / cosine * scale;
        double found = Math.max(r, Math.max(g, b)) / s.pdf * arrival[NUMBERS - 1];
        if (found > 0 && most > 0) {
            light[0] += r * arrival[6] / cosine * scale;
            light[1] += g * arrival[7] / cosine * scale;
            light[2] += b * arrival[8] / cosine * scale;
            chance += most / found;
        }
    }
}
