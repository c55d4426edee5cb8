package enlightenment.importer.gltf;

import java.math.BigDecimal;
import java.util.List;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * A property of a node at frames of the film, between which its numbers change linearly.
 *
 * @param frames the frames, increasing
 * @param values of each of them its numbers
 */
record SampledProperty(int[] frames, List<double[]> values) {
    /** At the frames of the keys where that is exact, else at all frames. */
    static SampledProperty of(KeyframeSampler keys, NodeMotions motions, boolean mayBeKeysAlone) {
        double rate = motions.framesPerSecond();
        int[] frames = mayBeKeysAlone && keys.isLinearByFrames(rate)
                ? IntStream.range(0, keys.times().length)
                        .map(i -> (int) StrictMath.rint(keys.times()[i] * rate))
                        .toArray()
                : IntStream.rangeClosed(0, motions.frames()).toArray();
        return new SampledProperty(
                frames,
                IntStream.of(frames).mapToObj(f -> keys.at(motions.time(f))).toList());
    }

    /** How many numbers {@link #of} makes at most. */
    static long most(KeyframeSampler keys, NodeMotions motions) {
        return 4 * Math.max(keys.times().length, motions.frames() + 1L);
    }

    /** The keys of one of the numbers, without those that the ones beside them say; a single one if it does not change. */
    NavigableMap<Integer, BigDecimal> track(int number) {
        NavigableMap<Integer, BigDecimal> track = new TreeMap<>();
        int last = frames.length - 1;
        for (int i = 0; i <= last; i++) {
            double v = values.get(i)[number];
            boolean isLikeBefore = i > 0 && values.get(i - 1)[number] == v;
            boolean isLikeAfter = i == last || values.get(i + 1)[number] == v;
            if (!(isLikeBefore && isLikeAfter)) {
                track.put(frames[i], BigDecimal.valueOf(v));
            }
        }
        return track;
    }
}
