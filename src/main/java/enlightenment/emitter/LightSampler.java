package enlightenment.emitter;

import enlightenment.math.Vec3;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Samples one of a scene's lights for a receiver: up to {@link #FEW} lights proportionally to estimates of their unoccluded contribution,
 * more of them by a {@link LightTree}. A light that can contribute has a probability above 0; the choice does not depend on the order in
 * which lights are given. Immutable, shared by threads. See docs/notes/light-sampling.md.
 */
public final class LightSampler {
    /** Up to this number of lights, each is weighed for every receiver. */
    static final int FEW = 16;

    private final int count;

    /** From canonical places to the caller's indices, and the inverse. */
    private final int[] indices;

    private final int[] places;
    private final LightWeights weights;
    private final LightTree tree;

    private LightSampler(List<Entry> entries, Runnable poll) {
        count = entries.size();
        indices = canonicalOrder(entries);
        places = new int[count];
        weights = new LightWeights(count);
        LightNode[] leaves = new LightNode[count];
        for (int place = 0; place < count; place++) {
            places[indices[place]] = place;
            Entry e = entries.get(indices[place]);
            if (e.light == null) {
                weights.setPoint(place, e.position, e.profile, e.strength);
            } else {
                weights.set(place, e.light, e.strength);
            }
            leaves[place] = weights.leaf(place);
        }
        tree = count > FEW ? new LightTree(LightTreeBuilder.build(leaves, poll), count, weights) : null;
    }

    /** The number of lights. */
    public int count() {
        return count;
    }

    /**
     * Samples a light for the receiver (x, y, z).
     *
     * @param nx the receiver's unit normal, on the side that light is received from; (0, 0, 0) if it receives light from all sides, as
     *     glass
     * @param number uniform in 0..1
     */
    public void choose(
            double x, double y, double z, double nx, double ny, double nz, double number, SampledLight choice) {
        if (count == 0) {
            choice.none(number);
            return;
        }
        if (tree != null) {
            tree.choose(x, y, z, nx, ny, nz, number, choice);
            choice.light = choice.light < 0 ? -1 : indices[choice.light];
            return;
        }
        double sum = weigh(x, y, z, nx, ny, nz, choice);
        choice.count = count;
        int chosen = choice.pick(sum, number);
        choice.light = chosen < 0 ? -1 : indices[chosen];
    }

    private double weigh(double x, double y, double z, double nx, double ny, double nz, SampledLight into) {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double w = weights.weight(i, x, y, z, nx, ny, nz, into.near);
            into.weights[i] = w;
            sum += w;
        }
        return sum;
    }

    /** The sampler for code on another device. */
    public FlatSampler flatForm() {
        return new FlatSampler(indices, places, weights.kinds(), weights.data(), tree == null ? null : tree.flatForm());
    }

    /**
     * The discrete probability, 0..1, with which {@link #choose} samples a light for this receiver, up to rounding.
     *
     * @param light the light's index in the order in which lights were added
     * @param nx as for {@link #choose}
     * @param scratch is overwritten
     */
    public double probability(
            int light, double x, double y, double z, double nx, double ny, double nz, SampledLight scratch) {
        int place = places[light];
        if (tree != null) {
            return tree.probability(place, x, y, z, nx, ny, nz, scratch);
        }
        double sum = weigh(x, y, z, nx, ny, nz, scratch);
        return sum > 0 ? scratch.weights[place] / sum : 0;
    }

    /** The places of lights, sorted by their parameters: lights that compare as equal are equal. */
    private static int[] canonicalOrder(List<Entry> entries) {
        return java.util.stream.IntStream.range(0, entries.size())
                .boxed()
                .sorted((i, k) -> entries.get(i).compareTo(entries.get(k)))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private record Entry(
            String kind, AreaLight light, Vec3 position, IntensityProfile profile, double strength, double[] key)
            implements Comparable<Entry> {
        Entry(AreaLight light, Vec3 position, IntensityProfile profile, double strength, double[] key) {
            this(kind(light == null ? profile : light), light, position, profile, strength, key);
        }

        private static String kind(Object form) {
            return form == null ? "" : form.getClass().getSimpleName();
        }

        @Override
        public int compareTo(Entry o) {
            int byKind = kind.compareTo(o.kind);
            int byShape = byKind != 0 ? byKind : Arrays.compare(key, o.key);
            return byShape != 0 ? byShape : Double.compare(strength, o.strength);
        }
    }

    /** Collects lights; the n-th one added has the index n − 1. */
    public static final class Builder {
        private final List<Entry> entries = new ArrayList<>();

        /** Makes a builder without lights. */
        public Builder() {}

        /**
         * Adds a light with extent.
         *
         * @param luminance of its radiance, above 0, in a unit that all lights share
         */
        public Builder add(AreaLight light, double luminance) {
            entries.add(new Entry(light, light.ballCenter(), null, luminance, light.parameters()));
            return this;
        }

        /**
         * Adds a point light that emits in all directions.
         *
         * @param luminance of its radiant intensity, in the unit of the other lights' radiance times the square of the unit of length
         */
        public Builder addPoint(Vec3 position, double luminance) {
            return addPoint(position, null, luminance);
        }

        /**
         * Adds a point light.
         *
         * @param profile by which its intensity depends on direction; null if it is constant
         * @param luminance of its largest intensity, as for {@link #addPoint(Vec3, double)}
         */
        public Builder addPoint(Vec3 position, IntensityProfile profile, double luminance) {
            double[] own = profile == null ? new double[0] : profile.parameters();
            double[] key = Arrays.copyOf(new double[] {position.x(), position.y(), position.z()}, 3 + own.length);
            System.arraycopy(own, 0, key, 3, own.length);
            entries.add(new Entry(null, position, profile, luminance, key));
            return this;
        }

        /** Builds the sampler of these lights. */
        public LightSampler build() {
            return build(() -> {});
        }

        /**
         * Builds the sampler of these lights, and can be cancelled.
         *
         * @param poll called regularly; what it throws ends the building
         */
        public LightSampler build(Runnable poll) {
            return new LightSampler(entries, poll);
        }
    }
}
